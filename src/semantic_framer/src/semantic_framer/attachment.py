"""Which phrase a prepositional phrase belongs to, where the parser hung it on the verb and no element asks for it."""

from typing import AbstractSet, FrozenSet, Tuple

from semantic_framer.sentence import Sentence

#: A phrase with one of these says where a thing is. If it fills no element of the unit, it belongs to the noun that it
#: stands behind, even where the parser hung it on the verb: "bring the mug on the table".
OF_PLACE = frozenset(
    "on in at near under behind beside beneath below above over inside outside between against by next close around "
    "of".split()
)
#: Prepositions that tell which thing or person is meant only right behind its name: "the guy with the blue jacket".
_OF_A_THING = frozenset(["with", "without"])
_PLACE_ADVERBS = frozenset(["here", "there", "upstairs", "downstairs", "outside", "inside"])
#: Adverbs in front of a preposition that make it more precise: "close to the door", "over to the sofa".
_OF_A_PREPOSITION = frozenset(
    "close closer nearer over right straight directly back up down out along all just near next".split()
)
#: Sides of a thing where "of" follows, and directions where it does not: "to the left", "to the left of the table".
_SIDES = frozenset(["left", "right", "front", "back", "top", "bottom"])
#: "Straight ahead", "directly forward" are one direction.
_STRAIGHT = frozenset(["straight", "directly", "right"])
_ONWARD = frozenset(["ahead", "forward", "forwards", "on", "onward"])
#: A direction that fills nothing is not the one that is meant where none is said.
_DIRECTIONS = frozenset(
    "left right north south east west northeast northwest southeast southwest northward northwards southward southwards "
    "eastward eastwards westward westwards up upward upwards down downward downwards sideways sideward sidewards diagonally "
    "back backward backwards forward forwards ahead around clockwise counterclockwise anticlockwise".split()
)
_OF_A_NUMBER = frozenset("by about almost around roughly approximately nearly exactly precisely another only some".split())


def preposition_of(step: str) -> str:
    """Return the preposition of a relation ("prep_to", "obl:to", "prep_next_to"); empty for none."""
    if not step.startswith(("prep_", "obl:")):
        return ""
    return step.split("_", 1)[1] if step.startswith("prep_") else step.split(":", 1)[1]


def tells_which(sentence: Sentence, index: int, head: int, is_described: bool) -> bool:
    """Whether a phrase that hangs on a verb tells which thing the noun in front of it is.

    Args:
        sentence: the sentence
        index: head of the phrase
        head: the noun
        is_described: whether the verb is about the noun alone, so that "with" belongs to it: "follow the guy with the
            hat"; "grab the cup with the tongs" would be done without them
    """
    word = sentence.word(index)
    if word.deprel == "advmod":
        return word.form.lower() in _PLACE_ADVERBS
    prepositions = [child.form.lower() for child in sentence.children(index) if child.deprel == "case"]
    if word.upos == "ADV" or not prepositions or min(sentence.subtree(index)) != _first_case(sentence, index):
        return False
    if prepositions[0] == "to" and word.form.lower() in ("left", "right"):
        return True  # "the door to your left"
    is_thing = word.upos != "PRON" and not any(child.deprel == "case" for child in sentence.children(head))
    return prepositions[0] in OF_PLACE or (is_described and is_thing and prepositions[0] in _OF_A_THING)


def _first_case(sentence: Sentence, index: int) -> int:
    return min(child.index for child in sentence.children(index) if child.deprel == "case")


def is_side_of_something(sentence: Sentence, index: int) -> bool:
    """Whether a word is a side of a thing, and no direction: "the left of the table"."""
    return sentence.word(index).form.lower() in _SIDES and any(
        child.deprel.startswith("nmod")
        and any(inner.deprel == "case" and inner.form.lower() == "of" for inner in sentence.children(child.index))
        for child in sentence.children(index)
    )


def places_before(sentence: Sentence, head: int) -> Tuple[str, ...]:
    """Return the prepositions of the phrases of place that stand before a phrase, the nearest first: "on" of the couch
    in "the box on the table on the couch".
    """
    own = [child.index for child in sentence.children(head) if child.deprel == "case"]
    before = sentence.tree.words[: own[0] - 1] if own else ()
    return tuple(
        word.form.lower()
        for word in reversed(before)
        if word.deprel == "case" and word.form.lower() in OF_PLACE and word.head < own[0]
    )


def words_before(sentence: Sentence, verb: int, first: int, free: FrozenSet[int]) -> FrozenSet[int]:
    """Return the adverb right in front of a preposition that makes it more precise: "close" of "close to the door"."""
    before = first - 1
    if before <= verb or before not in free or sentence.word(first).deprel != "case":
        return frozenset()
    word = sentence.word(before)
    is_precise = word.deprel == "advmod" and word.form.lower() in _OF_A_PREPOSITION
    return frozenset([before]) if is_precise else frozenset()


def words_before_amount(sentence: Sentence, first: int) -> FrozenSet[int]:
    """Return the words in front of a number that belong to it: "by almost" of "by almost 90 degrees"."""
    found = []
    position = first - 1
    while position > 0 and sentence.word(position).form.lower() in _OF_A_NUMBER:
        found.append(position)
        position -= 1
    return frozenset(found)


def is_direction(sentence: Sentence, index: int) -> bool:
    """Whether a word says in which direction something is done: "east", "left"."""
    return sentence.word(index).form.lower() in _DIRECTIONS


def is_of_one_direction(sentence: Sentence, index: int, used: AbstractSet[int]) -> bool:
    """Whether a word says with a used word beside it where ahead is: "straight ahead"."""
    beside = {index - 1: (_STRAIGHT, _ONWARD), index + 1: (_ONWARD, _STRAIGHT)}
    return any(
        other in used and sentence.word(other).form.lower() in its and sentence.word(index).form.lower() in own
        for other, (its, own) in beside.items()
    )
