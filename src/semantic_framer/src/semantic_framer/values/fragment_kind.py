"""What a fragment does to the last command."""

from enum import Enum


class FragmentKind(Enum):
    """What a fragment does to the last command."""

    REPEAT = "repeats it"
    ONE_MORE = "repeats it, or does one more of what it counts"
    MORE = "does as much again"
    BIT = "does a bit more"
    FASTER = "goes faster"
    SLOWER = "goes slower"
    LOUDER = "says it louder"
    QUIETER = "says it more quietly"
    OPPOSITE = "takes the other side"
    ELEMENTS = "changes elements"
