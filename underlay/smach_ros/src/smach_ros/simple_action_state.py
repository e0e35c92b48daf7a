"""SimpleActionState: sends a goal to an action server and ends as the goal does."""

import threading
import time
from typing import Any, Callable, Iterable, Mapping, Optional

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus

import smach
from smach_ros.message_mapping import MessageSink, MessageSource

# How often a waiting state asks whether the program ends.
SHUTDOWN_POLL_S = 0.2


class SimpleActionState(smach.State):
    """Ends with succeeded or aborted as the goal does, and with preempted when it was asked to stop and the goal did.

    A goal that ends otherwise (rejected, lost, cancelled by somebody else, out of time) is aborted: preempted tells
    the container that its own request was answered. A callback that raises or returns something that is not allowed
    aborts the state, as does a key without a value; the error is logged.

    A subclass may define `_goal_active_cb(self)`, called when the server has accepted the goal, and
    `_goal_feedback_cb(self, feedback)`.

    Args:
        action_name: name of the action
        action_spec: its type, for example MoveBaseAction
        goal: the goal, when it is known now; None for an empty one
        goal_key: userdata key of a whole goal
        goal_slots: fields of the goal that are read from userdata keys of the same names
        goal_cb: called with the userdata and the goal so far; changes the goal or returns another one
        goal_cb_args: more positional arguments of `goal_cb`
        goal_cb_kwargs: more keyword arguments of `goal_cb`
        result_key: userdata key under which the whole result is put, after `result_cb`
        result_slots: fields of the result that are put under userdata keys of the same names, after `result_cb`
        result_cb: called with the userdata, the terminal status (actionlib_msgs/GoalStatus) and the result when the
            goal has ended, None for a goal that the server forgot; returns an outcome, or None to leave it to the
            state
        result_cb_args: more positional arguments of `result_cb`
        result_cb_kwargs: more keyword arguments of `result_cb`
        input_keys: userdata that the callbacks read
        output_keys: userdata that the callbacks write
        outcomes: more outcomes, which `result_cb` may return
        exec_timeout: time after which the goal is cancelled; None or 0 for no limit
        preempt_timeout: time that a cancelled goal gets to end, after which the state aborts
        server_wait_timeout: time that the server gets to appear, after which the state aborts

    Raises:
        InvalidStateError: the goal or a field of it does not belong to the action
    """

    # Values of `_status`, for subclasses.
    WAITING_FOR_SERVER, INACTIVE, ACTIVE, PREEMPTING, COMPLETED = range(5)

    def __init__(
        self,
        action_name: str,
        action_spec: type,
        goal: Any = None,
        goal_key: Optional[str] = None,
        goal_slots: Iterable[str] = (),
        goal_cb: Optional[Callable[..., Any]] = None,
        goal_cb_args: Iterable[Any] = (),
        goal_cb_kwargs: Optional[Mapping[str, Any]] = None,
        result_key: Optional[str] = None,
        result_slots: Iterable[str] = (),
        result_cb: Optional[Callable[..., Optional[str]]] = None,
        result_cb_args: Iterable[Any] = (),
        result_cb_kwargs: Optional[Mapping[str, Any]] = None,
        input_keys: Iterable[str] = (),
        output_keys: Iterable[str] = (),
        outcomes: Iterable[str] = (),
        exec_timeout: Optional[rospy.Duration] = None,
        preempt_timeout: rospy.Duration = rospy.Duration(60.0),
        server_wait_timeout: rospy.Duration = rospy.Duration(60.0),
    ) -> None:
        smach.State.__init__(
            self, outcomes=["succeeded", "aborted", "preempted"], input_keys=input_keys, output_keys=output_keys
        )
        self.register_outcomes(outcomes)
        action = action_spec()
        self._goal_source = MessageSource(
            "goal", type(action.action_goal.goal), goal, goal_key, goal_slots, goal_cb, goal_cb_args, goal_cb_kwargs
        )
        self._result_sink = MessageSink(
            "result",
            type(action.action_result.result),
            result_key,
            result_slots,
            result_cb,
            result_cb_args,
            result_cb_kwargs,
        )
        self._goal_source.register(self)
        self._result_sink.register(self)
        self._action_name = action_name
        self._exec_timeout_s = exec_timeout.to_sec() if exec_timeout else None
        self._preempt_timeout_s = preempt_timeout.to_sec()
        self._server_wait_timeout_s = server_wait_timeout.to_sec()
        # Made here, so that it has its connections when the state starts.
        self._client = actionlib.ActionClient(action_name, action_spec)
        self._status = self.WAITING_FOR_SERVER
        self._wake = threading.Event()
        # Guards the two below, which request_preempt shares with the running thread.
        self._lock = threading.Lock()
        self._goal_handle: Optional[actionlib.ClientGoalHandle] = None
        # When a cancelled goal is given up, on the monotonic clock; None while it is not cancelled.
        self._give_up_at: Optional[float] = None

    def request_preempt(self) -> None:
        """Ask the state to stop: its goal is cancelled now, and has the preempt timeout to end."""
        super().request_preempt()
        # Sent from here, not from the waiting thread: at the end of the program only this call may still publish.
        self._cancel()
        self._wake.set()

    def is_cancel_on_its_way(self) -> bool:
        """Whether the goal is cancelled, and its server has not told yet that it knows."""
        # Without the lock: Ctrl-C interrupts the main thread, which may hold it.
        handle = self._goal_handle
        return handle is not None and handle.get_comm_state() == actionlib.CommState.WAITING_FOR_CANCEL_ACK

    def _goal_active_cb(self) -> None:
        """Called when the server has accepted the goal."""

    def _goal_feedback_cb(self, feedback: Any) -> None:
        """Called for each feedback of the goal, by a thread of ROS."""

    def execute(self, ud: Any) -> str:
        """Send the goal and wait for its end."""
        with self._lock:
            self._give_up_at = None
        self._status = self.WAITING_FOR_SERVER
        if not self._wait_for_server():
            return self._end_early("no server")
        try:
            goal = self._goal_source.build(ud)
        except smach.InvalidUserCodeError as error:
            return self._end_early(str(error))
        if self.preempt_requested():
            return self._end_early("asked to stop before the goal was sent")
        self._status = self.INACTIVE
        with self._lock:
            self._goal_handle = self._client.send_goal(
                goal, self._see_transition, lambda handle, feedback: self._goal_feedback_cb(feedback)
            )
            handle = self._goal_handle
        try:
            if not self._wait_for_end(handle):
                return self._end_early("the goal did not end")
            return self._outcome(ud, handle.get_terminal_state(), handle.get_result())
        finally:
            self._status = self.COMPLETED
            with self._lock:
                self._goal_handle = None

    def _see_transition(self, handle: actionlib.ClientGoalHandle) -> None:
        self._wake.set()
        if handle.get_comm_state() == actionlib.CommState.ACTIVE:
            self._status = self.ACTIVE
            self._goal_active_cb()

    def _wait_for_server(self) -> bool:
        """Wait until the server is there, the time is over, or somebody asks the state to stop."""
        give_up_at = time.monotonic() + self._server_wait_timeout_s
        while not self.preempt_requested() and not rospy.is_shutdown():
            if self._client.wait_for_server(rospy.Duration(SHUTDOWN_POLL_S)):
                return True
            if time.monotonic() >= give_up_at:
                break
        return False

    def _wait_for_end(self, handle: actionlib.ClientGoalHandle) -> bool:
        """Wait until the goal has ended; False when that takes too long or the program ends."""
        started_at = time.monotonic()
        while handle.get_comm_state() != actionlib.CommState.DONE:
            now = time.monotonic()
            if rospy.is_shutdown():
                return False
            if self._give_up_at is not None and now >= self._give_up_at:
                return False
            is_late = self._exec_timeout_s is not None and now >= started_at + self._exec_timeout_s
            if self._give_up_at is None and (is_late or self.preempt_requested()):
                if is_late:
                    rospy.logwarn(
                        "Action '%s' took longer than %g s: its goal is cancelled.",
                        self._action_name,
                        self._exec_timeout_s,
                    )
                self._cancel()
            deadlines = [] if self._give_up_at is None else [self._give_up_at]
            if self._exec_timeout_s is not None and self._give_up_at is None:
                deadlines.append(started_at + self._exec_timeout_s)
            self._wake.wait(max(0.0, min([SHUTDOWN_POLL_S] + [deadline - now for deadline in deadlines])))
            self._wake.clear()
        return True

    def _cancel(self) -> None:
        """Cancel the goal that runs, if there is one and that was not done yet."""
        with self._lock:
            handle = self._goal_handle
            if handle is None or self._give_up_at is not None:
                return
            self._give_up_at = time.monotonic() + self._preempt_timeout_s
            self._status = self.PREEMPTING
            # Under the lock of the goal: cancel() would take a goal that ends meanwhile out of its final state.
            with handle.comm_state_machine.mutex:
                if handle.get_comm_state() == actionlib.CommState.DONE:
                    return
                try:
                    handle.cancel()
                except rospy.ROSException as error:
                    # The topic is closed: the program ends.
                    rospy.logwarn("The goal of '%s' cannot be cancelled: %s", self._action_name, error)

    def _outcome(self, ud: Any, status: int, result: Any) -> str:
        try:
            chosen = self._result_sink.store(self, ud, status, result)
        except smach.InvalidUserCodeError as error:
            return self._end_early(str(error))
        outcome = "aborted"
        if status == GoalStatus.SUCCEEDED:
            outcome = "succeeded"
        elif status in (GoalStatus.PREEMPTED, GoalStatus.RECALLED) and self.preempt_requested():
            outcome = "preempted"
            self.service_preempt()
        return outcome if chosen is None else chosen

    def _end_early(self, reason: str) -> str:
        """Outcome of a state that has no terminal status of a goal."""
        # A goal that was cancelled and did not end in time still runs, for all that is known: no answer to a request.
        if self.preempt_requested() and (self._give_up_at is None or rospy.is_shutdown()):
            self.service_preempt()
            return "preempted"
        rospy.logerr("The state of the action '%s' aborts: %s", self._action_name, reason)
        return "aborted"
