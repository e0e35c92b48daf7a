"""How long a command may go on."""

import threading
import time
from dataclasses import replace
from typing import Callable

from executor.goal_tracking import Goal, GoalDeadlines, GoalStatusCode, Outcome


class Patience:
    """The limits of one command: of its whole time, and of the time that it loses with servers that do not work.

    Any thread may call.
    """

    def __init__(self, *, command_s: float, search_s: float, now: Callable[[], float] = time.monotonic) -> None:
        """The command begins now.

        Args:
            command_s: how long it may take
            search_s: how long it may try servers that accept no goal, fall silent, or do not end on cancel
            now: monotonic clock, seconds
        """
        self._command_s = command_s
        self._search_s = search_s
        self._now = now
        self._end_s = now() + command_s
        self._lost_s = 0.0
        self._lock = threading.Lock()

    def refusal(self) -> str:
        """Return why no further server is tried, a clause that follows its name; empty while the command goes on."""
        if self._now() >= self._end_s:
            return f"was not tried: the command may take {self._command_s:g} s"
        if self._lost_s >= self._search_s:
            return f"was not tried: servers that do not work took {self._lost_s:.0f} s"
        return ""

    def deadlines(self, wanted: GoalDeadlines) -> GoalDeadlines:
        """Return the deadlines of a goal that begins now: it ends with the command at the latest."""
        left_s = max(0.001, self._end_s - self._now())
        return replace(wanted, execution_s=min(wanted.execution_s, left_s))

    def spend(self, goal: Goal, duration_s: float) -> None:
        """A goal has ended.

        Args:
            goal: the goal
            duration_s: from the attempt to reach its server
        """
        is_futile = bool(goal.fault) or goal.status is GoalStatusCode.PENDING
        if goal.outcome is Outcome.FAILED and is_futile:
            with self._lock:
                self._lost_s += duration_s
