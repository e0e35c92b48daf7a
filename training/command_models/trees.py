"""Dependency trees built bottom-up, and their flattening into CoNLL-U sentences."""

from dataclasses import dataclass, replace
from typing import List, Tuple

from .conllu import Sentence, Span, Word


@dataclass(frozen=True)
class Node:
    """A word with its dependants on both sides, in written order.

    ``glued``: the word continues the multi-word token of the word before it (the clitics 's and n't).
    ``tight``: no space before it (punctuation).
    """

    form: str
    lemma: str
    upos: str
    xpos: str
    feats: str = "_"
    rel: str = "root"
    left: Tuple["Node", ...] = ()
    right: Tuple["Node", ...] = ()
    glued: bool = False
    tight: bool = False

    def pre(self, rel: str, *children: "Node") -> "Node":
        """Put dependants before all others of this word, in the given order."""
        return replace(self, left=tuple(replace(child, rel=rel) for child in children) + self.left)

    def near(self, rel: str, child: "Node") -> "Node":
        """This word with one dependant directly before it, after its other left dependants."""
        return replace(self, left=self.left + (replace(child, rel=rel),))

    def post(self, rel: str, *children: "Node") -> "Node":
        """This word with dependants put after everything it has."""
        return replace(self, right=self.right + tuple(replace(child, rel=rel) for child in children))

    def first(self, rel: str, child: "Node") -> "Node":
        """This word with one dependant directly after it, before its other right dependants."""
        return replace(self, right=(replace(child, rel=rel),) + self.right)

    def has(self, rel: str) -> bool:
        """Whether a direct dependant has this relation."""
        return any(child.rel == rel for child in self.left + self.right)

    def parts(self) -> List["Node"]:
        """Return the words of the subtree in written order."""
        found: List[Node] = []
        for child in self.left:
            found += child.parts()
        found.append(self)
        for child in self.right:
            found += child.parts()
        return found


def flatten(root: Node, comments: Tuple[str, ...] = ()) -> Sentence:
    """Return a tree as a sentence, with numbered words, multi-word tokens and SpaceAfter."""
    order: List[Tuple[Node, int]] = []

    def walk(node: Node, governor: List[int]) -> None:
        # The number of the governor is known only after its left side is numbered, hence the list of one slot.
        own: List[int] = [0]
        for child in node.left:
            walk(child, own)
        slots.append((node, governor))
        own[0] = len(slots)
        for child in node.right:
            walk(child, own)

    slots: List[Tuple[Node, List[int]]] = []
    walk(root, [0])
    order = [(node, governor[0]) for node, governor in slots]
    words: List[Word] = []
    spans: List[Span] = []
    for at, (node, head) in enumerate(order):
        after = order[at + 1][0] if at + 1 < len(order) else None
        misc = "SpaceAfter=No" if after is not None and after.tight else "_"
        inside = node.glued or (after is not None and after.glued)
        words.append(
            Word(
                node.form,
                node.lemma,
                node.upos,
                node.xpos,
                node.feats,
                head,
                "root" if head == 0 else node.rel,
                "_" if inside else misc,
            )
        )
        if node.glued:
            start = spans[-1].first if spans and spans[-1].last == at else at
            form = "".join(word.form for word in words[start - 1 :])
            if spans and spans[-1].last == at:
                spans.pop()
            spans.append(Span(start, at + 1, form, misc))
    return Sentence(tuple(words), tuple(spans), comments)
