"""Decides whether what was said to all robots stops one of them. It reads words only, and needs nobody's answer."""

from typing import Callable, FrozenSet, Optional, Sequence, Tuple

from command_server.cries import COMMAND_VERBS, STRONG
from command_server.emergency_words import ENGAGING
from command_server.stop_words import is_stop
from robot_fleet.address_text import split_by_address
from robot_fleet.designators import Group, Kind
from robot_fleet.robot_names import Names

_VERBS: FrozenSet[str] = COMMAND_VERBS | STRONG | {phrase.split()[0] for phrase in ENGAGING}


def stops(
    text: str,
    robot: str,
    names: Names,
    *,
    is_taken_back: Callable[[str], bool] = lambda part: False,
    is_cry: Callable[[str], bool] = is_stop,
) -> bool:
    """Whether an utterance stops a robot: it is a cry, and it is not for other robots alone.

    Args:
        text: what was said to all robots
        robot: name of the robot
        names: of all robots that are known, this one among them
        is_taken_back: whether a cry only takes back the order that this robot was given right before
        is_cry: which words count
    """
    return bool(stopped_by(text, (robot,), names, is_taken_back=is_taken_back, is_cry=is_cry))


def stopped_by(
    text: str,
    robots: Sequence[str],
    names: Names,
    *,
    is_taken_back: Callable[[str], bool] = lambda part: False,
    is_cry: Callable[[str], bool] = is_stop,
) -> Tuple[str, ...]:
    """Return those of some robots that an utterance stops; see :func:`stops`."""
    parts = split_by_address(text, names, _VERBS)
    cries = [part for part in parts if is_cry(part.text)]
    if not cries and is_cry(text):
        cries = list(parts)
    cries = [part for part in cries if not is_taken_back(part.text)]
    # "Alpha, stop Beta" may be for both.
    inner = [one for part in cries if part.group for one in split_by_address(part.text, names, _VERBS) if one.group]
    return tuple(robot for robot in robots if any(_may_mean(part.group, robot) for part in (*cries, *inner)))


def _may_mean(group: Optional[Group], robot: str) -> bool:
    """Whether a robot may be meant: who "the others" are, only the dialogue says; an unknown name may be misheard."""
    if group is None or group.unknown:
        return True
    is_for_others = group.kinds == {Kind.NAME} and robot not in group.names
    return not is_for_others and robot not in group.excepted
