"""Events of the worker besides messages: texts and goals, cancelled goals, and the state of its brake."""

import time
from dataclasses import dataclass, field
from typing import Optional

import actionlib

from robot_stop.braking import Finding
from robot_stop.ros_brake import Braked


@dataclass(frozen=True)
class Said:
    """A text or a goal, with the time of its arrival."""

    text: str
    arrival_ns: int
    handle: Optional[actionlib.ServerGoalHandle] = None
    arrival_s: float = field(default_factory=time.monotonic)


@dataclass(frozen=True)
class GoalCancelled:
    """The client of a goal cancelled it."""

    command_id: str


@dataclass(frozen=True)
class Braking:
    """The stop that the brake carried out, and who obeyed it."""

    braked: Optional[Braked] = None
    finding: Optional[Finding] = None
