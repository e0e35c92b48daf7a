"""Which of the readings that the lexicon allows can be meant."""

from dataclasses import replace
from typing import FrozenSet, Mapping, Tuple

from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import ArgumentForm

from semantic_framer.attachment import is_side_of_something
from semantic_framer.clauses import Clause
from semantic_framer.lexicon import Lexicon
from semantic_framer.matching import Reading, read_clause
from semantic_framer.mending import DEGREES
from semantic_framer.ranking import rank, without_dominated, without_duplicates
from semantic_framer.references import NO_THINGS, PLACES
from semantic_framer.sentence import Sentence
from semantic_framer.values import ElementValue

#: Phrases of their own below a noun: "a left *at the door*".
_PHRASES = frozenset(["nmod", "obl", "acl", "advcl", "appos"])
#: Which of several is meant: "the *second* left".
_CHOOSING = frozenset(["amod", "nummod"])
_SIDES = frozenset(["left", "right"])
INDEFINITE_ARTICLES = frozenset(["a", "an", "some"])


def readings_of(
    sentence: Sentence, clause: Clause, lexicon: Lexicon, frames: Mapping[str, SemanticFrame]
) -> Tuple[Reading, ...]:
    """Return the ways to understand a clause, the best first.

    Those that take words for things which are none are left out, unless their unit lists them ("give me 5"): a number
    for the place of something ("set the thermostat to 20"), a side or a degree for a thing ("take a right", "move a
    bit"), a number that another unit of the verb measures with ("turn one eighty" is half a turn, and no device called
    "one eighty"), and a noun that is part of another unit's verb ("take a look").
    """
    sentence = clause.sentence or sentence
    readings = tuple(
        _with_phrases_left_over(sentence, reading)
        for reading in without_duplicates(read_clause(sentence, clause, lexicon, frames))
    )
    measured = frozenset().union(*(_measured(reading) for reading in readings))
    verbal = frozenset(
        position
        for reading in readings
        for position in reading.verb_positions
        if sentence.word(position).upos in ("NOUN", "PROPN", "NUM")
    )
    kept = tuple(
        reading
        for reading in readings
        if not any(
            value.head_position in verbal - frozenset(reading.verb_positions)
            or (value.head_position in measured - _measured(reading) and not _is_phrase(sentence, value))
            or _is_no_thing(sentence, reading, value, frames[reading.unit.frame_name])
            for value in reading.values
            if value.head_position and value.head_position not in reading.listed
        )
    )
    listed = frozenset().union(*(reading.listed for reading in kept))
    judged = (
        replace(reading, unlikely=_unlikely(sentence, reading, listed, frames[reading.unit.frame_name]))
        for reading in without_dominated(kept)
    )
    return tuple(sorted(judged, key=rank))


def _unlikely(sentence: Sentence, reading: Reading, listed: FrozenSet[int], frame: SemanticFrame) -> int:
    """Count the words that fill an element which they are hardly meant for.

    A word that another unit lists is hardly any thing: a high five can be given like a mug, but is not meant so. "A
    kitchen" is hardly the name of a place, as "the kitchen" is; it tells of what kind the place is.
    """
    names = frozenset(element.name for element in frame.frame_elements if element.framenet == "Name")
    return sum(
        value.head_position in listed - reading.listed
        or (value.name in names and _is_indefinite(sentence, value.head_position))
        for value in reading.values
        if value.head_position
    )


def _is_indefinite(sentence: Sentence, head: int) -> bool:
    return any(
        child.deprel == "det" and child.form.lower() in INDEFINITE_ARTICLES for child in sentence.children(head)
    )


def _measured(reading: Reading) -> FrozenSet[int]:
    return frozenset(position for value in reading.values if value.quantity for position in value.positions)


def _is_phrase(sentence: Sentence, value: ElementValue) -> bool:
    return any(child.deprel == "case" for child in sentence.children(value.head_position))


def _is_no_thing(sentence: Sentence, reading: Reading, value: ElementValue, frame: SemanticFrame) -> bool:
    """Whether a word fills an element that it cannot fill."""
    word = sentence.word(value.head_position)
    names = {element.name: element.framenet for element in frame.frame_elements if element.quantity is None}
    name = names.get(value.name)
    if name is None or value.quantity:
        return False
    if name in PLACES and word.upos == "NUM":
        return any(names.get(other.name) == "Theme" and len(other.positions) > 0 for other in reading.values)
    if word.form.lower() in DEGREES and not any(child.deprel == "nmod" for child in sentence.children(word.index)):
        return True
    is_side = word.form.lower() in _SIDES and not is_side_of_something(sentence, word.index)
    return is_side and word.deprel == "obj" and name not in PLACES | NO_THINGS


def _with_phrases_left_over(sentence: Sentence, reading: Reading) -> Reading:
    """Leave over what hangs below a listed word that alone becomes the argument: "take a left *at the door*"."""
    left_over = set(reading.left_over)
    for value in reading.values:
        relation = next((relation for relation in reading.unit.relations if relation.name == value.name), None)
        if relation is None or not relation.words or relation.argument is not ArgumentForm.HEAD:
            continue
        is_side = value.head.lower() in _SIDES
        whole = sentence.subtree(value.head_position)
        phrases = [
            sentence.subtree(child.index)
            for child in sentence.children(value.head_position)
            if child.deprel.split(":")[0] in (_PHRASES | _CHOOSING if is_side else _PHRASES)
            and child.deprel != "nmod:poss"
        ]
        behind = frozenset(position for position in value.positions if position > max(whole))
        elsewhere = frozenset(
            position for other in reading.values if other is not value for position in other.positions
        )
        said = frozenset(value.positions) & behind.union(*phrases)
        left_over |= {index for index in said - elsewhere if sentence.is_content(index)}
    return replace(reading, left_over=tuple(sorted(left_over)))
