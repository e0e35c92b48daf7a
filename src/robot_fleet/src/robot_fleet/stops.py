"""Decides whether what was said to all robots stops one of them. It reads words only, and needs nobody's answer."""

from typing import Callable, FrozenSet, Optional

from command_server.cries import COMMAND_VERBS, STRONG
from command_server.stop_words import find_cry
from robot_fleet.address_text import split_by_address
from robot_fleet.designators import Group, Kind, Names

_VERBS: FrozenSet[str] = COMMAND_VERBS | STRONG


def stops(text: str, robot: str, names: Names, *, is_taken_back: Callable[[str], bool] = lambda part: False) -> bool:
    """Whether an utterance stops a robot: it is a cry, and it is not for other robots alone.

    Args:
        text: what was said to all robots
        robot: name of the robot
        names: of all robots that are known, this one among them
        is_taken_back: whether a cry only takes back the order that this robot was given right before
    """
    parts = split_by_address(text, names, _VERBS)
    cries = [part for part in parts if find_cry(part.text) is not None]
    if not cries and find_cry(text) is not None:
        cries = list(parts)
    cries = [part for part in cries if not is_taken_back(part.text)]
    # "Alpha, stop Beta" may be for both.
    inner = [one for part in cries if part.group for one in split_by_address(part.text, names, _VERBS) if one.group]
    return any(_may_mean(part.group, robot) for part in (*cries, *inner))


def _may_mean(group: Optional[Group], robot: str) -> bool:
    """Whether a robot may be meant: who "the others" are, only the dialogue says."""
    if group is None:
        return True
    is_for_others = group.kinds == {Kind.NAME} and robot not in group.names
    return not is_for_others and robot not in group.excepted
