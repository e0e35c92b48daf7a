"""Sends one goal to an action server of any type, and waits for its end."""

import queue
import threading
import time
from dataclasses import dataclass
from typing import Any, Callable

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus

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
        status: one of actionlib_msgs/GoalStatus; PREEMPTED when this or another client requested it
        text: the reason; may be empty
        result: of the server, None when it sent none
    """

    status: int
    text: str
    result: Any = None


class GoalForwarder:
    """A client of one action server, for one goal at a time."""

    def __init__(self, server: str, action_type: Any, deadlines: ForwardingDeadlines = ForwardingDeadlines()) -> None:
        """
        Args:
            server: name of the action server
            action_type: class of its action
            deadlines: of every goal
        """
        self._server = server
        self._deadlines = deadlines
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
        text = handle.get_goal_status_text()
        if status == GoalStatus.SUCCEEDED:
            return ForwardedEnd(status, text, handle.get_result())
        if status in (GoalStatus.PREEMPTED, GoalStatus.RECALLED):
            return ForwardedEnd(
                GoalStatus.PREEMPTED, text or f"another client stopped {self._server}", handle.get_result()
            )
        named = actionlib.TerminalState.to_string(status).lower()
        return ForwardedEnd(status, text or f"{self._server} ended the goal as {named}", handle.get_result())

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
        concluded = self._end_of(sent.handle)
        return concluded if concluded.status == GoalStatus.SUCCEEDED else end
