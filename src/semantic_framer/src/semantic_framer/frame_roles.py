"""Frame elements by FrameNet's names: which are places, which are no things, and those that single rules ask for."""

from typing import FrozenSet

MESSAGE = "Message"
ADDRESSEE = "Addressee"
THEME = "Theme"
NAME = "Name"
#: What is moved, given or held.
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
#: What a verb is about, without a tool or company: a phrase with "with" describes it.
DESCRIBED: FrozenSet[str] = frozenset(["Cotheme", "Category", "Item"])
DIRECTION = "Direction"
