"""Reads a condition that says a state by the units that hold in it: "Anna is in the kitchen", "the battery is low"."""

from dataclasses import replace
from typing import FrozenSet, Optional

from semantic_framer.clauses.condition_states import CLOCK, COMPARISON, VERB, clock_of, condition_states
from semantic_framer.clauses.state_phrases import Positions, StateClause
from semantic_framer.kinds.clause_features import ClauseFeatures
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.word_patterns import argument_of
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import FrameElement, Quantity, SemanticFrame
from semantic_frames.lexical_unit import HeldState, LexicalUnit
from spoken_quantities import QuantityError, parse_measure, parse_number
from typed_arguments import Measure, Source, TypedArgument


def state_condition(
    sentence: Sentence,
    known: FramedLexicon,
    features: ClauseFeatures,
    words: FrozenSet[int],
    *,
    is_until: bool = False,
) -> Optional[Reading]:
    """Read some words as a state; None if they are none.

    Args:
        sentence: the sentence
        known: lexical units and frames
        features: of the clause
        words: positions of its words, without what only denies
        is_until: whether "until" stands before them
    """
    if features.asked in words:
        return None
    # "When" joins the clause, and asks nothing.
    features = replace(features, asked=0)
    clauses = condition_states(sentence, features, words, is_until=is_until)
    readings = (_of_state(sentence, known, clause, words) for clause in clauses)
    return next((reading for reading in readings if reading is not None), None)


def _of_state(
    sentence: Sentence, known: FramedLexicon, clause: StateClause, words: FrozenSet[int]
) -> Optional[Reading]:
    found = [
        (len(held.words), reading)
        for unit in known.lexicon.asking_units(clause.frame)
        for frame in [known.frames.get(unit.frame_name)]
        if frame is not None and frame.is_condition
        for held in unit.holds
        if held.frame == clause.frame
        for reading in [_reading(sentence, clause, unit, frame, held, words)]
        if reading is not None
    ]
    # "The battery is low" is a charge, though anything may be in a state: the unit that says most words is meant.
    return max(found, key=lambda one: one[0])[1] if found else None


def _reading(
    sentence: Sentence,
    clause: StateClause,
    unit: LexicalUnit,
    frame: SemanticFrame,
    held: HeldState,
    words: FrozenSet[int],
) -> Optional[Reading]:
    """Return the reading of a unit; None if it does not say all elements of the state."""
    listed = dict(held.words)
    names = dict(held.elements) if held.elements is not None else {name: name for name in clause.elements}
    if set(clause.elements) != set(names) | set(listed):
        return None
    if any(_plain(sentence, name, clause.elements[name]) not in forms for name, forms in listed.items()):
        return None
    filled = {names[name]: positions for name, positions in clause.elements.items() if name in names}
    if any(frame.element(name) is None for name in filled):
        return None
    arguments = []
    for element in frame.frame_elements:
        if element.name in filled:
            argument = _argument(sentence, clause, element, filled[element.name])
            if argument is None:
                return None
            arguments.append(argument)
        elif element.name in unit.values:
            arguments.append(TypedArgument(element.name, unit.values[element.name], Source.INFERRED))
        elif element.is_core:
            return None
    own = tuple(sorted(words.difference(*filled.values())))
    return Reading(unit, clause.frame, own, tuple(arguments), (), (), 1.0)


def _plain(sentence: Sentence, name: str, positions: Positions) -> str:
    """Return a phrase as units list it: in lower case, and without its preposition; of a verb, its lemma."""
    words = [sentence.word(index) for index in positions]
    if name == VERB:
        return words[0].lemma.lower()
    if name != COMPARISON and len(words) > 1 and words[0].deprel == "case":
        words = words[1:]
    return " ".join(word.said for word in words)


def _argument(
    sentence: Sentence, clause: StateClause, element: FrameElement, positions: Positions
) -> Optional[TypedArgument]:
    if element.quantity is not None:
        return _amount(sentence, element.name, positions, element.quantity)
    argument = argument_of(sentence, element.name, positions)
    if clause.frame == CLOCK and element.name == "time":
        forms = [sentence.word(index).said for index in positions]
        clock = clock_of(forms, is_said=True)
        text = sentence.text(positions)
        return replace(argument, text=text, words=text, time=clock.when) if clock is not None else None
    # A state in its usual word: "closed" for "shut".
    usual = {"shut": "closed", "opened": "open"}.get(argument.text)
    return replace(argument, text=usual) if usual else argument


def _amount(sentence: Sentence, name: str, positions: Positions, quantity: Quantity) -> Optional[TypedArgument]:
    text = sentence.text(positions)
    try:
        if quantity is Quantity.NUMBER:
            number = parse_number(text)
            measure = Measure(quantity.value, text, number, "", number)
        else:
            read = parse_measure(text, quantity=quantity.value)
            measure = Measure(quantity.value, text, read.amount, read.unit, read.si_amount)
    except QuantityError:
        return None
    return TypedArgument(
        name, text, words=text, positions=tuple(positions), head_position=positions[-1], measure=measure
    )
