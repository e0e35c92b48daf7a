"""Draws a dependency tree as arcs: in a terminal and as SVG."""

from typing import List, Tuple
from xml.sax.saxutils import escape

from utterance_passes.tree import DependencyTree, Word


def _levels(tree: DependencyTree) -> List[Tuple[Word, int]]:
    """Return the words with a head and the level of the arc of each, from 1; short arcs lie below long ones."""
    placed: List[Tuple[int, int, int]] = []
    found = []
    for word in sorted(
        (word for word in tree.words if word.head), key=lambda word: (abs(word.head - word.index), word.index)
    ):
        left, right = sorted((word.index, word.head))
        level = 1 + max((height for low, high, height in placed if low < right and left < high), default=0)
        placed.append((left, right, level))
        found.append((word, level))
    return found


def draw_arcs(tree: DependencyTree) -> str:
    """Return the tree for a terminal: one line for each level of arcs, the words below, and an arrow at each
    dependent."""
    widths = [max(len(word.form), len(word.deprel) + 4) + 2 for word in tree.words]
    centres, at = [], 0
    for width, word in zip(widths, tree.words):
        centres.append(at + len(word.form) // 2)
        at += width
    levels = _levels(tree)
    height = max((level for _, level in levels), default=0)
    rows = [[" "] * at for _ in range(height + 1)]
    for word, level in sorted(levels, key=lambda pair: -pair[1]):
        row = rows[height - level]
        start, end = centres[word.index - 1], centres[word.head - 1]
        left, right = sorted((start, end))
        for column in range(left + 1, right):
            row[column] = "─"
        row[left], row[right] = "╭" if row[left] == " " else "┬", "╮" if row[right] == " " else "┬"
        label = word.deprel[: max(0, right - left - 1)]
        begin = left + 1 + (right - left - 1 - len(label)) // 2
        row[begin : begin + len(label)] = list(label)
        for below in rows[height - level + 1 :]:
            for column in (start, end):
                if below[column] == " ":
                    below[column] = "│"
        rows[height][start] = "▼"
    for word in tree.words:
        if word.head == 0:
            rows[height][centres[word.index - 1]] = "●"
    words = "".join(word.form.ljust(width) for word, width in zip(tree.words, widths))
    tags = "".join(word.upos.ljust(width) for word, width in zip(tree.words, widths))
    return "\n".join("".join(row).rstrip() for row in rows + [list(words), list(tags)])


def svg_arcs(tree: DependencyTree) -> str:
    """Return the tree as an SVG document."""
    pitch, step = 110, 34
    levels = _levels(tree)
    base = 40 + step * max((level for _, level in levels), default=1)
    width, height = pitch * len(tree.words), base + 60
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif">',
        (
            '<defs><marker id="tip" markerWidth="8" markerHeight="8" refX="4" refY="4" orient="auto">'
            '<path d="M0,0 L8,4 L0,8 z"/></marker></defs>'
        ),
    ]
    for word, level in levels:
        start, end = (pitch * index - pitch // 2 for index in (word.head, word.index))
        top = base - step * level
        parts.append(
            f'<path d="M{start},{base} L{start},{top} L{end},{top} L{end},{base - 4}"'
            ' fill="none" stroke="#456" marker-end="url(#tip)"/>'
        )
        parts.append(
            f'<text x="{(start + end) // 2}" y="{top - 4}" font-size="12" text-anchor="middle">'
            f"{escape(word.deprel)}</text>"
        )
    for word in tree.words:
        x = pitch * word.index - pitch // 2
        weight = ' font-weight="bold"' if word.head == 0 else ""
        parts.append(
            f'<text x="{x}" y="{base + 22}" font-size="16" text-anchor="middle"{weight}>{escape(word.form)}</text>'
        )
        parts.append(
            f'<text x="{x}" y="{base + 40}" font-size="11" fill="#777" text-anchor="middle">{escape(word.upos)}</text>'
        )
    return "\n".join(parts + ["</svg>"]) + "\n"
