"""Makes what was done last faster or slower, or says it louder: "faster" after "follow me"."""

from typing import Mapping, Optional, Tuple

from semantic_framer.units.frame_roles import MESSAGE
from semantic_framer.units.heeding import FrameHeeding
from semantic_framer.values.fragment_kind import FragmentKind
from semantic_framer.values.reading import Reading
from semantic_frames.frame import SemanticFrame
from semantic_frames.server_profile import spellings
from typed_arguments import TypedArgument
from word_classes import word_class

FASTER, SLOWER = "faster", "slower"
LOUDER, QUIETER = "louder", "quieter"
_WORDS = {
    FASTER: word_class("quick_words"),
    SLOWER: word_class("slow_words"),
    LOUDER: word_class("loud_words"),
    QUIETER: word_class("quiet_words"),
}
#: What fragments make of a deed.
PACES: Mapping[FragmentKind, str] = {
    FragmentKind.FASTER: FASTER,
    FragmentKind.SLOWER: SLOWER,
    FragmentKind.LOUDER: LOUDER,
    FragmentKind.QUIETER: QUIETER,
}
_OPPOSITES = {FASTER: SLOWER, SLOWER: FASTER, LOUDER: QUIETER, QUIETER: LOUDER}
#: Elements that say how fast something is done, those of the frame before the one that every frame inherits.
_OF_FRAMES = ("speed", "manner")
_INHERITED = "Manner"


def pace_element(frame: SemanticFrame, heeded: Optional[FrameHeeding], pace: str) -> str:
    """Return the element that says how fast or how loud a frame is done, if a server heeds it; empty if none does.

    Args:
        frame: the frame
        heeded: elements of the frame that reach a server; None if nothing can carry it out
        pace: ``FASTER``, ``SLOWER``, ``LOUDER`` or ``QUIETER``
    """
    if pace in (LOUDER, QUIETER):
        # Only what is said can be said louder, and only by a server that knows the word.
        is_said = MESSAGE in frame.roles
        way = TypedArgument(_INHERITED.lower(), pace, head=pace, lemma=pace)
        is_heeded = heeded is not None and _INHERITED in heeded and heeded[_INHERITED].fits(way)
        return way.name if is_said and is_heeded else ""
    for name in _OF_FRAMES:
        if frame.element(name) is not None and (heeded is None or name in heeded):
            return name
    return _INHERITED.lower() if heeded is not None and _INHERITED in heeded else ""


def at_pace(reading: Reading, name: str, pace: str, words: str, positions: Tuple[int, ...]) -> Optional[TypedArgument]:
    """Return the argument that makes a reading faster or slower than it was.

    Args:
        reading: what is done
        name: the element for it
        pace: ``FASTER``, ``SLOWER``, ``LOUDER`` or ``QUIETER``
        words: what the person said
        positions: of these words
    Returns:
        the argument; without a text for the usual way, between slow and fast; None if there is nothing beyond
    """
    before = reading.argument(name)
    said = spellings(*before.text.split()) if before is not None else frozenset()
    if said & _WORDS[pace]:
        return None
    if said & _WORDS[_OPPOSITES[pace]]:
        return TypedArgument(name, "")
    return TypedArgument(
        name, pace, words=words, positions=positions, head=pace, lemma=pace, head_position=positions[-1]
    )
