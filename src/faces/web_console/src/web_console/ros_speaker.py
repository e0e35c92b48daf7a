"""Says sentences, cancels commands, and stops the robot, whoever of the pipeline lives."""

import time
import uuid
from typing import Callable

import rospy
from actionlib_msgs.msg import GoalID
from roboframenet_msgs.msg import ExecuteCommandActionGoal, ExecuteCommandGoal, StopReport
from std_msgs.msg import String

from command_server.emergency_words import is_emergency_stop
from command_server.stop_words import is_stop
from robot_stop.braking import Finding, StopOrder
from robot_stop.ros_brake import Brake, Braked
from robot_stop.sentences import STOPPED_CODES, sentence_of
from robot_stop.settings import BrakeSettings
from web_console.views import StopView

#: The command server gives the stop server 0.15 s, then stops the robot itself; after that nobody else is left.
_SILENCE_S = 0.3
#: How long the confirmation of a stop may take beyond that of the brake.
_SLACK_S = 2.0
#: Ids of goals of pages begin with this.
_PREFIX = "console"

Later = Callable[[float, Callable[[], None]], None]


class Speaker:
    """Publishes what pages ask for. All methods are for the thread of the event loop.

    Publishes: ``command/goal``, ``command/cancel``, ``text`` (only "Stop." and "Emergency stop."), and what a `Brake`
    does.
    """

    def __init__(
        self,
        settings: BrakeSettings,
        *,
        call_soon: Callable[..., None],
        call_later: Later,
        on_stop: Callable[[StopView], None],
    ) -> None:
        """Connect.

        Args:
            settings: of the brake
            call_soon: calls a function in the thread of the event loop, from any thread
            call_later: calls a function in that thread after some seconds
            on_stop: called with what is known of a stop
        """
        self._settings = settings
        self._call_later = call_later
        self._on_stop = on_stop
        self._tag = f"{_PREFIX}-{uuid.uuid4().hex[:8]}"
        self._count = 0
        self._stop = StopView()
        self._is_answered, self._stays = True, False
        self._goal = rospy.Publisher("command/goal", ExecuteCommandActionGoal, queue_size=100)
        self._cancel = rospy.Publisher("command/cancel", GoalID, queue_size=100)
        self._text = rospy.Publisher("text", String, queue_size=100, tcp_nodelay=True)
        self._brake = Brake(
            settings,
            on_braked=lambda braked: call_soon(self._hear_braked, braked),
            on_finding=lambda finding: call_soon(self._hear_finding, finding),
        )

    def start(self) -> None:
        """Connect to what a stop needs."""
        self._brake.start()

    def close(self) -> None:
        """End the threads of the brake."""
        self._brake.close(timeout_s=1.0)

    def say(self, text: str) -> str:
        """Say a sentence; returns the id of the command, empty when nobody listens."""
        if is_stop(text):
            self._watch_stop(stays=is_emergency_stop(text))
        if self._goal.get_num_connections() == 0:
            return ""
        self._count += 1
        now = rospy.Time.now()
        goal_id = GoalID(stamp=now, id=f"{self._tag}-{self._count}")
        goal = ExecuteCommandActionGoal(goal_id=goal_id, goal=ExecuteCommandGoal(text=text))
        goal.header.stamp = now
        self._goal.publish(goal)
        return str(goal_id.id)

    def cancel(self, command_id: str) -> None:
        """Cancel a command."""
        self._cancel.publish(GoalID(id=command_id))

    def stop(self, *, stays: bool) -> None:
        """Stop the robot: by the stop server, by the command server, or else by the brake of this node.

        Args:
            stays: whether the stop is to hold; the brake of this node cannot do that
        """
        self._text.publish(String(data="Emergency stop." if stays else "Stop."))
        self._watch_stop(stays=stays)

    def _watch_stop(self, *, stays: bool) -> None:
        self._is_answered, self._stays = False, stays
        self._tell(StopView(self._stop.number + 1, "sent", "Stopping ..."))
        number = self._stop.number
        # With nobody there, there is nothing to wait for.
        self._call_later(_SILENCE_S if self._text.get_num_connections() else 0.0, lambda: self._stop_here(number))
        self._call_later(_SILENCE_S + self._settings.confirmation_timeout_s + _SLACK_S, lambda: self._give_up(number))

    def _tell(self, stop: StopView) -> None:
        self._stop = stop
        self._on_stop(stop)

    def hear_report(self, report: StopReport) -> None:
        """The stop server has stopped the robot, or knows more about it."""
        self._is_answered = True
        if report.reply.command.id:
            state = "stopped" if report.reply.code in STOPPED_CODES else "not_stopped"
            self._tell(StopView(max(1, self._stop.number), state, report.reply.sentence))
        elif report.sentence:
            state = "not_stopped" if report.disobeying else "stopped"
            self._tell(StopView(max(1, self._stop.number), state, report.sentence))

    def _stop_here(self, number: int) -> None:
        if not self._is_answered and number == self._stop.number:
            self._brake.stop(StopOrder(key=f"{number} {time.monotonic()}", stamp_ns=rospy.Time.now().to_nsec()))

    def _hear_braked(self, _braked: Braked) -> None:
        if not self._is_answered:
            self._tell(
                StopView(self._stop.number, "sent", "stop_server does not answer; this page stops the robot itself ...")
            )

    def _hear_finding(self, finding: Finding) -> None:
        if not self._is_answered:
            state = "stopped" if finding.obedience.is_complete else "not_stopped"
            sentence = sentence_of(finding, server_count=1, limit_s=self._settings.zero_velocity_limit_s)
            if finding.obedience.is_complete:
                sentence = "Stopped: zero velocity, and no goal is left."
            if self._stays:
                sentence += " The emergency stop is not engaged: nobody holds the robot."
            self._tell(
                StopView(self._stop.number, state, f"{sentence} stop_server did not answer; this page did it itself.")
            )

    def _give_up(self, number: int) -> None:
        if number == self._stop.number and self._stop.state == "sent":
            self._tell(
                StopView(number, "unknown", "Nobody confirms that the robot stands still. Use its emergency stop.")
            )
