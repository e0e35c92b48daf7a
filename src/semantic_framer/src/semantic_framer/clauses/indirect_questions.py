"""Reads the questions that a message asks, "tell me how many cups are on the table", as frames."""

from dataclasses import replace
from typing import Optional

from semantic_framer.clauses.state_questions import asked_frame
from semantic_framer.kinds.clause_features import features_among
from semantic_framer.units.frame_roles import MESSAGE, TELLING
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from typed_arguments import EmbeddedFrame, TypedArgument
from word_classes import word_class

_QUESTION = "question"
_WHETHER = word_class("whether_words")


def with_indirect_questions(reading: Reading, sentence: Sentence, known: FramedLexicon) -> Reading:
    """Return a reading whose messages have the frames of the questions in them; others stay as they are.

    The words of a message are quoted, and have no structure: the sentence before they were quoted has it.
    """
    frame = known.frames[reading.unit.frame_name]
    roles = {one.name: one.framenet for one in frame.frame_elements}
    arguments = tuple(
        _with_question(
            argument, sentence, known, is_told=roles.get(argument.name) == MESSAGE and frame.framenet == TELLING
        )
        for argument in reading.arguments
    )
    return reading if arguments == reading.arguments else replace(reading, arguments=arguments)


def _with_question(
    argument: TypedArgument, sentence: Sentence, known: FramedLexicon, *, is_told: bool
) -> TypedArgument:
    asking = [one for one in argument.frames if one.role == "says" and not one.frame_name and _is_question(one)]
    if asking:
        found = _read(asking[0], sentence.unquoted or sentence, known)
        frames = tuple(found if one is asking[0] and found is not None else one for one in argument.frames)
        return argument if frames == argument.frames else replace(argument, frames=frames)
    if is_told and not argument.frames and argument.quantifier == "the":
        # "Tell me *the colour of the mug*" asks for it without a verb.
        said = EmbeddedFrame(role="says", mood=_QUESTION, words=argument.text, positions=argument.positions)
        found = _read(said, sentence.unquoted or sentence, known)
        return argument if found is None else replace(argument, frames=(found,))
    return argument


def _is_question(said: EmbeddedFrame) -> bool:
    """Whether something is asked: "that dinner is ready" is told."""
    return said.mood == _QUESTION or said.words.lower().partition(" ")[0] in _WHETHER


def _read(said: EmbeddedFrame, sentence: Sentence, known: FramedLexicon) -> Optional[EmbeddedFrame]:
    """Return the frame of the question that some words ask; None if they ask none that is known."""
    features = features_among(sentence.tree, sorted(said.positions))
    if features is None:
        return None
    found = asked_frame(sentence, known, features.as_question(), frozenset(said.positions), needs_server=False)
    if found is None:
        return None
    return replace(said, frame_name=found.unit.frame_name, frame_elements=found.arguments)
