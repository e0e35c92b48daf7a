"""Watches a condition: a goal of a server that says by its feedback whether the condition holds."""

import threading
from dataclasses import dataclass, field
from typing import Callable, List, Optional

import rospy

from arbitrator.plan import Condition
from arbitrator.watching import Observation
from executor.goal_tracking import GoalDeadlines
from executor.ros_action_clients import ActionClients
from executor.ros_running_goals import RunningGoals
from executor.ros_watch_goals import WatchEnd, WatchGoal, WatchGoals
from typed_arguments import FilledFrame

#: Between two looks whether a server is connected, seconds.
_LOOK_S = 0.03


@dataclass(frozen=True)
class WatchContext:
    """What the watches of one executor share.

    Attributes:
        clients: connections to servers
        running_goals: what must be cancelled if this process is killed
        deadlines: of goals
        longest_silence_s: returns, for a frame and its server, for how long a source may be silent
        on_note: called with a sentence about each change
        turn_s: the silence of a source is noticed this much late at most, seconds
    """

    clients: ActionClients
    running_goals: RunningGoals
    deadlines: GoalDeadlines
    longest_silence_s: Callable[[FilledFrame], float]
    on_note: Callable[[str], None]
    turn_s: float = 0.1
    goals: WatchGoals = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "goals", WatchGoals(turn_s=self.turn_s))


class ConditionWatch:
    """Watches one condition, from the first candidate that can to the last.

    A thread of its own connects to a server; the goals of all watches are followed by one thread of the context.
    """

    def __init__(
        self, condition: Condition, on_observation: Callable[[Observation], None], context: WatchContext
    ) -> None:
        """Begin.

        Args:
            condition: to be watched
            on_observation: called with what the server says, and with a fault when no candidate watches any more
            context: of the executor
        """
        self._condition = condition
        self._on_observation = on_observation
        self._context = context
        self._is_closed = threading.Event()
        self._goal: Optional[WatchGoal] = None
        self._holds: Optional[bool] = None
        self._reasons: List[str] = []
        self._begin()

    def close(self) -> None:
        """End; returns at once. The goal is cancelled until its server has ended it."""
        self._is_closed.set()
        goal = self._goal
        if goal is not None:
            goal.cancel()

    def _begin(self) -> None:
        threading.Thread(target=self._open, name="condition_watch", daemon=True).start()

    def _open(self) -> None:
        """Find the next candidate that watches; what follows comes to `_tell` and `_go_on`."""
        for candidate in self._condition.candidates[len(self._reasons) :]:
            frame = candidate.frames[0]
            try:
                end = self._send(frame)
            except Exception as fault:  # boundary: a watch that broke without a word would never end
                rospy.logerr("the watch of %s failed: %s: %s", frame.server, type(fault).__name__, fault)
                end = WatchEnd(f"cannot be watched: {fault}")
            if end is None or self._is_closed.is_set():
                return
            self._note(frame, end)
        self._on_observation(Observation(fault="; ".join(dict.fromkeys(self._reasons))))

    def _note(self, frame: FilledFrame, end: WatchEnd) -> None:
        rospy.logwarn('"%s": %s %s', self._condition.label, frame.server, end.reason)
        self._reasons.append(end.sentence)

    def _send(self, frame: FilledFrame) -> Optional[WatchEnd]:
        """Ask one server to watch; returns why it cannot; None when it was asked."""
        acceptance_s = self._context.deadlines.acceptance_s
        try:
            connection = self._context.clients.get(frame.server, timeout_s=acceptance_s)
        except ValueError as error:
            return WatchEnd(f"cannot be reached: {error}")
        if connection is None:
            return WatchEnd("cannot be reached: the master does not answer")
        is_sent = False
        try:
            reason = self._context.clients.wait_until_ready(
                connection,
                timeout_s=acceptance_s,
                pause=lambda: self._is_closed.wait(_LOOK_S),
                is_over=self._is_closed.is_set,
            )
            if reason or self._is_closed.is_set():
                return WatchEnd(reason) if reason else None
            goal = WatchGoal(
                frame,
                connection,
                deadlines=self._context.deadlines,
                silence_s=self._context.longest_silence_s(frame),
                on_feedback=self._tell,
                on_end=lambda end: self._go_on(frame, goal_id, end),
            )
            goal_id = goal.send(lambda: self._context.goals.wake(goal))
            self._context.running_goals.note(frame.server, goal_id)
            self._goal = goal
            is_sent = True
            self._context.goals.follow(goal)
            if self._is_closed.is_set():
                goal.cancel()
            return None
        finally:
            if not is_sent:
                self._context.clients.release(frame.server)

    def _go_on(self, frame: FilledFrame, goal_id: str, end: WatchEnd) -> None:
        """A server does not watch any more: the next one is asked."""
        self._goal = None
        self._context.running_goals.forget(goal_id)
        self._context.clients.release(frame.server)
        if not self._is_closed.is_set():
            self._note(frame, end)
            self._begin()

    def _tell(self, holds: bool, age_s: float) -> None:
        if self._is_closed.is_set() or holds is self._holds:
            return
        self._holds = holds
        self._on_observation(Observation(holds=holds))
        how = "holds" if holds else "does not hold"
        self._context.on_note(f'"{self._condition.label}" {how}, as observed {max(0.0, age_s):.3f} s ago.')
