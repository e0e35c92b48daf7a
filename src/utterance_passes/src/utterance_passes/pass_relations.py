"""Lets a tree pass look only at sentences in which it can find something: most sentences are short."""

from functools import wraps
from typing import Callable

from utterance_passes.tree import DependencyTree
from utterance_passes.vocabulary import Vocabulary

#: A tree pass: takes a tree and returns another one, or the same.
TreeRun = Callable[[DependencyTree, Vocabulary], DependencyTree]


def only_with(*relations: str) -> Callable[[TreeRun], TreeRun]:
    """Run a pass only on sentences with a word of one of these relations; others stay as they are.

    Args:
        relations: to the head, with or without subtype: "acl", "acl:relcl"
    """
    needed = frozenset(relations)

    def gated(run: TreeRun) -> TreeRun:
        @wraps(run)
        def run_if_possible(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
            return tree if needed.isdisjoint(tree.relations) else run(tree, vocabulary)

        return run_if_possible

    return gated
