"""Frame elements by FrameNet's names: things, places, other roles, and the elements that single rules use."""

from typing import FrozenSet

MESSAGE = "Message"
ADDRESSEE = "Addressee"
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
DESCRIBED: FrozenSet[str] = frozenset(["Cotheme", "Category", "Item"])
DIRECTION = "Direction"
OPERATIONAL_STATE = "Operational_state"
