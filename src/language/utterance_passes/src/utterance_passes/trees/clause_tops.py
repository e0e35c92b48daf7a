"""Finds the word of a clause that governs all of its words."""

from typing import Dict, Set

from utterance_passes.trees.tree import DependencyTree
from word_classes import word_class

_LEADING_VERBS = word_class("leading_verbs")


def top_of(tree: DependencyTree, verb: int) -> int:
    """Return the top word of a clause: the predicate of a copula, otherwise the verb itself."""
    word = tree.word(verb)
    return word.head if word.deprel == "cop" else verb


def tops_of(tree: DependencyTree, verbs: Set[int]) -> Dict[int, int]:
    """Return the top word of the clause of each verb; no two have the same, so that each clause has words.

    In "go and look and open the door", "go" leads to the first of both deeds only.
    """
    tops: Dict[int, int] = {}
    for verb in sorted(verbs):
        top = top_of(tree, verb)
        possible = (_above_serial(tree, top, verbs), top, verb)
        tops[verb] = next(one for one in possible if one == verb or one not in tops.values())
    return tops


def _above_serial(tree: DependencyTree, top: int, verbs: Set[int]) -> int:
    """Return the verb that leads a clause inside a sentence: "the bell rings. *Go* and open the door"."""
    verb = tree.governor(tree.word(top)) if tree.word(top).deprel == "conj" else tree.word(top)
    is_inside = verb.deprel in ("conj", "parataxis", "list") and verb.index not in verbs
    return verb.index if is_inside and verb.lemma.lower() in _LEADING_VERBS else top
