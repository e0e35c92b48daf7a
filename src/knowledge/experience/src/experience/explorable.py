"""Frames of which another server may be tried than the likeliest one: failing costs time and harms nothing."""

from typing import Iterable, Tuple

from semantic_frames.frame import SemanticFrame

#: Frames of FrameNet that change only where the robot is, what it shows and what it knows; all of that can be undone.
#: What takes hold of things, says something, or ends something is not among them.
HARMLESS = frozenset(
    (
        "Change_direction",
        "Cotheme",
        "Gesture",
        "Inspecting",
        "Locating",
        "Motion",
        "Motion_directional",
        "Patrolling",
        "Perception_active",
        "Scrutiny",
        "Self_motion",
        "Verification",
        "Waiting",
    )
)


def explorable(frames: Iterable[SemanticFrame]) -> Tuple[str, ...]:
    """Return the names of the frames that are harmless, and of which no person must approve."""
    return tuple(sorted(one.name for one in frames if one.framenet in HARMLESS and not one.is_confirmed))
