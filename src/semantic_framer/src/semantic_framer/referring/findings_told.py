"""Fills in what "and tell me" leaves out: what the clause before it is to find out."""

from typing import List, Mapping, Optional, Sequence, Tuple

from semantic_framer.units.frame_roles import CONTENTS, MESSAGE, STATED, STATED_OF, TELLING
from semantic_framer.values.reading import Reading, with_argument
from semantic_frames.frame import FrameElement, SemanticFrame
from typed_arguments import EmbeddedFrame, Source, TypedArgument
from word_classes import word_class

#: FrameNet's name of what is reported.
_TOPIC = "Topic"
_QUESTION_WORDS = word_class("question_words")


def with_finding(reading: Reading, before: Sequence[Reading], frames: Mapping[str, SemanticFrame]) -> Reading:
    """Return a reading that tells what is found out: "check whether the door is locked and tell me" tells *whether the
    door is locked*. A reading that says what to tell, or has no such clause before it, stays as it is.

    Args:
        reading: of a clause
        before: of the clauses before it, in order
        frames: by name
    """
    element = element_told(reading, frames)
    # Who is to *say* something says words of somebody.
    if element is None or (element.framenet == MESSAGE and frames[reading.unit.frame_name].framenet != TELLING):
        return reading
    findings = (_found_out(one, frames[one.unit.frame_name]) for one in reversed(before))
    found = next(filter(None, findings), None)
    if found is None:
        return reading
    words, positions = found
    question = EmbeddedFrame(role="says", words=words, positions=positions, mood="question")
    return with_argument(reading, TypedArgument(element.name, words, Source.INFERRED, words=words, frames=(question,)))


def element_told(reading: Reading, frames: Mapping[str, SemanticFrame]) -> Optional[FrameElement]:
    """Return the element of what is told or reported, if it is the only one that is open; None if not."""
    frame = frames[reading.unit.frame_name]
    open_elements = [
        element
        for element in frame.frame_elements
        if element in reading.missing or (element.framenet == _TOPIC and reading.argument(element.name) is None)
    ]
    if frame.is_condition or [element.framenet for element in open_elements] not in ([MESSAGE], [_TOPIC]):
        return None
    return open_elements[0]


def _found_out(reading: Reading, frame: SemanticFrame) -> Optional[Tuple[str, Tuple[int, ...]]]:
    """Return what a clause is to find out, as an indirect question with the positions of its words: "who is there",
    "whether the door is locked"; None if it is to find out nothing.
    """
    roles = {element.name: element.framenet for element in frame.frame_elements}
    contents = [one for one in reading.arguments if roles[one.name] in CONTENTS and one.positions]
    if not contents:
        return None
    is_stated = roles[contents[0].name] in STATED
    about = [
        one
        for one in reading.arguments
        if one.positions and (roles[one.name] in STATED_OF if is_stated else one.text.lower() in _QUESTION_WORDS)
    ]
    words = _in_order([*about, *contents])
    if not words:
        return None
    positions = frozenset().union(*(one.positions for one in (*about, *contents)))
    return (f"whether {words}" if is_stated else words), tuple(sorted(positions))


def _in_order(arguments: Sequence[TypedArgument]) -> Optional[str]:
    """Return the words of arguments in the order in which they were said; None where that is not known."""
    placed: List[Tuple[int, str]] = []
    for argument in arguments:
        words = (argument.text if argument.source is Source.INFERRED else argument.words).split()
        first, last = argument.positions[0], argument.positions[-1]
        if len(words) == len(argument.positions):
            placed += zip(argument.positions, words)
        elif last - first + 1 == len(argument.positions):
            placed.append((first, " ".join(words)))
        else:
            return None
    return " ".join(word for _, word in sorted(placed))
