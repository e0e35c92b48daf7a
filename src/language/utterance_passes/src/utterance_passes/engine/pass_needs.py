"""Lets a tree pass look only at sentences in which it can find something: most sentences are short."""

from functools import wraps
from typing import AbstractSet, Callable, Iterable

from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.vocabulary import Vocabulary

#: A tree pass: takes a tree and returns another one, or the same.
TreeRun = Callable[[DependencyTree, Vocabulary], DependencyTree]
#: Tells what a tree has of that which a pass needs.
_Has = Callable[[DependencyTree], AbstractSet[str]]
_Gate = Callable[[TreeRun], TreeRun]


def only_with(relations: Iterable[str]) -> _Gate:
    """Run a pass only on sentences with a word of one of these relations, with or without subtype ("acl:relcl")."""
    return _only_with(relations, lambda tree: tree.relations)


def only_with_forms(forms: Iterable[str]) -> _Gate:
    """Run a pass only on sentences with one of these words, as they are written in lower case."""
    return _only_with(forms, lambda tree: tree.forms)


def only_with_lemmas(lemmas: Iterable[str]) -> _Gate:
    """Run a pass only on sentences with one of these words in any form; they are in lower case."""
    return _only_with(lemmas, lambda tree: tree.lemmas)


def _only_with(wanted: Iterable[str], has: _Has) -> _Gate:
    needed = frozenset(wanted)

    def gated(run: TreeRun) -> TreeRun:
        @wraps(run)
        def run_if_possible(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
            return tree if needed.isdisjoint(has(tree)) else run(tree, vocabulary)

        return run_if_possible

    return gated
