"""Attaches phrases that the parser takes for another part of a command: "with your left hand", "from the left"."""

from utterance_passes.pass_needs import only_with
from utterance_passes.tree import DependencyTree
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_GOING = word_class("verbs_of_going")
_OF_WAYS = frozenset(["down", "up"])
_TO_PREPOSITIONS = word_class("to_prepositions")


@only_with("compound:prt")
def with_ways_behind_particles(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a way of what stands behind "down" and before the goal: "drive *down the hall* to the door"."""
    edit = TreeEdit(tree)
    for particle in tree.words:
        verb = tree.word(particle.head) if particle.head else particle
        children = tree.children(verb.index)
        ways = [child for child in children if child.deprel == "obj" and child.index > particle.index]
        is_going = verb.lemma.lower() in _GOING and particle.deprel == "compound:prt"
        if not is_going or particle.form.lower() not in _OF_WAYS or len(ways) != 1:
            continue
        behind = [child for child in children if child.deprel == "obl" and child.index > ways[0].index]
        goals = [
            case for child in behind for case in tree.children(child.index) if case.form.lower() in _TO_PREPOSITIONS
        ]
        if goals and particle.index + 1 == min(tree.subtree(ways[0].index)):
            edit.make_preposition(particle.index, ways[0].index)
            edit.relabel(ways[0].index, "obl")
    return edit.tree()
