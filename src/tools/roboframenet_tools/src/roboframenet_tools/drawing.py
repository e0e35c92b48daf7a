"""Draws a dependency tree as arcs: in a terminal and as SVG."""

from typing import List

from utterance_passes.trees.tree import DependencyTree
from web_console.arcs import ParsedWord, levels
from web_console.arcs import draw_arcs as draw_arcs_of
from web_console.picture import as_svg

#: The colours of the page.
_STYLE = (
    "text { font: 16px sans-serif } .label { font-size: 11.5px } .tag { font-size: 10.5px; fill: #777 } "
    ".root { font-weight: bold } .arc { fill: none; stroke: #456; stroke-width: 1.5 } .label-ground { fill: white }"
)


def draw_arcs(tree: DependencyTree) -> str:
    """Return the tree for a terminal: one line for each level of arcs, the words below, and an arrow at each
    dependent."""
    widths = [max(len(word.form), len(word.deprel) + 4) + 2 for word in tree.words]
    centres, at = [], 0
    for width, word in zip(widths, tree.words):
        centres.append(at + len(word.form) // 2)
        at += width
    arcs = levels(_words(tree))
    height = max((level for _, level in arcs), default=0)
    rows = [[" "] * at for _ in range(height + 1)]
    for arc, level in sorted(arcs, key=lambda pair: -pair[1]):
        row = rows[height - level]
        start, end = centres[arc.index - 1], centres[arc.head - 1]
        left, right = sorted((start, end))
        for column in range(left + 1, right):
            row[column] = "─"
        row[left], row[right] = "╭" if row[left] == " " else "┬", "╮" if row[right] == " " else "┬"
        label = arc.relation[: max(0, right - left - 1)]
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
    """Return the tree as an SVG document, drawn as on the page of ``web_console``."""
    return as_svg(draw_arcs_of(_words(tree)), style=_STYLE)


def _words(tree: DependencyTree) -> List[ParsedWord]:
    return [ParsedWord(word.index, word.form, word.upos, word.head, word.deprel) for word in tree.words]
