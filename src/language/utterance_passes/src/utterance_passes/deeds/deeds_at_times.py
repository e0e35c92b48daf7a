"""Marks the times at which to do something: "turn *at five*"."""

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.phrases.times import find_times
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.tree_edits import mark_times
from utterance_passes.trees.vocabulary import Verbs, Vocabulary


@tree_pass(
    Kind.MEANING,
    Example("turn|VERB|0|root at|ADP|3|case five|NUM|1|obl", ("at five: says when",), Verbs(frozenset(["turn"]))),
)
def times(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Mark the phrases that say when to do something: "turn *at five*"."""
    return mark_times(tree, find_times(tree))
