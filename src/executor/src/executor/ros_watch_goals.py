"""The goals of servers that watch conditions: one thread follows them all.

A server says every second that nothing has changed, for each of its conditions. Such a message only moves a deadline,
in the thread of rospy that brings it; nobody is woken.
"""

import contextlib
import queue
import threading
import time
from collections import deque
from dataclasses import dataclass, replace
from typing import Any, Callable, Deque, Optional, Set

import rospy
from roboframenet_msgs.msg import FilledSemanticFrameGoal

from executor import goal_tracking as tracking
from executor.goal_tracking import Goal, GoalDeadlines, Phase
from executor.ros_goal_news import Death, Feedback, apply, header_text, read_transition
from roboframenet_ros.ros_action_connection import ActionConnection, SentGoal
from roboframenet_ros.suspension import SuspensionWatch
from typed_arguments import FilledFrame
from typed_arguments.ros_messages import frame_to_message

# A condition is watched for as long as the plan wants; the limits of the plan end it.
_NO_LIMIT_S = 1e9


@dataclass(frozen=True)
class WatchEnd:
    """Why nobody watches any more.

    Attributes:
        reason: a clause that follows the name of the server
        told: what the server told as it gave up; empty for none
    """

    reason: str
    told: str = ""

    @property
    def sentence(self) -> str:
        """For a person, without the full stop and without the name of the server."""
        return self.told or tracking.unnamed(self.reason)


class WatchGoal:
    """A goal of a server that watches a condition."""

    def __init__(
        self,
        frame: FilledFrame,
        connection: ActionConnection,
        *,
        deadlines: GoalDeadlines,
        silence_s: float,
        on_feedback: Callable[[bool, float], None],
        on_end: Callable[[WatchEnd], None],
    ) -> None:
        """
        Args:
            frame: says what is watched, and by which server
            connection: to the server
            deadlines: of goals; a watch may take as long as it likes
            silence_s: for how long the source may be silent
            on_feedback: called with whether the condition holds, when that changes, and how old that was, seconds; from
                the thread that follows the goals, as is `on_end`
            on_end: called once, last, with the reason
        """
        self._frame = frame
        self._connection = connection
        self._deadlines = replace(deadlines, execution_s=_NO_LIMIT_S)
        self._silence_s = silence_s
        self._on_feedback, self.on_end = on_feedback, on_end
        self._news: Deque[object] = deque()
        self._wake: Callable[[], None] = lambda: None
        self._is_cancelled = False
        self._said: Optional[bool] = None
        self._observed_s = self._sign_s = 0.0
        self._uri = ""
        self._sent: Optional[SentGoal] = None
        self._goal: Optional[Goal] = None

    def send(self, wake: Callable[[], None]) -> str:
        """Send the goal; returns its id.

        Args:
            wake: called when `step` has something to do, from any thread
        """
        self._wake = wake
        self._connection.listen(self._hear_sign)
        self._goal = tracking.send(self._frame.server, self._deadlines, now_s=time.monotonic())
        self._sent = self._connection.send(
            FilledSemanticFrameGoal(frame=frame_to_message(self._frame)),
            header_text=header_text(self._frame),
            on_transition=lambda handle: self._hear(read_transition(handle)),
            on_feedback=self._hear_feedback,
        )
        return self._sent.goal_id

    def cancel(self) -> None:
        """End the watch; returns at once."""
        self._is_cancelled = True
        self._wake()

    def postpone(self, by_s: float) -> None:
        """Move all deadlines by the time in which this process did not run; from the thread that follows the goals."""
        assert self._goal is not None
        self._goal = tracking.postpone(self._goal, by_s)
        self._observed_s += by_s

    def close(self) -> None:
        """Listen no more."""
        self._connection.unlisten(self._hear_sign)

    def _hear(self, news: object) -> None:
        self._news.append(news)
        self._wake()

    def _hear_sign(self) -> None:
        self._sign_s = time.monotonic()

    def _hear_feedback(self, feedback: Any) -> None:
        """What was said before wakes nobody."""
        age_s = (rospy.Time.now() - self._connection.feedback_stamp).to_sec()
        self._hear_sign()
        # An old observation that is repeated says nothing: its source may be dead.
        if age_s < self._silence_s:
            self._observed_s = self._sign_s
            holds = bool(feedback.is_succeeding)
            if holds is not self._said:
                self._said = holds
                self._hear(Feedback(holds, age_s))

    def step(self) -> Optional[WatchEnd]:
        """Apply news and deadlines; returns why the watch is over, None while it goes on."""
        assert self._goal is not None and self._sent is not None
        while self._news:
            heard = self._news.popleft()
            self._goal = apply(self._goal, heard)
            if isinstance(heard, Feedback):
                self._on_feedback(heard.is_succeeding, heard.age_s)
        goal = self._goal
        self._uri = self._connection.node_uri() or self._uri
        now_s = time.monotonic()
        if self._is_cancelled:
            goal = tracking.ask_preempt(goal, now_s=now_s)
        if self._sign_s > goal.heard_s:
            goal = tracking.hear_sign(goal, now_s=self._sign_s)
        step = tracking.tick(goal, now_s=now_s)
        self._goal = goal = step.goal
        if step.is_cancel_due:
            self._connection.cancel(self._sent)
        if goal.is_ended:
            return WatchEnd(goal.reason or "has ended its watch", tracking.own_words(goal))
        if goal.phase is Phase.ACCEPTED and now_s - max(self._observed_s, goal.since_s) >= self._silence_s:
            self._connection.cancel(self._sent)
            return WatchEnd(f"said nothing for {self._silence_s:g} s")
        if step.is_question_due:
            self._connection.ask_whether_gone(self._uri, lambda: self._hear(Death()))
        return None

    def next_s(self) -> float:
        """When `step` is to be called next if nothing happens, monotonic seconds."""
        assert self._goal is not None
        return tracking.next_deadline_s(self._goal)


class WatchGoals:
    """Follows goals in one thread, which runs while there are any."""

    def __init__(self, *, turn_s: float) -> None:
        """
        Args:
            turn_s: all goals are looked at as often; deadlines are noticed this much late at most
        """
        self._turn_s = turn_s
        self._awake: queue.SimpleQueue[WatchGoal] = queue.SimpleQueue()
        self._lock = threading.Lock()
        self._goals: Set[WatchGoal] = set()
        self._is_running = False

    def wake(self, goal: WatchGoal) -> None:
        """Look at a goal now; from any thread."""
        self._awake.put(goal)

    def follow(self, goal: WatchGoal) -> None:
        """Follow a goal that was sent, until its end."""
        with self._lock:
            self._goals.add(goal)
            is_idle, self._is_running = not self._is_running, True
        self.wake(goal)
        if is_idle:
            threading.Thread(target=self._run, name="condition_watches", daemon=True).start()

    def _run(self) -> None:
        look_s = time.monotonic()
        suspension = SuspensionWatch(longest_turn_s=self._turn_s + 0.4)
        while True:
            woken: Optional[WatchGoal] = None
            with contextlib.suppress(queue.Empty):
                woken = self._awake.get(timeout=max(0.001, look_s - time.monotonic()))
            away_s = suspension.turn()
            if away_s:
                for goal in tuple(self._goals):
                    goal.postpone(away_s)
            # It may have ended, or be followed only in a moment.
            if woken in self._goals:
                self._step(woken)
                look_s = min(look_s, woken.next_s())
            if time.monotonic() >= look_s:
                for goal in tuple(self._goals):
                    self._step(goal)
                look_s = self._next_look_s()
            with self._lock:
                if not self._goals:
                    self._is_running = False
                    return

    def _next_look_s(self) -> float:
        next_s = min((goal.next_s() for goal in tuple(self._goals)), default=0.0)
        return min(next_s, time.monotonic() + self._turn_s)

    def _step(self, goal: WatchGoal) -> None:
        try:
            end = goal.step()
        except Exception as fault:  # boundary: one watch that breaks must not end all others
            rospy.logerr("a watch failed: %s: %s", type(fault).__name__, fault)
            end = WatchEnd(f"cannot be watched: {fault}")
        if end is None:
            return
        with self._lock:
            self._goals.discard(goal)
        try:
            goal.close()
            goal.on_end(end)
        except Exception as fault:  # boundary: as above
            rospy.logerr("the end of a watch failed: %s: %s", type(fault).__name__, fault)
