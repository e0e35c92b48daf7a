"""Tells particles and prepositions apart: "go *up* to the desk", "*ahead of* Bob"."""

from typing import FrozenSet, Iterable, List

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.tree_patterns import Rehang, Sought, TreePattern, rehung
from utterance_passes.trees.vocabulary import Vocabulary
from word_classes import word_class

_PARTICLES_ON_THE_WAY = word_class("verb_particles")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_TO_PREPOSITIONS = word_class("to_prepositions")
_ADVERB, _PREPOSITION = "ahead", "of"


_UP_TO = TreePattern(
    Sought("particle", deprel={"compound:prt"}, said=_PARTICLES_ON_THE_WAY),
    Sought("to", "particle", ".", deprel={"case"}, said=_TO_PREPOSITIONS),
)


@tree_pass(
    Kind.MEANING,
    Example(
        "go|VERB|0|root up|ADP|1|compound:prt to|ADP|4|case Bob|PROPN|1|obl",
        ("up: compound:prt(go) -> advmod(go)",),
    ),
    requires=["compound:prt"],
    assigns=["advmod"],
)
def particles_on_the_way(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn a particle right before "to" into an adverb: "go up to the desk" does not mean "go up"."""
    return rehung(tree, _UP_TO, Rehang("particle", "advmod"))


@tree_pass(
    Kind.MEANING,
    Example(
        "turn|VERB|0|root lights|NOUN|1|obj off|ADP|1|compound:prt in|ADP|5|case rooms|NOUN|1|obl",
        ("rooms: obl(turn) -> nmod(lights)",),
    ),
    requires=["compound:prt", "xcomp"],
    assigns=["nmod"],
)
def places_of_devices(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a place after "on", "off" or a changed state to the object before it: "turn *the lights* off *in the
    bedroom*"."""
    edit = TreeEdit(tree)
    for particle in tree.words:
        is_switch = particle.deprel == "compound:prt" and particle.said in ("on", "off")
        # "Make the lights brighter in the hall": the parser may attach the place to the state.
        is_state = particle.deprel == "xcomp" and particle.xpos in ("JJR", "RBR")
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
    if position > len(tree.words) or tree.word(position).said not in prepositions:
        return []
    return [word for word in words if word.deprel == "obl" and tree.phrase_start(word.index) == position]


@tree_pass(
    Kind.MEANING,
    Example(
        "open|VERB|0|root doors|NOUN|1|obj ahead|ADV|1|advmod of|ADP|5|case Bob|PROPN|3|obl",
        (
            "ahead: advmod(open) ADV/ahead -> case(Bob) ADP/ahead",
            "of: case(Bob) -> fixed(ahead)",
            "Bob: obl(ahead) -> obl(open)",
        ),
    ),
    requires=["case"],
    assigns=["obl", "case", "fixed"],
)
def ahead_of(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn "ahead of" into one preposition.

    It belongs to the noun behind it, which hangs on what "ahead" hung on.
    """
    edit = TreeEdit(tree)
    for word, following in zip(tree.words, tree.words[1:]):
        is_pair = word.said == _ADVERB and following.said == _PREPOSITION
        noun = tree.governor(following) if is_pair and following.head else None
        if noun is None or following.deprel != "case" or noun.index < following.index or word.deprel == "case":
            continue
        if noun.head == word.index:
            edit.rehang(noun.index, word.head, "obl" if word.deprel == "advmod" else word.deprel)
        for child in tree.children(word.index):
            if child.index != noun.index:
                edit.rehang(child.index, noun.index)
        edit.make_preposition(word.index, noun.index)
        edit.rehang(following.index, word.index, "fixed")
    return edit.tree()
