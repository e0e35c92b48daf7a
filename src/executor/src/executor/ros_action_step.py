"""A SMACH state that sends one frame to one action server."""

import contextlib
import queue
import time
from dataclasses import dataclass, replace
from typing import Callable

import actionlib
import rospy
from roboframenet_msgs.msg import FilledSemanticFrameGoal

import smach
from arbitrator.node_runs import OUTCOMES
from arbitrator.scopes import Scope
from executor import goal_tracking as tracking
from executor.driver_settings import SettingsError
from executor.goal_tracking import Goal, GoalDeadlines, Outcome
from executor.patience import Patience
from executor.quarantine import Quarantine
from executor.ros_action_clients import ActionClients
from executor.ros_driver_settings import DriverSettings
from executor.ros_goal_news import Death, Feedback, Sign, WakeUp, apply, header_text, read_transition
from executor.ros_running_goals import RunningGoals
from executor.ros_server_profiles import ServerProfiles
from roboframenet_ros.ros_action_connection import ActionConnection, SentGoal
from roboframenet_ros.suspension import SuspensionWatch
from typed_arguments import FilledFrame
from typed_arguments.ros_messages import frame_to_message

# Between two looks whether a server is connected.
_LOOK_S = 0.01
# The limits of the plan are looked at within this time.
_LONGEST_WAIT_S = 0.1
# A longer turn of the loop means that the process did not run.
_LONGEST_TURN_S = _LONGEST_WAIT_S + 0.4
# After a suspension, messages that arrived meanwhile are read within this time.
_WAKE_S = 0.5

# The outcome of the state. A goal that another client cancelled must not start the next candidate.
SMACH_OUTCOME_OF = {
    Outcome.SUCCEEDED: "succeeded",
    Outcome.FAILED: "aborted",
    Outcome.PREEMPTED: "preempted",
    Outcome.TAKEN_AWAY: "preempted",
}


@dataclass(frozen=True)
class StepContext:
    """What the steps of one run share.

    Attributes:
        clients: connections to servers
        settings: what the servers need of other nodes
        running_goals: what must be cancelled if this process is killed
        deadlines: of each goal
        profiles: what the servers stated when they registered
        quarantine: servers that are out of use
        patience: how long the command may go on
        suspension: whether this process has just been resumed
        earliest_stamp_ns: no goal is stamped earlier, nanoseconds of ROS time
        begin: called with the frame of each step that starts and the number of its clause; returns whether it may
        on_sent: called with the frame of each goal when it was sent
        on_end: called with the frame, the number of its node in the plan, and the goal that has ended
    """

    clients: ActionClients
    settings: DriverSettings
    running_goals: RunningGoals
    deadlines: GoalDeadlines
    profiles: ServerProfiles
    quarantine: Quarantine
    patience: Patience
    suspension: SuspensionWatch
    earliest_stamp_ns: int
    begin: Callable[[FilledFrame, int], bool]
    on_sent: Callable[[FilledFrame], None]
    on_end: Callable[[FilledFrame, int, Goal], None]


class ActionStep(smach.State):
    """Sends the frame as a goal and follows it to its end.

    Callbacks only enqueue; the thread that executes the state owns everything else and waits with deadlines.
    """

    def __init__(self, frame: FilledFrame, number: int, scope: Scope, context: StepContext) -> None:
        """
        Args:
            frame: the goal
            number: of the clause in the plan
            scope: the goal is cancelled with it
            context: of the run
        """
        super().__init__(outcomes=list(OUTCOMES))
        self._frame = frame
        self._number = number
        self._scope = scope
        self._context = context

    def execute(self, userdata: smach.UserData) -> str:
        """Carry the frame out; returns succeeded, aborted or preempted."""
        if not self._context.begin(self._frame, self._number):
            # Nothing begins any more; what still runs ends first, and then the whole plan.
            self._scope.wait(self._number, lambda: False)
            return _preempted(self)
        began_s = time.monotonic()
        goal = self._carry_out()
        self._context.patience.spend(goal, time.monotonic() - began_s)
        self._context.on_end(self._frame, self._number, goal)
        outcome = SMACH_OUTCOME_OF[goal.outcome]
        return _preempted(self) if outcome == "preempted" else outcome

    @property
    def _is_to_end(self) -> bool:
        self._scope.tick()
        return self._scope.is_cancelled

    def _pause(self, duration_s: float) -> None:
        """Wait, unless the step is to end."""
        self._scope.wait(self._number, lambda: False, time.monotonic() + duration_s)

    def _read_news(self) -> bool:
        """After a suspension, wait for messages that arrived meanwhile; returns whether the command was closed."""
        if self._context.suspension.is_just_awake(within_s=_WAKE_S):
            self._pause(_WAKE_S)
        return self._is_to_end

    def _carry_out(self) -> Goal:
        server, deadlines = self._frame.server, self._context.deadlines
        self._read_news()
        began_s = time.monotonic()
        if self._is_to_end:
            return tracking.preempt_unsent(server, deadlines, now_s=began_s)
        refusal = self._context.patience.refusal() or self._context.quarantine.refusal(server)
        if refusal:
            return tracking.withhold(server, deadlines, refusal, now_s=began_s)
        try:
            connection = self._context.clients.get(server, timeout_s=deadlines.acceptance_s)
        except ValueError as error:
            return tracking.fail_unsent(server, deadlines, f"cannot be reached: {error}", now_s=began_s)
        if connection is None:
            return tracking.fail_unsent(
                server, deadlines, "cannot be reached: the master does not answer", now_s=began_s
            )
        try:
            return self._carry_out_over(connection)
        finally:
            self._context.clients.release(server)

    def _carry_out_over(self, connection: ActionConnection) -> Goal:
        server, deadlines = self._frame.server, self._context.deadlines
        reason = self._context.clients.wait_until_ready(
            connection,
            timeout_s=deadlines.acceptance_s,
            pause=lambda: self._pause(_LOOK_S),
            is_over=lambda: self._is_to_end,
        )
        if self._is_to_end:
            return tracking.preempt_unsent(server, deadlines, now_s=time.monotonic())
        if reason:
            return tracking.fail_unsent(server, deadlines, reason, now_s=time.monotonic())
        owner = f"{self._frame.name} by {server}"
        try:
            self._context.settings.apply(server, owner=owner, stated=self._context.profiles.settings(self._frame))
        except SettingsError as error:
            return tracking.fail_unsent(
                server, deadlines, f"cannot get its driver settings: {error}", now_s=time.monotonic()
            )
        try:
            return self._send_and_follow(connection)
        finally:
            self._context.settings.restore(owner=owner)

    def _send_and_follow(self, connection: ActionConnection) -> Goal:
        inbox: queue.SimpleQueue[object] = queue.SimpleQueue()

        def on_sign() -> None:
            inbox.put(Sign())

        def on_cancel() -> None:
            inbox.put(WakeUp())

        connection.listen(on_sign)
        self._scope.listen(on_cancel)
        try:
            return self._follow(connection, inbox)
        finally:
            connection.unlisten(on_sign)
            self._scope.unlisten(on_cancel)

    def _follow(self, connection: ActionConnection, inbox: "queue.SimpleQueue[object]") -> Goal:
        if self._read_news():
            return tracking.preempt_unsent(self._frame.server, self._context.deadlines, now_s=time.monotonic())
        of_each = self._context.deadlines
        longest_s = self._context.profiles.longest_goal_s(self._frame, of_each.execution_s)
        deadlines = self._context.patience.deadlines(replace(of_each, execution_s=longest_s))
        uri = connection.node_uri()
        if not uri:
            # Whoever is connected next is another process, and does not know the goal.
            return tracking.fail_unsent(self._frame.server, deadlines, "has died", now_s=time.monotonic())
        goal = tracking.send(self._frame.server, deadlines, now_s=time.monotonic())
        sent: SentGoal = connection.send(
            FilledSemanticFrameGoal(frame=frame_to_message(self._frame)),
            header_text=header_text(self._frame),
            earliest_stamp_ns=self._context.earliest_stamp_ns,
            on_transition=lambda handle: self._hear(handle, inbox),
            on_feedback=lambda feedback: inbox.put(Feedback(bool(feedback.is_succeeding))),
        )
        self._context.running_goals.note(self._frame.server, sent.goal_id)
        self._context.on_sent(self._frame)
        try:
            return self._follow_sent(connection, sent, goal, inbox, uri)
        finally:
            self._context.running_goals.forget(sent.goal_id)

    def _follow_sent(
        self, connection: ActionConnection, sent: SentGoal, goal: Goal, inbox: "queue.SimpleQueue[object]", uri: str
    ) -> Goal:
        """Follow a goal to its end.

        Args:
            connection: to its server
            sent: the goal
            goal: its state
            inbox: of news
            uri: address of the process that got it
        """
        asked_s = float("-inf")
        suspension = SuspensionWatch(longest_turn_s=_LONGEST_TURN_S)
        while True:
            goal = tracking.postpone(goal, suspension.turn())
            connected_uri = connection.node_uri()
            if self._is_to_end:
                goal = tracking.ask_preempt(goal, now_s=time.monotonic())
            step = tracking.tick(goal, now_s=time.monotonic())
            goal = step.goal
            if step.is_cancel_due:
                rospy.loginfo("cancelling the goal of %s", self._frame.server)
                connection.cancel(sent)
            if goal.is_ended:
                if goal.is_orphaned:
                    self._quarantine(goal, sent)
                return goal
            # One that died and was started again is not silent: the new process publishes its status.
            is_lost = connected_uri != uri and time.monotonic() - asked_s >= goal.deadlines.suspicion_s
            if step.is_question_due or is_lost:
                asked_s = time.monotonic()
                connection.ask_whether_gone(uri, lambda: inbox.put(Death()))
            wait_s = min(_LONGEST_WAIT_S, max(0.001, tracking.next_deadline_s(goal) - time.monotonic()))
            with contextlib.suppress(queue.Empty):
                goal = apply(goal, inbox.get(timeout=wait_s))

    def _hear(self, handle: actionlib.ClientGoalHandle, inbox: "queue.SimpleQueue[object]") -> None:
        transition = read_transition(handle)
        inbox.put(transition)
        if transition.is_done:
            # This may come long after the step has ended.
            self._context.quarantine.hear_end(self._frame.server, handle.comm_state_machine.action_goal.goal_id.id)

    def _quarantine(self, goal: Goal, sent: SentGoal) -> None:
        self._context.quarantine.put(goal.server, sent.goal_id, goal.reason, keep=sent)
        if sent.handle.get_comm_state() == actionlib.CommState.DONE:
            self._context.quarantine.hear_end(goal.server, sent.goal_id)


def _preempted(state: smach.State) -> str:
    if state.preempt_requested():
        state.service_preempt()
    return "preempted"
