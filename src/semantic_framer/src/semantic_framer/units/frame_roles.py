"""Frame elements by FrameNet's names: things, places, other roles, and the elements that single rules use."""

from typing import FrozenSet, Mapping

#: FrameNet's names of saying something to somebody, and of ending one's motion.
TELLING = "Telling"
STOPPING = "Halt"
#: FrameNet's name of what has no end of its own.
PATROLLING = "Patrolling"
MESSAGE = "Message"
ADDRESSEE = "Addressee"
#: Who or what moves along with the robot.
COTHEME = "Cotheme"
THEME = "Theme"
NAME = "Name"
GOAL = "Goal"
#: Things that are moved, given or held.
THINGS: FrozenSet[str] = frozenset([THEME, "Entity"])
#: Places, and not things.
PLACES: FrozenSet[str] = frozenset(["Goal", "Source", "Location", "Ground", "Area", "Place", "Path"])
#: Neither things nor places.
NO_THINGS: FrozenSet[str] = frozenset(
    [
        "Manner",
        "Direction",
        "Distance",
        "Angle",
        "Duration",
        "Recipient",
        "Beneficiary",
        ADDRESSEE,
        "Agent",
        MESSAGE,
    ]
)
#: The verbs of these elements need no tool or company, so a phrase with "with" describes the element.
DESCRIBED: FrozenSet[str] = frozenset(
    [COTHEME, "Category", "Item", "Sought_entity", "Recipient", "Beneficiary", ADDRESSEE]
)
DIRECTION = "Direction"
OPERATIONAL_STATE = "Operational_state"
#: What is to be checked, and whether the thing that it is said of has an element of its own.
STATED: Mapping[str, bool] = {"Unconfirmed_content": False, "Desired_state": True}
STATED_OF: FrozenSet[str] = frozenset(["Ground"])
#: What is said or asked of things, and is none itself.
CONTENTS: FrozenSet[str] = frozenset([*STATED, "Content"])
#: The words that are said or found out, which are about things.
SAID: FrozenSet[str] = frozenset(["Content", MESSAGE])
#: What is opened and closed again: the door, and what the door belongs to.
_OPENED = frozenset(["Container_portal", "Containing_object"])
#: The part of all of these.
CONTAINER = "Containing_object"


def part_of(framenet: str) -> str:
    """Return the part of an element in what may be undone, switched or opened again; empty for an element of any deed.

    Args:
        framenet: FrameNet's name of the element
    """
    if framenet in _OPENED:
        return CONTAINER
    return "" if framenet in THINGS else framenet
