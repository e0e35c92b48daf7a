"""Reads what is to be checked or made sure of, "make sure that the door is closed", as frames of conditions."""

from dataclasses import replace
from typing import Optional, Tuple

from semantic_framer.clauses.conditions import read_condition
from semantic_framer.units.frame_roles import STATED, STATED_OF
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.condition_part import ConditionPart
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from typed_arguments import EmbeddedFrame, TypedArgument
from word_classes import word_class

_OPENING = word_class("whether_words") | {"that"}


def with_statements(reading: Reading, sentence: Sentence, known: FramedLexicon) -> Reading:
    """Return a reading whose contents have the frames of what they say; others stay as they are.

    A list has a frame for each item, and all of them hold. "Check whether the door is open" has what is said of the
    door in an element of its own.
    """
    frame = known.frames[reading.unit.frame_name]
    roles = {element.name: element.framenet for element in frame.frame_elements}
    about = tuple(place for one in reading.arguments if roles.get(one.name) in STATED_OF for place in one.positions)

    def stated(argument: TypedArgument) -> TypedArgument:
        role = roles.get(argument.name) or ""
        if role not in STATED or not argument.positions or any(one.role == "says" for one in argument.frames):
            return argument
        positions = argument.positions if not STATED[role] else tuple(sorted({*about, *argument.positions}))
        return replace(argument, frames=argument.frames + _says(sentence, known, positions))

    arguments = tuple(stated(argument) for argument in reading.arguments)
    return reading if arguments == reading.arguments else replace(reading, arguments=arguments)


def _says(sentence: Sentence, known: FramedLexicon, positions: Tuple[int, ...]) -> Tuple[EmbeddedFrame, ...]:
    while positions and sentence.word(positions[0]).said in _OPENING:
        positions = positions[1:]
    said = read_condition(sentence, known, positions)
    return () if said is None else _frames(said, sentence) or ()


def _frames(said: ConditionPart, sentence: Sentence) -> Optional[Tuple[EmbeddedFrame, ...]]:
    """Return the frames of what is said; None where not all of it holds at once."""
    if said.kind == "ANY" or said.is_anew:
        return None
    if said.reading is None:
        parts = [_frames(child, sentence) for child in said.children]
        return None if None in parts else tuple(one for part in parts for one in part or ())
    positions = tuple(sorted(said.positions))
    return (
        EmbeddedFrame(
            role="says",
            frame_name=said.reading.unit.frame_name,
            words=sentence.text(positions),
            positions=positions,
            mood="statement",
            is_negated=said.is_negated,
            frame_elements=said.reading.arguments,
        ),
    )
