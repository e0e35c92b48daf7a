"""Finds conditions inside what is to be found out: "see if it is hot *when I say so*"."""

from typing import FrozenSet

from utterance_passes.trees.tree import DependencyTree
from word_classes import word_class

_CONDITIONS = word_class("conditions")


def inner_condition(tree: DependencyTree, positions: FrozenSet[int]) -> FrozenSet[int]:
    """Return the words of a condition inside the thing to find out: "see if it is hot *when I say so*".

    Args:
        tree: the sentence
        positions: words of the thing to find out, whichever element they fill
    """
    for index in sorted(positions):
        word = tree.word(index)
        marks = {child.said for child in tree.children(index) if child.deprel in ("mark", "advmod")}
        if word.deprel.startswith("advcl") and word.head in positions and marks & (_CONDITIONS - {"if"}):
            return tree.subtree(index)
    return frozenset()
