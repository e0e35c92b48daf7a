"""Corrects parses that a command cannot mean: "go up" before "to", "can" without a verb."""

from typing import FrozenSet, Iterable, List

from utterance_passes.pass_needs import only_with
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_CHANGED_STATES = word_class("changed_states")
_PARTICLES_ON_THE_WAY = word_class("particles_on_the_way")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_TO_PREPOSITIONS = word_class("to_prepositions")


@only_with("compound:prt")
def with_particles_on_the_way(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn a particle right before "to" into an adverb: "go up to the desk" does not mean "go up"."""
    edit = TreeEdit(tree)
    for word, following in zip(tree.words, tree.words[1:]):
        is_to = following.form.lower() in _TO_PREPOSITIONS and following.deprel == "case"
        if word.deprel == "compound:prt" and word.form.lower() in _PARTICLES_ON_THE_WAY and is_to:
            edit.relabel(word.index, "advmod")
    return edit.tree()


@only_with("compound:prt", "xcomp")
def with_places_of_devices(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a place after "on", "off" or a changed state to the object before it: "turn *the lights* off *in the
    bedroom*"."""
    edit = TreeEdit(tree)
    for particle in tree.words:
        is_switch = particle.deprel == "compound:prt" and particle.form.lower() in ("on", "off")
        # "Make the lights brighter in the hall": the parser may attach the place to the state.
        is_state = particle.deprel == "xcomp" and particle.form.lower() in _CHANGED_STATES
        if not is_switch and not is_state:
            continue
        objects = [c for c in tree.children(particle.head) if c.deprel == "obj" and c.index < particle.index]
        below = tree.children(particle.index) if is_state else ()
        places = _phrases_at(tree, (*tree.children(particle.head), *below), particle.index + 1)
        for place in places[:1] if objects else ():
            edit.rehang(place.index, objects[0].index, "nmod")
    return edit.tree()


def _phrases_at(
    tree: DependencyTree, words: Iterable[Word], position: int, prepositions: FrozenSet[str] = _PLACE_PREPOSITIONS
) -> List[Word]:
    """Return the words that head a phrase of a verb at a position, by default a phrase of place."""
    if position > len(tree.words) or tree.word(position).form.lower() not in prepositions:
        return []
    return [word for word in words if word.deprel == "obl" and min(tree.subtree(word.index)) == position]
