"""Readings that take words for what they are not: a side, a degree or a deed for a thing."""

from typing import Callable, FrozenSet, Tuple

from semantic_framer.attachment import is_direction, is_side_of_something
from semantic_framer.frame_roles import NO_THINGS, PLACES, THEME, THINGS
from semantic_framer.reading import ElementValue, Reading
from semantic_framer.things import is_indefinite, is_no_thing
from semantic_framer.verdict_cases import ClauseCase, Drops, ReadingVerdict
from word_classes import word_class

_DEGREES = word_class("degrees")
_LEFT_AND_RIGHT = word_class("left_and_right")
_SIDES = word_class("sides")


def _of_any_value(judge: Callable[[ClauseCase, Reading, ElementValue, Tuple[Reading, ...]], bool]) -> Drops:
    """Judge a reading by each of its values; words that its unit lists ("give me 5") are what the unit says."""

    def drops(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
        return any(
            judge(case, reading, value, beside)
            for value in reading.values
            if value.head_position and value.head_position not in reading.listed
        )

    return drops


def _is_noun_of_a_verb(case: ClauseCase, reading: Reading, value: ElementValue, beside: Tuple[Reading, ...]) -> bool:
    return any(
        value.head_position in other.verb_positions
        and value.head_position not in reading.verb_positions
        and case.sentence.word(value.head_position).upos in ("NOUN", "PROPN", "NUM")
        for other in beside
    )


def _is_measure_elsewhere(case: ClauseCase, reading: Reading, value: ElementValue, beside: Tuple[Reading, ...]) -> bool:
    is_phrase = any(child.deprel == "case" for child in case.sentence.children(value.head_position))
    return (
        not is_phrase
        and value.head_position not in _measured(reading)
        and any(value.head_position in _measured(other) for other in beside)
    )


def _is_unread_elsewhere(case: ClauseCase, reading: Reading, value: ElementValue, beside: Tuple[Reading, ...]) -> bool:
    unread = {position for other in beside for amount in other.unread for position in amount.positions}
    return not reading.unread and bool(unread & frozenset(value.positions))


def _measured(reading: Reading) -> FrozenSet[int]:
    return frozenset(position for value in reading.values if value.quantity for position in value.positions)


def _roles(case: ClauseCase, reading: Reading, value: ElementValue) -> Tuple[str, ...]:
    """FrameNet's name of the element that a value fills; none for an amount."""
    if value.quantity:
        return ()
    element = case.of.known.frames[reading.unit.frame_name].element(value.name)
    return () if element is None or element.quantity is not None else (element.framenet,)


def _is_numbered_place(case: ClauseCase, reading: Reading, value: ElementValue, beside: Tuple[Reading, ...]) -> bool:
    if not set(_roles(case, reading, value)) & PLACES or case.sentence.word(value.head_position).upos != "NUM":
        return False
    frame = case.of.known.frames[reading.unit.frame_name]
    themes = {
        element.name for element in frame.frame_elements if element.framenet == THEME and element.quantity is None
    }
    return any(other.name in themes and other.positions for other in reading.values)


def _is_degree(case: ClauseCase, reading: Reading, value: ElementValue, beside: Tuple[Reading, ...]) -> bool:
    word = case.sentence.word(value.head_position)
    return (
        bool(_roles(case, reading, value))
        and word.form.lower() in _DEGREES
        and not any(child.deprel == "nmod" for child in case.sentence.children(word.index))
    )


def _is_side(case: ClauseCase, reading: Reading, value: ElementValue, beside: Tuple[Reading, ...]) -> bool:
    word = case.sentence.word(value.head_position)
    roles = set(_roles(case, reading, value))
    if roles & THINGS and is_direction(case.sentence.tree, word.index) and word.form.lower() not in _SIDES:
        return True  # "take a photo northwards", where the parser sees a noun
    is_side = word.form.lower() in _LEFT_AND_RIGHT and not is_side_of_something(case.sentence.tree, word.index)
    return is_side and word.deprel == "obj" and bool(roles) and not roles & (PLACES | NO_THINGS)


def _is_deed(case: ClauseCase, reading: Reading, value: ElementValue, beside: Tuple[Reading, ...]) -> bool:
    tree = case.sentence.tree
    is_moved = bool(set(_roles(case, reading, value)) & THINGS)
    is_subject = tree.word(value.head_position).deprel.startswith("nsubj")
    return is_moved and not is_subject and is_no_thing(tree, value.head_position, reading.verb)


def _is_listed_elsewhere(case: ClauseCase, reading: Reading, value: ElementValue, beside: Tuple[Reading, ...]) -> bool:
    """ "The photo" may be a thing that is known, "a photo" is what the other unit is about."""
    tree, head = case.sentence.tree, value.head_position
    is_bare = not any(child.deprel in ("det", "nmod:poss") for child in tree.children(head))
    is_noun = tree.word(head).upos == "NOUN" and tree.word(head).deprel == "obj"
    return (
        is_noun
        and (is_bare or is_indefinite(tree, head))
        and any(head in other.listed and other.unit.frame_name != reading.unit.frame_name for other in beside)
    )


#: Each is judged beside all readings of the clause.
PLAUSIBILITY: Tuple[ReadingVerdict, ...] = (
    ReadingVerdict(
        "noun_of_another_verb",
        'A noun fills an element though it is part of the verb of another unit: "take a look".',
        _of_any_value(_is_noun_of_a_verb),
    ),
    ReadingVerdict(
        "measured_elsewhere",
        'A number fills an element though another unit measures with it: "turn one eighty".',
        _of_any_value(_is_measure_elsewhere),
    ),
    ReadingVerdict(
        "unread_elsewhere",
        'An amount that another unit asks for, and must not be acted on, is taken for a thing: "two or three metres".',
        _of_any_value(_is_unread_elsewhere),
    ),
    ReadingVerdict(
        "number_is_no_place",
        'A number is taken for the place of something: "set the thermostat to 20".',
        _of_any_value(_is_numbered_place),
    ),
    ReadingVerdict("degree_is_no_thing", 'A degree is taken for a thing: "move a bit".', _of_any_value(_is_degree)),
    ReadingVerdict("side_is_no_thing", 'A side is taken for a thing: "take a right".', _of_any_value(_is_side)),
    ReadingVerdict(
        "deed_is_no_thing",
        'A deed, an event or a way is taken for a thing: "take a nap", "take the lift".',
        _of_any_value(_is_deed),
    ),
    ReadingVerdict(
        "listed_elsewhere",
        'An indefinite noun is taken for a thing though another unit lists it: "take a photo northwards".',
        _of_any_value(_is_listed_elsewhere),
    ),
)
