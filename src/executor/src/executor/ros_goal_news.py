"""News of a goal that was sent: what the callbacks of actionlib put into an inbox, and what each means for the goal."""

import time
from dataclasses import dataclass
from typing import Optional

import actionlib
import rospy

from executor import goal_tracking as tracking
from executor.goal_tracking import Goal
from typed_arguments import FilledFrame, to_goal_text


@dataclass(frozen=True)
class Transition:
    """State of the goal handle when the goal changed."""

    status: int
    is_done: bool
    success: Optional[bool]
    text: str


@dataclass(frozen=True)
class Sign:
    """The server published its status or feedback."""


@dataclass(frozen=True)
class Feedback:
    """What the server says about the goal, and how old that was when it arrived, seconds."""

    is_succeeding: bool
    age_s: float = 0.0


@dataclass(frozen=True)
class Death:
    """The process of the server has ended."""


@dataclass(frozen=True)
class WakeUp:
    """Whoever follows the goal is to look whether it is to be cancelled."""


def read_transition(handle: actionlib.ClientGoalHandle) -> Transition:
    """Return the state of a goal handle."""
    is_done = handle.get_comm_state() == actionlib.CommState.DONE
    result = handle.get_result() if is_done else None
    return Transition(
        status=handle.get_goal_status(),
        is_done=is_done,
        text=handle.get_goal_status_text(),
        success=None if result is None else bool(result.success),
    )


def apply(goal: Goal, heard: object) -> Goal:
    """Return a goal after a piece of news."""
    now_s = time.monotonic()
    if isinstance(heard, Death):
        return tracking.hear_death(goal, now_s=now_s)
    if isinstance(heard, WakeUp):
        return goal
    if isinstance(heard, Feedback):
        return tracking.hear_feedback(goal, is_succeeding=heard.is_succeeding, now_s=now_s)
    if not isinstance(heard, Transition):
        return tracking.hear_sign(goal, now_s=now_s)
    if heard.is_done:
        return tracking.hear_result(goal, heard.status, success=heard.success, text=heard.text, now_s=now_s)
    return tracking.hear_status(goal, heard.status, now_s=now_s)


def header_text(frame: FilledFrame) -> str:
    """Return the text of the typed arguments for the header of a goal; empty when they are too long for it."""
    try:
        return to_goal_text(frame.arguments)
    except ValueError as error:
        rospy.logwarn("%s gets only the texts of its arguments: %s", frame.server, error)
        return ""
