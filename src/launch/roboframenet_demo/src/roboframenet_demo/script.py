"""The sentences of a demonstration with their expected effects, and the comparison with the measurements."""

import math
from dataclasses import dataclass, field
from enum import Enum
from typing import Any, Dict, Mapping, Optional, Tuple


class Measured(Enum):
    """What can be measured. The value is the key in the script file."""

    TURNED_RAD = "turned_rad"  # unwrapped heading, left positive (REP 103)
    MOVED_M = "moved_m"  # along the heading at the start, forward positive
    REACHED = "reached"  # distance to a point of the map, metres
    FOLLOWED_M = "followed_m"  # length of the path while following, metres; a lower bound
    ARM_MOVED_RAD = "arm_moved_rad"  # largest excursion of a joint; a lower bound
    ARM_OFFSET_RAD = "arm_offset_rad"  # distance of the joints from their first positions; an upper bound
    SAID = "said"  # a text that a server publishes, or part of it
    TRUTH = "truth"  # names of the truth of a home, and their values


@dataclass(frozen=True)
class Interruption:
    """A second sentence that is said while the robot carries out the first.

    Attributes:
        text: the sentence
        after_s: when it is said, seconds after the robot began to move
        outcome: expected outcome of this sentence
    """

    text: str
    after_s: float
    outcome: str = "DONE"


@dataclass(frozen=True)
class Line:
    """One sentence of the demonstration.

    Attributes:
        text: what is said
        outcome: name of the expected ``Reply`` outcome
        expected: the expected amounts, places and texts; empty when the robot must not move
        tolerance: allowed relative error of amounts
        interruption: a second sentence, said while the robot moves; None for none
        timeout_s: how long to wait for the reply, seconds
        person: what the simulated person does ("walk", "leave"); empty for nothing
    """

    text: str
    outcome: str = "DONE"
    expected: Mapping[Measured, Any] = field(default_factory=dict)
    tolerance: float = 0.02
    interruption: Optional[Interruption] = None
    timeout_s: float = 60.0
    person: str = ""


@dataclass(frozen=True)
class Observation:
    """What the robot did and said between a sentence and its reply.

    Attributes:
        turned_rad: change of heading, unwrapped, left positive
        moved_m: displacement along the heading at the start
        driven_m: length of the path driven
        position_m: (x, y) at the end, in the frame of the odometry
        arm_moved_rad: largest excursion of any arm joint
        arm_offset_rad: largest distance of an arm joint from its first position, at the end
        said: texts published by the servers
        truth: what is true in the home; empty without one
        changed: what changed in the home, in words
        is_still: whether base and joints stood still at the end
    """

    turned_rad: float = 0.0
    moved_m: float = 0.0
    driven_m: float = 0.0
    position_m: Tuple[float, float] = (0.0, 0.0)
    arm_moved_rad: float = 0.0
    arm_offset_rad: float = 0.0
    said: Tuple[str, ...] = ()
    truth: Mapping[str, Any] = field(default_factory=dict)
    changed: str = ""
    is_still: bool = True

    def describe(self) -> str:
        """Return the values that are not zero, for the table."""
        parts = []
        if abs(self.turned_rad) > 0.01:
            parts.append(f"turned {self.turned_rad:+.3f} rad")
        if abs(self.moved_m) > 0.01:
            parts.append(f"moved {self.moved_m:+.3f} m")
        if self.driven_m > abs(self.moved_m) + 0.05:
            parts.append(f"drove {self.driven_m:.2f} m to ({self.position_m[0]:.2f}, {self.position_m[1]:.2f})")
        if self.arm_moved_rad > 0.01:
            parts.append(f"arm moved {self.arm_moved_rad:.2f} rad")
        parts += [self.changed] if self.changed else []
        parts += [f'said "{text}"' for text in self.said]
        return ", ".join(parts) or "stood still"


def judge(line: Line, outcome: str, observation: Observation) -> Tuple[bool, str]:
    """Compare the measurements with what is expected.

    Args:
        line: the sentence and its expectation
        outcome: name of the outcome of the reply
        observation: what the robot did
    Returns:
        whether all is as expected, and the first difference; empty for none
    """
    if outcome != line.outcome:
        return False, f"expected {line.outcome}"
    if not observation.is_still:
        return False, "the robot still moves"
    for measured, expected in line.expected.items():
        reason = _deviation(measured, expected, observation, line.tolerance)
        if reason:
            return False, reason
    if not line.expected and line.interruption is None and line.outcome != "DONE" and observation.driven_m > 0.01:
        return False, "moved although it should not"
    return True, ""


def _deviation(measured: Measured, expected: Any, observation: Observation, tolerance: float) -> str:
    if measured is Measured.SAID:
        return (
            ""
            if any(str(expected).lower() in text.lower() for text in observation.said)
            else f'did not say "{expected}"'
        )
    if measured is Measured.TRUTH:
        wrong = [
            f"{name} is {observation.truth.get(name)}"
            for name, value in expected.items()
            if observation.truth.get(name) != value
        ]
        return ", ".join(wrong)
    if measured is Measured.REACHED:
        distance = math.hypot(observation.position_m[0] - expected[0], observation.position_m[1] - expected[1])
        return "" if distance <= 0.3 else f"{distance:.2f} m away from the place"
    if measured is Measured.FOLLOWED_M:
        return "" if observation.driven_m >= expected else f"followed {observation.driven_m:.2f} m only"
    if measured is Measured.ARM_MOVED_RAD:
        return "" if observation.arm_moved_rad >= expected else f"arm moved {observation.arm_moved_rad:.2f} rad only"
    if measured is Measured.ARM_OFFSET_RAD:
        offset = observation.arm_offset_rad
        return "" if offset <= expected else f"arm is {offset:.2f} rad from where it began"
    amount = observation.turned_rad if measured is Measured.TURNED_RAD else observation.moved_m
    error = abs(amount - expected) / abs(expected)
    return "" if error <= tolerance else f"{100 * error:.1f} % off"


def read_line(entry: Dict[str, Any]) -> Line:
    """Make a line from its mapping in a script file.

    Raises:
        ValueError: a key is unknown, or there is no sentence
    """
    known = {"say", "outcome", "expect", "tolerance", "interrupt", "timeout_s", "person"}
    unknown = set(entry) - known
    if unknown or "say" not in entry:
        raise ValueError(f"a line has 'say' and may have {sorted(known - {'say'})}; found {sorted(entry)}")
    interrupt = entry.get("interrupt")
    return Line(
        text=entry["say"],
        outcome=entry.get("outcome", "DONE"),
        expected={Measured(key): value for key, value in entry.get("expect", {}).items()},
        tolerance=float(entry.get("tolerance", 0.02)),
        interruption=Interruption(text=interrupt["say"], after_s=float(interrupt["after_s"])) if interrupt else None,
        timeout_s=float(entry.get("timeout_s", 60.0)),
        person=entry.get("person", ""),
    )
