"""Sets aside that a turn leaves the robot where it is: "turn *on the spot*"."""

from typing import FrozenSet

from utterance_passes.engine.pass_needs import only_with_forms
from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import ASIDE, DependencyTree
from utterance_passes.trees.tree_edits import set_aside
from utterance_passes.trees.vocabulary import Verbs, Vocabulary, is_verb
from word_classes import word_class

_PHRASES = frozenset(tuple(phrase.split()) for phrase in word_class("places_of_turns"))


@tree_pass(
    Kind.MEANING,
    Example(
        "spin|VERB|0|root in|ADP|3|case place|NOUN|1|obl",
        ("in: case(place) -> discourse:aside(spin)", "place: obl(spin) -> discourse:aside(spin)"),
        Verbs(frozenset(["spin"])),
    ),
    assigns=[ASIDE, "root", "parataxis"],
)
@only_with_forms(frozenset(phrase[-1] for phrase in _PHRASES))
def places_of_turns(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Set aside that a turn leaves the robot where it is: "turn on the spot" is about no device."""
    positions: FrozenSet[int] = frozenset().union(
        *(_place(tree, verb.index) for verb in tree.words if is_verb(vocabulary, verb))
    )
    return set_aside(tree, positions, ASIDE, lambda word: is_verb(vocabulary, word)) if positions else tree


def _place(tree: DependencyTree, verb: int) -> FrozenSet[int]:
    """Return the words behind a verb that say where it turns; none if they go on, "turn on the spot light"."""
    forms = [word.said for word in tree.words]
    for first in range(verb, len(forms)):
        for phrase in _PHRASES:
            last = first + len(phrase)
            if tuple(forms[first:last]) == phrase and tree.word(last).deprel not in ("compound", "amod"):
                found = frozenset(range(first + 1, last + 1))
                # "Put the cup in place" moves the cup.
                moved = [child for child in tree.children(verb) if child.deprel == "obj" and child.index not in found]
                return frozenset() if moved else found
    return frozenset()
