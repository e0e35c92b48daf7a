"""Makes what was done last faster or slower: "faster" after "follow me"."""

from typing import Optional, Tuple

from semantic_framer.heeding import FrameHeeding
from semantic_framer.reading import Reading
from semantic_frames.frame import SemanticFrame
from semantic_frames.server_profile import spellings
from typed_arguments import TypedArgument
from word_classes import word_class

FASTER, SLOWER = "faster", "slower"
_PACES = {FASTER: word_class("quick_words"), SLOWER: word_class("slow_words")}
#: Elements that say how fast something is done, those of the frame before the one that every frame inherits.
_OF_FRAMES = ("speed", "manner")
_INHERITED = "Manner"


def pace_element(frame: SemanticFrame, heeded: Optional[FrameHeeding]) -> str:
    """Return the element that says how fast a frame is done, if a server heeds it; empty if none does.

    Args:
        frame: the frame
        heeded: elements of the frame that reach a server; None if nothing can carry it out
    """
    for name in _OF_FRAMES:
        if frame.element(name) is not None and (heeded is None or name in heeded):
            return name
    return _INHERITED.lower() if heeded is not None and _INHERITED in heeded else ""


def at_pace(reading: Reading, name: str, pace: str, words: str, positions: Tuple[int, ...]) -> Optional[TypedArgument]:
    """Return the argument that makes a reading faster or slower than it was.

    Args:
        reading: what is done
        name: the element for it
        pace: ``FASTER`` or ``SLOWER``
        words: what the person said
        positions: of these words
    Returns:
        the argument; without a text for the usual pace, between slow and fast; None if there is nothing beyond
    """
    before = reading.argument(name)
    said = spellings(*before.text.split()) if before is not None else frozenset()
    if said & _PACES[pace]:
        return None
    if any(said & other for other in _PACES.values()):
        return TypedArgument(name, "")
    return TypedArgument(
        name, pace, words=words, positions=positions, head=pace, lemma=pace, head_position=positions[-1]
    )
