"""Watches a condition: a goal of a server that says by its feedback whether the condition holds."""

import contextlib
import queue
import threading
import time
from dataclasses import dataclass, replace
from typing import Any, Callable, List, Optional

import rospy
from roboframenet_msgs.msg import FilledSemanticFrameGoal

from arbitrator.plan import Condition
from arbitrator.watching import Observation
from executor import goal_tracking as tracking
from executor.goal_tracking import Goal, GoalDeadlines, Phase
from executor.ros_action_clients import ActionClients
from executor.ros_goal_news import Death, Feedback, WakeUp, apply, header_text, read_transition
from executor.ros_running_goals import RunningGoals
from roboframenet_ros.ros_action_connection import ActionConnection, SentGoal
from typed_arguments import FilledFrame
from typed_arguments.ros_messages import frame_to_message

# A condition is watched for as long as the plan wants; the limits of the plan end it.
_NO_LIMIT_S = 1e9


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


class ConditionWatch:
    """Watches one condition in a thread of its own, from the first candidate that can to the last."""

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
        self._inbox: queue.Queue[object] = queue.Queue()
        self._is_closed = threading.Event()
        self._holds: Optional[bool] = None
        self._sign_s = 0.0
        threading.Thread(target=self._run, name="condition_watch", daemon=True).start()

    def close(self) -> None:
        """End; returns at once. The goal is cancelled until its server has ended it."""
        self._is_closed.set()
        self._inbox.put(WakeUp())

    def _run(self) -> None:
        reasons: List[str] = []
        for candidate in self._condition.candidates:
            frame = candidate.frames[0]
            try:
                reason = self._watch(frame)
            except Exception as fault:  # boundary: a watch that broke without a word would never end
                rospy.logerr("the watch of %s broke: %s: %s", frame.server, type(fault).__name__, fault)
                reason = f"cannot be watched: {fault}"
            if self._is_closed.is_set():
                return
            rospy.logwarn('"%s": %s %s', self._condition.label, frame.server, reason)
            reasons.append(f"{frame.server} {reason}")
        self._on_observation(Observation(fault="; ".join(reasons)))

    def _watch(self, frame: FilledFrame) -> str:
        """Watch by one server; returns why it does not any more, a clause that follows its name."""
        began_s, acceptance_s = time.monotonic(), self._context.deadlines.acceptance_s
        try:
            connection = self._context.clients.get(frame.server, timeout_s=acceptance_s)
        except ValueError as error:
            return f"cannot be reached: {error}"
        if connection is None:
            return "cannot be reached: the master does not answer"
        try:
            while not connection.is_ready():
                if self._is_closed.wait(0.01):
                    return ""
                if time.monotonic() - began_s >= acceptance_s:
                    return f"is not running: no answer within {acceptance_s:g} s"
            return self._follow(frame, connection)
        finally:
            self._context.clients.release(frame.server)

    def _follow(self, frame: FilledFrame, connection: ActionConnection) -> str:
        def on_sign() -> None:
            # It wakes nobody: each status message of a server reaches the watches of all its conditions.
            self._sign_s = time.monotonic()

        def on_feedback(feedback: Any) -> None:
            age_s = (rospy.Time.now() - connection.feedback_stamp).to_sec()
            self._inbox.put(Feedback(bool(feedback.is_succeeding), age_s))

        deadlines = replace(self._context.deadlines, execution_s=_NO_LIMIT_S)
        connection.listen(on_sign)
        try:
            goal = tracking.send(frame.server, deadlines, now_s=time.monotonic())
            sent = connection.send(
                FilledSemanticFrameGoal(frame=frame_to_message(frame)),
                header_text=header_text(frame),
                on_transition=lambda handle: self._inbox.put(read_transition(handle)),
                on_feedback=on_feedback,
            )
            self._context.running_goals.note(frame.server, sent.goal_id)
            try:
                return self._follow_sent(frame, connection, sent, goal)
            finally:
                self._context.running_goals.forget(sent.goal_id)
        finally:
            connection.unlisten(on_sign)

    def _follow_sent(self, frame: FilledFrame, connection: ActionConnection, sent: SentGoal, goal: Goal) -> str:
        silence_s = self._context.longest_silence_s(frame)
        observed_s: Optional[float] = None
        uri = ""
        while True:
            uri = connection.node_uri() or uri
            now_s = time.monotonic()
            if self._is_closed.is_set():
                goal = tracking.ask_preempt(goal, now_s=now_s)
            if self._sign_s > goal.heard_s:
                goal = tracking.hear_sign(goal, now_s=self._sign_s)
            step = tracking.tick(goal, now_s=now_s)
            goal = step.goal
            if step.is_cancel_due:
                connection.cancel(sent)
            if goal.is_ended:
                return goal.reason or "has ended its watch"
            if goal.phase is Phase.ACCEPTED and now_s - max(observed_s or 0.0, goal.since_s) >= silence_s:
                connection.cancel(sent)
                return f"said nothing for {silence_s:g} s"
            if step.is_question_due:
                connection.ask_whether_gone(uri, lambda: self._inbox.put(Death()))
            wait_s = min(self._context.turn_s, max(0.001, tracking.next_deadline_s(goal) - now_s))
            with contextlib.suppress(queue.Empty):
                heard = self._inbox.get(timeout=wait_s)
                goal = apply(goal, heard)
                # An old observation that is repeated says nothing: its source may be dead.
                if isinstance(heard, Feedback) and heard.age_s < silence_s:
                    observed_s = time.monotonic()
                    self._tell(heard)

    def _tell(self, feedback: Feedback) -> None:
        if self._is_closed.is_set() or feedback.is_succeeding is self._holds:
            return
        self._holds = feedback.is_succeeding
        self._on_observation(Observation(holds=feedback.is_succeeding))
        how = "holds" if feedback.is_succeeding else "does not hold"
        self._context.on_note(f'"{self._condition.label}" {how}, as observed {max(0.0, feedback.age_s):.3f} s ago.')
