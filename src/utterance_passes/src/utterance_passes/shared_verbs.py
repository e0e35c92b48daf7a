"""Gives one verb to two phrases: "go to the office and then to the kitchen", "turn left then right"."""

from typing import Set

from utterance_passes.clauses import find_clauses, has_case, shares_a_verb
from utterance_passes.tree import DependencyTree
from utterance_passes.tree_edits import TreeEdit, mark_sharing_a_verb
from utterance_passes.vocabulary import Vocabulary


def expand_shared_verbs(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Attach the second of two phrases that share a verb to the verb, like the first, and mark it: ``find_clauses``
    turns it into a separate clause.
    """
    edit = TreeEdit(tree)
    sharing: Set[int] = set()
    for clause in find_clauses(tree, vocabulary):
        for word in tree.children(clause.verb):
            if shares_a_verb(tree, word):
                sharing.add(word.index)
                if has_case(tree, word):
                    edit.relabel(word.index, "obl")
                else:
                    edit.retag(word.index, "ADV")
                    edit.relabel(word.index, "advmod")
    return mark_sharing_a_verb(edit.tree(), frozenset(sharing))
