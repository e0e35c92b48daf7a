"""Draws a dependency tree as arcs above the words."""

from dataclasses import dataclass
from typing import Dict, List, Sequence, Tuple

from web_console.picture import Picture, Shape

#: Widths of characters of the fonts of the page, in pixels.
_FORM_PX = 9.2
_LABEL_PX = 7.0
_GAP_PX = 22
_LEVEL_PX = 30
_CORNER_PX = 9
_MARGIN_PX = 14
_BELOW_PX = 46
_LONGEST_FORM = 24
#: Words of a sentence that are drawn; the rest is text in the trace.
MOST_WORDS = 80
#: Relations that fill frame elements, those that describe, and those of grammar only, have a colour each.
_CORE = frozenset("nsubj obj iobj obl ccomp xcomp csubj advcl".split())
_MODIFIERS = frozenset("amod advmod nummod nmod acl appos compound flat".split())


@dataclass(frozen=True)
class ParsedWord:
    """A word of a dependency tree: its index from 1, its head (0 for the root), and its relation to the head."""

    index: int
    form: str
    tag: str
    head: int
    relation: str


def levels(words: Sequence[ParsedWord]) -> List[Tuple[ParsedWord, int]]:
    """Return the words with a head and the level of the arc of each, from 1; short arcs lie below long ones."""
    placed: List[Tuple[int, int, int]] = []
    found = []
    for word in sorted(
        (word for word in words if word.head), key=lambda word: (abs(word.head - word.index), word.index)
    ):
        left, right = sorted((word.index, word.head))
        level = 1 + max((height for low, high, height in placed if low < right and left < high), default=0)
        placed.append((left, right, level))
        found.append((word, level))
    return found


def draw_arcs(words: Sequence[ParsedWord]) -> Picture:
    """Draw a tree; each arc goes from the head to the dependent and carries its relation. Punctuation has no arc."""
    words = words[:MOST_WORDS]
    known = {word.index for word in words}
    arcs = levels([word for word in words if word.head in known and word.relation != "punct"])
    centres, width = _centres(words)
    base = _MARGIN_PX + _LEVEL_PX * max((level for _, level in arcs), default=1)
    shapes: List[Shape] = []
    for word, level in sorted(arcs, key=lambda pair: -pair[1]):
        shapes += _arc(word, base - _LEVEL_PX * level, base, centres)
    for word in words:
        x = centres[word.index]
        kind = "word root" if word.head == 0 else "word"
        middle = ("text-anchor", "middle")
        shapes.append(
            Shape("text", (("class", kind), ("x", _px(x)), ("y", _px(base + 18)), middle), _shortened(word.form))
        )
        shapes.append(Shape("text", (("class", "tag"), ("x", _px(x)), ("y", _px(base + 34)), middle), word.tag))
    return Picture(width, base + _BELOW_PX, tuple(shapes))


def tell_arcs(words: Sequence[ParsedWord]) -> str:
    """Say a tree in words, for those who do not see it: "Turn is the root; left: advmod of Turn"."""
    forms = {word.index: word.form for word in words}
    return "; ".join(
        f"{word.form} is the root" if word.head == 0 else f"{word.form}: {word.relation} of {forms.get(word.head, '?')}"
        for word in words[:MOST_WORDS]
    )


def _arc(word: ParsedWord, top: int, base: int, centres: Dict[int, float]) -> List[Shape]:
    # Arcs that meet in a word leave it side by side.
    side = 5.0 if word.head < word.index else -5.0
    start, end = centres[word.head] + side, centres[word.index]
    kind = relation_kind(word.relation)
    corner = min(_CORNER_PX, abs(end - start) / 2) * (1 if end > start else -1)
    drop = abs(corner)
    path = (
        f"M{_px(start)} {base}V{_px(top + drop)}Q{_px(start)} {top} {_px(start + corner)} {top}"
        f"H{_px(end - corner)}Q{_px(end)} {top} {_px(end)} {_px(top + drop)}V{base - 6}"
    )
    tip = f"M{_px(end - 4)} {base - 8}L{_px(end + 4)} {base - 8}L{_px(end)} {base}Z"
    middle = (start + end) / 2
    back = 6.0 + _LABEL_PX * len(word.relation)
    return [
        Shape("path", (("class", f"arc {kind}"), ("d", path))),
        Shape("path", (("class", f"tip {kind}"), ("d", tip))),
        Shape(
            "rect",
            (
                ("class", "label-ground"),
                ("x", _px(middle - back / 2)),
                ("y", _px(top - 8)),
                ("width", _px(back)),
                ("height", "16"),
                ("rx", "4"),
            ),
        ),
        Shape(
            "text",
            (("class", f"label {kind}"), ("x", _px(middle)), ("y", _px(top + 4)), ("text-anchor", "middle")),
            word.relation,
        ),
    ]


def relation_kind(relation: str) -> str:
    """Return the class of a relation: core, modifier or grammar."""
    base = relation.partition(":")[0]
    return "core" if base in _CORE else "modifier" if base in _MODIFIERS else "grammar"


def _centres(words: Sequence[ParsedWord]) -> Tuple[Dict[int, float], int]:
    """Return the middle of each word, and the width of all."""
    centres: Dict[int, float] = {}
    at = float(_MARGIN_PX)
    for position, word in enumerate(words):
        half = max(_FORM_PX * len(_shortened(word.form)), _LABEL_PX * len(word.tag), 20.0) / 2
        middle = at + half
        if position:
            # The label of an arc between neighbours has to fit between their middles.
            left = words[position - 1]
            labels = [two.relation for two, one in ((word, left), (left, word)) if two.head == one.index]
            middle = max([middle] + [centres[left.index] + _LABEL_PX * len(label) + 46 for label in labels])
        centres[word.index] = middle
        at = middle + half + _GAP_PX
    return centres, int(at - _GAP_PX + _MARGIN_PX)


def _shortened(form: str) -> str:
    return form if len(form) <= _LONGEST_FORM else form[: _LONGEST_FORM - 1] + "…"


def _px(value: float) -> str:
    return f"{value:.1f}".rstrip("0").rstrip(".")
