"""Sends one goal to an action server of any type, and waits for its end."""

import queue
import threading
import time
from dataclasses import dataclass, replace
from typing import Any, Callable

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus

from rfnserver.results import BY_CONVENTION, ResultNames, ResultPlan, plan_result
from rfnserver.ros_goal_messages import fields_of, result_type_of
from roboframenet_ros.ros_action_connection import ActionConnection, SentGoal

#: How often a running goal checks whether it must end, seconds.
POLL_S = 0.1
#: After this silence of a server that has a goal, its process is asked whether it lives, seconds.
SUSPICION_S = 1.0


@dataclass(frozen=True)
class ForwardingDeadlines:
    """How long each part may take, seconds.

    Attributes:
        server_s: until the server is connected
        goal_s: until the goal ends by itself; infinite for as long as it takes
        preempt_s: from the cancel to the end
    """

    server_s: float = 5.0
    goal_s: float = float("inf")
    preempt_s: float = 5.0


@dataclass(frozen=True)
class ForwardedEnd:
    """How a forwarded goal ended.

    Attributes:
        status: one of actionlib_msgs/GoalStatus; PREEMPTED when this or another client requested it, ABORTED also when
            the server said that it succeeded and its result says that it did not
        text: the reason, or what the server tells; may be empty
    """

    status: int
    text: str


class GoalForwarder:
    """A client of one action server, for one goal at a time."""

    def __init__(
        self,
        server: str,
        action_type: Any,
        deadlines: ForwardingDeadlines = ForwardingDeadlines(),
        *,
        result_names: ResultNames = BY_CONVENTION,
    ) -> None:
        """
        Args:
            server: name of the action server
            action_type: class of its action
            deadlines: of every goal
            result_names: fields of the result that say whether it worked
        Raises:
            ResultError: the result has no such fields
        """
        self._server = server
        self._deadlines = deadlines
        self._results = plan_result(fields_of(result_type_of(action_type)), result_names)
        self._connection = ActionConnection(server, action_type)

    def carry_out(
        self,
        goal: Any,
        *,
        is_to_end: Callable[[], bool],
        on_feedback: Callable[[Any], None] = lambda feedback: None,
    ) -> ForwardedEnd:
        """Send a goal; returns when the server has ended it.

        Args:
            goal: of the server's type
            is_to_end: called ten times a second; the goal is cancelled when it returns true
            on_feedback: called with each feedback, from a thread of rospy
        """
        if not self._is_there(is_to_end):
            if is_to_end():
                return ForwardedEnd(GoalStatus.PREEMPTED, "")
            return ForwardedEnd(
                GoalStatus.LOST, f"{self._server} is not running (waited {self._deadlines.server_s:g} s)."
            )
        ended: queue.Queue[actionlib.ClientGoalHandle] = queue.Queue()

        def on_transition(handle: actionlib.ClientGoalHandle) -> None:
            if handle.get_comm_state() == actionlib.CommState.DONE:
                ended.put(handle)

        sent = self._connection.send(goal, on_transition=on_transition, on_feedback=on_feedback)
        heard = threading.Event()
        gone = threading.Event()
        self._connection.listen(heard.set)
        try:
            return self._follow(sent, ended, heard, gone, is_to_end)
        finally:
            self._connection.unlisten(heard.set)

    def _follow(
        self,
        sent: SentGoal,
        ended: "queue.Queue[actionlib.ClientGoalHandle]",
        heard: threading.Event,
        gone: threading.Event,
        is_to_end: Callable[[], bool],
    ) -> ForwardedEnd:
        uri = ""
        end_s = time.monotonic() + self._deadlines.goal_s
        question_s = time.monotonic() + SUSPICION_S
        while not rospy.is_shutdown():
            # A process that has ended takes its address along, and one that has just started may connect twice.
            uri = self._connection.node_uri() or uri
            if heard.is_set() or time.monotonic() >= question_s:
                if not heard.is_set():
                    self._connection.ask_whether_gone(uri, gone.set)
                heard.clear()
                question_s = time.monotonic() + SUSPICION_S
            try:
                ended.get(timeout=POLL_S)
                return self._end_of(sent.handle)
            except queue.Empty:
                pass
            if is_to_end():
                return self._cancel(sent, ended, ForwardedEnd(GoalStatus.PREEMPTED, ""))
            if time.monotonic() >= end_s:
                late = f"{self._server} did not finish within {self._deadlines.goal_s:g} s."
                return self._cancel(sent, ended, ForwardedEnd(GoalStatus.ABORTED, late))
            if gone.is_set() or self._connection.is_gone():
                return ForwardedEnd(GoalStatus.LOST, f"{self._server} has died.")
        self._cancel(sent, ended, ForwardedEnd(GoalStatus.PREEMPTED, ""))
        return ForwardedEnd(GoalStatus.PREEMPTED, "shutting down")

    def close(self) -> None:
        """Disconnect."""
        self._connection.close()

    def _is_there(self, is_to_end: Callable[[], bool]) -> bool:
        end_s = time.monotonic() + self._deadlines.server_s
        while time.monotonic() < end_s and not rospy.is_shutdown():
            if self._connection.is_ready():
                return True
            if is_to_end():
                return False
            time.sleep(0.01)
        return False

    def _end_of(self, handle: actionlib.ClientGoalHandle) -> ForwardedEnd:
        status = handle.get_terminal_state()
        end = read_end(status, handle.get_goal_status_text(), handle.get_result(), self._results, self._server)
        if status in (GoalStatus.PREEMPTED, GoalStatus.RECALLED):
            return replace(end, text=end.text or f"another client stopped {self._server}")
        return end

    def _cancel(
        self,
        sent: SentGoal,
        ended: "queue.Queue[actionlib.ClientGoalHandle]",
        end: ForwardedEnd,
    ) -> ForwardedEnd:
        """Cancel the goal, and wait until the server confirms it: only then does the robot stand still."""
        self._connection.cancel(sent)
        try:
            ended.get(timeout=self._deadlines.preempt_s)
        except queue.Empty:
            rospy.logerr("%s did not stop within %g s", self._server, self._deadlines.preempt_s)
            return end
        handle = sent.handle
        told = read_end(
            handle.get_terminal_state(),
            handle.get_goal_status_text(),
            handle.get_result(),
            self._results,
            self._server,
        )
        if told.status == GoalStatus.SUCCEEDED:
            return told
        # A server that was cancelled may say how far it came.
        far = told.text if told.status == GoalStatus.PREEMPTED else ""
        return replace(end, text=f"{end.text} {far}".strip())


def read_end(status: int, text: str, result: Any, results: ResultPlan, server: str) -> ForwardedEnd:
    """Return how a goal ended, by its status and its result.

    Args:
        status: terminal status
        text: of the status; empty for none
        result: None for none
        results: which fields of the result are read
        server: name of the server
    """
    verdict = results.read(result)
    if status in (GoalStatus.PREEMPTED, GoalStatus.RECALLED):
        return ForwardedEnd(GoalStatus.PREEMPTED, verdict.text or text)
    if status == GoalStatus.SUCCEEDED and verdict.is_done:
        return ForwardedEnd(status, verdict.text or text)
    named = actionlib.TerminalState.to_string(status).lower()
    otherwise = (
        f"{server} ended the goal as {named}" if status != GoalStatus.SUCCEEDED else f"{server} reports a failure"
    )
    reason = verdict.text or text or verdict.reason or otherwise
    return ForwardedEnd(GoalStatus.ABORTED if status == GoalStatus.SUCCEEDED else status, reason)
