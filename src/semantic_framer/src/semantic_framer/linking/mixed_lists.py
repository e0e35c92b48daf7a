"""Divides a list whose items are handled in different ways: "wash *the plates* and *the shirts*"."""

from typing import FrozenSet, List, Optional, Sequence, Tuple

from semantic_framer.linking.item_lists import listed_items
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from utterance_passes.trees.tree import Word
from utterance_passes.trees.tree_edits import TreeEdit, mark_argument_clusters

_OBJECT = "obj"


def with_items_apart(sentence: Sentence, readings: Sequence[Reading]) -> Optional[Sentence]:
    """Return the sentence with a clause for each item of the lists of things that deeds have; None without such a list.

    Args:
        sentence: the sentence
        readings: the best one of each clause
    """
    edit = TreeEdit(sentence.tree)
    clusters: List[Tuple[int, FrozenSet[int]]] = []
    for reading in readings:
        heads = [_head(sentence, frozenset(item.positions)) for item in listed_items(reading)]
        if not heads or None in heads:
            continue
        first, *others = (head for head in heads if head is not None)
        are_joined = all(head.deprel == "conj" for head in others)
        if first.deprel != _OBJECT or not are_joined or first.head not in reading.verb_positions:
            continue
        for head in others:
            edit.rehang(head.index, first.head, _OBJECT)
        clusters += [(first.head, frozenset([head.index])) for head in (first, *others)]
    if not clusters:
        return None
    return sentence.attached(mark_argument_clusters(edit.tree(), tuple(clusters)))


def _head(sentence: Sentence, positions: FrozenSet[int]) -> Optional[Word]:
    """Return the word of a phrase that is attached outside it; None if there are several."""
    tops = [sentence.word(index) for index in sorted(positions) if sentence.word(index).head not in positions]
    return tops[0] if len(tops) == 1 else None


def are_handled_apart(together: Sequence[Reading], apart: Sequence[Reading]) -> bool:
    """Whether an item of a list alone evokes another frame than the list.

    Args:
        together: the best readings of the clauses with lists
        apart: the best readings of a clause for each item
    """
    return {reading.unit.frame_name for reading in apart} != {reading.unit.frame_name for reading in together}
