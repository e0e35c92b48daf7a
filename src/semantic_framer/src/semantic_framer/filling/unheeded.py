"""Takes what no server heeds out of a reading, and makes arguments of the extra-thematic phrases that one heeds."""

from dataclasses import replace
from typing import List, Optional, Tuple

from semantic_framer.units.heeding import FrameHeeding
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import SemanticFrame
from typed_arguments import TypedArgument
from word_classes import word_class

_HEARERS = word_class("hearers")


def without_unheeded(
    sentence: Sentence, reading: Reading, frame: SemanticFrame, heeded: Optional[FrameHeeding]
) -> Tuple[Reading, Tuple[int, ...]]:
    """Take out of a reading the arguments that were said and reach no server.

    Args:
        sentence: the sentence
        reading: the reading
        frame: its frame
        heeded: elements of the frame that reach a server; None if nothing can carry it out
    Returns:
        the reading, with their words left over, and the positions of these words
    """
    if heeded is None:
        return reading, ()
    core = {element.name for element in frame.frame_elements if element.is_core}
    lost = tuple(
        argument
        for argument in reading.arguments
        if argument.name not in core
        and not _is_heeded(argument, heeded)
        and argument.measure is None
        and any(_tells_something(sentence, index) for index in argument.positions)
    )
    if not lost:
        return reading, ()
    words = {index for argument in lost for index in argument.positions if _tells_something(sentence, index)}
    kept = tuple(argument for argument in reading.arguments if argument not in lost)
    left_over = tuple(sorted(words.union(reading.left_over)))
    return replace(reading, arguments=kept, left_over=left_over, unheeded=lost), tuple(sorted(words))


def with_heeded_extras(sentence: Sentence, reading: Reading, heeded: FrameHeeding) -> Reading:
    """Give a reading the extra-thematic phrases that a server heeds; the others stay left over.

    Args:
        sentence: the sentence
        reading: the reading, with the extra-thematic phrases that were found
        heeded: elements of the frame that reach a server
    """
    taken: List[TypedArgument] = []
    left: List[TypedArgument] = []
    for extra in reading.extra or ():
        name = extra.name.lower()
        is_free = all(other.name != name for other in (*reading.arguments, *taken))
        if is_free and _is_heeded(extra, heeded):
            taken.append(replace(extra, name=name))
        else:
            left.append(extra)
    if not taken:
        return reading
    words = frozenset(index for one in taken for index in (*sentence.subtree(one.head_position), *one.positions))
    return replace(
        reading,
        arguments=(*reading.arguments, *taken),
        extra=tuple(left),
        left_over=tuple(index for index in reading.left_over if index not in words),
    )


def _is_heeded(argument: TypedArgument, heeded: FrameHeeding) -> bool:
    return argument.name in heeded and heeded[argument.name].fits(argument)


def _tells_something(sentence: Sentence, index: int) -> bool:
    return sentence.is_content(index) and sentence.word(index).said not in _HEARERS
