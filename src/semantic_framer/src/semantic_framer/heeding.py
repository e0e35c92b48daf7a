"""Finds out which elements of a frame reach a server: what no server gets must not be dropped without a word."""

from dataclasses import replace
from typing import Collection, Dict, FrozenSet, Mapping, Optional, Tuple

from semantic_framer.reading import Reading
from semantic_framer.sentence import Sentence
from semantic_frames.frame import ElementMapping, SemanticFrame, ValueCondition
from word_classes import word_class

_HEARERS = word_class("hearers")


def heeded_elements(frames: Mapping[str, SemanticFrame], served: Collection[str]) -> Mapping[str, FrozenSet[str]]:
    """Return the elements of each frame that reach a server.

    A server of the frame itself gets all its elements. A server of a child gets those that the relations of the frame
    map to it, and a value condition heeds its element.

    Args:
        frames: by name
        served: names of the frames that have a live server of their own
    Returns:
        a set for each frame that can be carried out
    """
    known: Dict[str, Optional[FrozenSet[str]]] = {}
    for name in frames:
        _heeded(name, frames, served, known)
    return {name: elements for name, elements in known.items() if elements is not None}


def _heeded(
    name: str,
    frames: Mapping[str, SemanticFrame],
    served: Collection[str],
    known: Dict[str, Optional[FrozenSet[str]]],
) -> Optional[FrozenSet[str]]:
    """Return the elements of one frame that reach a server; None if nothing can carry the frame out."""
    if name in known:
        return known[name]
    # The registrar refuses cycles; a catalogue that has one all the same must not end in endless recursion.
    known[name] = None
    frame = frames.get(name)
    if frame is None:
        return None
    found: Optional[FrozenSet[str]] = None
    if name in served:
        found = frozenset(element.name for element in frame.frame_elements)
    for sequence in frame.children:
        reached: FrozenSet[str] = frozenset()
        for child in sequence:
            inside = _heeded(child.name, frames, served, known)
            if inside is None:
                break
            reached |= {
                relation.parent_name
                for relation in child.frame_element_relations
                if isinstance(relation, ValueCondition)
                or (isinstance(relation, ElementMapping) and relation.child_name in inside)
            }
        else:
            found = reached | (found or frozenset())
    known[name] = found
    return found


def without_unheeded(
    sentence: Sentence, reading: Reading, frame: SemanticFrame, heeded: Optional[FrozenSet[str]]
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
        if argument.name not in heeded | core
        and argument.measure is None
        and any(_tells_something(sentence, index) for index in argument.positions)
    )
    if not lost:
        return reading, ()
    words = {index for argument in lost for index in argument.positions if _tells_something(sentence, index)}
    kept = tuple(argument for argument in reading.arguments if argument not in lost)
    left_over = tuple(sorted(words.union(reading.left_over)))
    return replace(reading, arguments=kept, left_over=left_over), tuple(sorted(words))


def _tells_something(sentence: Sentence, index: int) -> bool:
    return sentence.is_content(index) and sentence.word(index).form.lower() not in _HEARERS
