"""Whether the emergency stop holds.

A state is a value with a number. Several nodes keep one, and agree without asking: the highest number counts, and with
equal numbers the state that holds the robot. A number is never below the seconds since 1970, so that a node whose file
was lost or damaged counts on above what it no longer knows.
"""

import time
from dataclasses import dataclass
from typing import Any, Dict

from roboframenet_ros.bounded_text import one_line

#: Code of the reply to a command that is refused while it holds.
CODE = "EMERGENCY_STOP"
HOW_TO_RELEASE = (
    'To release it, say "release the emergency stop", or use the page or the service emergency_stop/release.'
)
_LONGEST_BY = 200


@dataclass(frozen=True)
class Emergency:
    """Whether the emergency stop holds.

    Attributes:
        number: grows with each change, also over restarts; 0 before the first
        is_engaged: whether it holds
        by: what engaged or released it, for a person
        since_s: of that, seconds since 1970
    """

    number: int = 0
    is_engaged: bool = False
    by: str = ""
    since_s: float = 0.0

    @property
    def sentence(self) -> str:
        """Why nothing moves, and how that ends; empty when it does not hold."""
        if not self.is_engaged:
            return ""
        since = time.strftime("%H:%M:%S", time.localtime(self.since_s))
        return f"The emergency stop has held since {since} ({self.by}). {HOW_TO_RELEASE}"


def engaged(state: Emergency, *, by: str, now_s: float) -> Emergency:
    """Return the state in which it holds; the same state if it holds already.

    Args:
        state: as it is
        by: what engages it, for a person
        now_s: seconds since 1970
    """
    return state if state.is_engaged else _next(state, True, by, now_s)


def released(state: Emergency, *, by: str, now_s: float) -> Emergency:
    """Return the state in which it does not hold; the same state if it does not hold anyway.

    Args:
        state: as it is
        by: what releases it, for a person
        now_s: seconds since 1970
    """
    return _next(state, False, by, now_s) if state.is_engaged else state


def _next(state: Emergency, is_engaged: bool, by: str, now_s: float) -> Emergency:
    return Emergency(max(state.number + 1, int(now_s)), is_engaged, one_line(by, _LONGEST_BY), now_s)


def newer(one: Emergency, other: Emergency) -> Emergency:
    """Return which of two states counts."""
    return max(one, other, key=lambda state: (state.number, state.is_engaged))


def to_json(state: Emergency) -> Dict[str, Any]:
    """Return a state as a value for a file."""
    return {"number": state.number, "is_engaged": state.is_engaged, "by": state.by, "since_s": state.since_s}


def from_json(value: object) -> Emergency:
    """Return the state of a value from a file.

    Raises:
        ValueError: it is none
    """
    if not isinstance(value, dict):
        raise ValueError(f"expected a mapping, found {type(value).__name__}")
    number, is_engaged = value.get("number"), value.get("is_engaged")
    by, since_s = value.get("by"), value.get("since_s")
    if not isinstance(number, int) or isinstance(number, bool) or not 0 <= number < 1 << 32:
        raise ValueError(f"number: expected a whole number from 0, found {number!r}")
    if not isinstance(is_engaged, bool):
        raise ValueError(f"is_engaged: expected true or false, found {is_engaged!r}")
    if not isinstance(by, str) or isinstance(since_s, bool) or not isinstance(since_s, (int, float)):
        raise ValueError(f"by, since_s: expected a text and seconds, found {by!r} and {since_s!r}")
    return Emergency(number, is_engaged, one_line(by, _LONGEST_BY), float(since_s))
