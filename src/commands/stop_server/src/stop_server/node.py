"""The stop server node: "Stop." without parser, framer, registrar, arbitrator or executor.

Callbacks only enqueue; the thread of the brake stops the robot and answers.
"""

import queue
import threading
from dataclasses import dataclass
from typing import Dict, Optional, Sequence

import rospy
from roboframenet_msgs.msg import (
    Command,
    CommandStatus,
    ExecuteCommandActionGoal,
    Fleet,
    FrameServers,
    Reply,
    StopReport,
)
from std_msgs.msg import String

from command_server.beside_cries import words_not_done
from command_server.emergency_words import is_emergency_stop
from command_server.ros_orders_back import OrdersTakenBack, may_be_order_taken_back
from command_server.stop_words import is_stop
from roboframenet_ros.command_ids import TextIds, TextSource, came_by_action
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_publishing import publish
from roboframenet_ros.ros_robots import own_robot
from roboframenet_ros.ros_taken_texts import UntakenWatch
from roboframenet_ros.untaken_texts import Said
from robot_fleet.robot_names import Names
from robot_fleet.stops import stops
from robot_stop.braking import Finding, StopOrder
from robot_stop.ros_brake import Brake, Braked
from robot_stop.sentences import REST_NOT_DONE, may_still_move, sentence_of, sentence_of_rest
from robot_stop.settings import BrakeSettings
from stop_server.heard_once import HeardOnce
from stop_server.other_answers import OtherAnswers
from stop_server.ros_emergency import EmergencyKeeper
from stop_server.ros_stopping_frame import SERVER, StoppingFrame

STAGE = "stop_server"
_JOIN_TIMEOUT_S = 2.0
# How many stops are kept whose reports may be repeated.
_MOST_TOLD = 1000


@dataclass(frozen=True)
class _StopHeard:
    """A stop: `text` as it was said, `command_id` of a goal or empty, `findings` for one that came as a frame.

    `is_shared`: it was said to all robots of a fleet, and others reply to it. `is_emergency`: it engages the emergency
    stop.
    """

    text: str
    stamp: rospy.Time
    command_id: str = ""
    findings: "Optional[queue.Queue[Finding]]" = None
    is_shared: bool = False
    is_emergency: bool = False


@dataclass(frozen=True)
class _Told:
    """The part of a stop that later reports repeat."""

    heard: _StopHeard
    command: Command
    braked: Braked


class StopServerNode:
    """Stops the robot.

    Subscribes: ``text``, ``command/goal``, ``cry_heard``, ``frame_servers``, ``reply``, ``status``, ``text_taken``,
    ``command_server_started``; for a robot of a fleet also ``fleet_text``, ``fleet_command/goal``, ``fleet``.
    Publishes: ``stop_report``, ``reply``, ``<server>/cancel`` of the action servers, zero velocity. Actions:
    ``stopping``. And what an `EmergencyKeeper` does.
    """

    def __init__(self, settings: BrakeSettings) -> None:
        self._settings = settings
        self._stop_ids = TextIds(TextSource.STOP)
        self._untaken_ids = TextIds(TextSource.UNHEARD)
        self._lock = threading.Lock()
        self._heard: Dict[str, _StopHeard] = {}
        # Owned by the thread of the brake.
        self._told: Dict[str, _Told] = {}
        self._others = OtherAnswers()
        self._untaken = UntakenWatch(self._answer_untaken, on_start=self._hear_commander)
        self._heard_once = HeardOnce()
        self._orders_back = OrdersTakenBack()
        self._reply = rospy.Publisher("reply", Reply, queue_size=100)
        self._report = rospy.Publisher("stop_report", StopReport, queue_size=100)
        self._brake = Brake(settings, on_braked=self._report_stop, on_finding=self._report_finding)
        self._emergency = EmergencyKeeper(self._brake, on_engaged=self._hear_engaged)
        self._own_server = rospy.resolve_name(SERVER)
        self._frame = StoppingFrame(self._stop_for_frame)

    def start(self) -> None:
        """Subscribe."""
        rospy.on_shutdown(self._shutdown)
        self._brake.start()
        self._emergency.start()
        self._untaken.start(taken="text_taken", started="command_server_started")
        self._subscribers = [
            rospy.Subscriber("reply", Reply, self._hear_reply),
            rospy.Subscriber("status", CommandStatus, self._orders_back.hear_status),
            rospy.Subscriber("text", String, lambda message: self._hear(message.data, is_goal=False)),
            rospy.Subscriber(
                "command/goal",
                ExecuteCommandActionGoal,
                lambda message: self._hear(message.goal.text, is_goal=True, command_id=message.goal_id.id),
            ),
            rospy.Subscriber("cry_heard", Command, self._hear_of_cry, tcp_nodelay=True),
            rospy.Subscriber("frame_servers", FrameServers, self._hear_servers),
        ]
        self._robot = own_robot()
        self._names = Names({self._robot: ()})
        if self._robot:
            self._subscribers += [
                rospy.Subscriber("fleet_text", String, lambda message: self._hear_shared(message.data)),
                rospy.Subscriber(
                    "fleet_command/goal",
                    ExecuteCommandActionGoal,
                    lambda message: self._hear_shared(message.goal.text),
                ),
                rospy.Subscriber("fleet", Fleet, self._hear_fleet),
            ]
        self._frame.start()

    def _shutdown(self) -> None:
        self._emergency.close(timeout_s=_JOIN_TIMEOUT_S)
        self._brake.close(timeout_s=_JOIN_TIMEOUT_S)
        self._frame.close(timeout_s=_JOIN_TIMEOUT_S)
        self._untaken.close()

    def _hear(self, text: str, *, is_goal: bool, command_id: str = "") -> None:
        if is_stop(text) and not self._orders_back.is_meant(text):
            with self._lock:
                is_new = self._heard_once.hears(text, is_goal=is_goal, command_id=command_id)
            if is_new:
                self._stop_said(text, stamp=rospy.Time.now(), command_id=command_id)
        elif not command_id:
            self._untaken.hear(text)

    def _hear_of_cry(self, command: Command) -> None:
        """The command server has heard a cry: so has this node, or the client was not connected to it yet."""
        with self._lock:
            is_new = self._heard_once.is_told(command.text, is_goal=came_by_action(command.id), command_id=command.id)
        if is_new:
            self._stop_said(command.text, stamp=command.stamp, command_id=command.id)

    def _hear_shared(self, text: str) -> None:
        """Something was said to all robots: it may stop this one. Its reply is the business of others."""
        if stops(text, self._robot, self._names, is_taken_back=self._orders_back.is_meant):
            is_emergency = stops(text, self._robot, self._names, is_cry=is_emergency_stop)
            self._stop(_StopHeard(text, stamp=rospy.Time.now(), is_shared=True, is_emergency=is_emergency))

    def _hear_fleet(self, fleet: Fleet) -> None:
        named: Dict[str, Sequence[str]] = {self._robot: ()}
        named.update(dict.fromkeys(fleet.absent, ()))
        named.update({robot.name: robot.spoken_names for robot in fleet.robots})
        self._names = Names(named)

    def _hear_commander(self) -> None:
        with self._lock:
            self._heard_once.forget()

    def _answer_untaken(self, said: Said) -> None:
        now = rospy.Time.now()
        reply = Reply(
            command=Command(id=self._untaken_ids.next_id(), text=said.text, stamp=now),
            outcome=Reply.FAILED,
            stage=STAGE,
            code="RESTARTED",
            sentence="Nobody took that: command_server was being restarted. Please say it again.",
            stamp=now,
        )
        rospy.logwarn("cmd=%s %r: %s", reply.command.id, said.text, reply.sentence)
        publish(self._reply, reply)

    def _stop_said(self, text: str, *, stamp: rospy.Time, command_id: str) -> None:
        self._stop(_StopHeard(text, stamp, command_id, is_emergency=is_emergency_stop(text)))

    def _stop(self, heard: _StopHeard, *, except_server: str = "") -> None:
        with self._lock:
            key = self._stop_ids.next_id()
            self._heard[key] = heard
        self._brake.stop(StopOrder(key=key, stamp_ns=heard.stamp.to_nsec(), except_server=except_server))
        if heard.is_emergency:
            self._emergency.engage(f'"{heard.text.strip()}"')

    def _hear_engaged(self, by: str) -> None:
        """The emergency stop was engaged without an utterance: nobody waits for a reply."""
        rospy.logwarn("the emergency stop was engaged: %s", by)
        self._stop(_StopHeard(text="", stamp=rospy.Time.now(), is_shared=True))

    def _hear_reply(self, reply: Reply) -> None:
        if reply._connection_header["callerid"] == rospy.get_name():
            return
        self._untaken.hear_reply(reply)
        self._orders_back.hear_reply(reply)
        if reply.stage == STAGE or may_be_order_taken_back(reply.command):
            with self._lock:
                self._others.note(reply.command.id, reply.command.text, stamp_ns=reply.command.stamp.to_nsec())

    def _hear_servers(self, message: FrameServers) -> None:
        self._brake.servers.set_registered(
            frozenset(
                rospy.resolve_name(callback.callback_topic) for callback in message.callbacks if callback.callback_topic
            )
        )

    def _stop_for_frame(self) -> str:
        """Stop everything; returns why the robot may still move, empty when it stands still."""
        findings: queue.Queue[Finding] = queue.Queue()
        self._stop(_StopHeard(text="", stamp=rospy.Time.now(), findings=findings), except_server=self._own_server)
        try:
            finding = findings.get(timeout=self._settings.confirmation_timeout_s + _JOIN_TIMEOUT_S)
        except queue.Empty:
            return "The stop server hangs."
        return "" if finding.obedience.is_complete else self._sentence_of(finding, server_count=0)

    def _report_stop(self, braked: Braked) -> None:
        """Report at once that commands up to now must not run."""
        key = braked.order.key
        with self._lock:
            heard = self._heard.pop(key)
        told = _Told(
            heard=heard, braked=braked, command=Command(id=heard.command_id or key, stamp=heard.stamp, text=heard.text)
        )
        self._told[key] = told
        while len(self._told) > _MOST_TOLD:
            del self._told[next(iter(self._told))]
        if heard.findings is None:
            # The executor must not start the next step.
            self._report.publish(self._report_of(told))
        rospy.loginfo("stopped in %.1f ms, cancelled %s", 1000.0 * braked.took_s, list(braked.cancelled))

    def _report_finding(self, finding: Finding) -> None:
        """Reply to a stop when it is known which nodes obey, and report when that changes."""
        told = self._told[finding.order.key]
        sentence = self._sentence_of(finding, server_count=len(told.braked.cancelled))
        if told.heard.findings is not None:
            if finding.is_first:
                told.heard.findings.put(finding)
        elif not finding.is_first or not self._is_answered(told):
            report = self._report_of(told, finding=finding, sentence=sentence)
            if not finding.is_first or told.heard.is_shared:
                self._report.publish(report)
            elif told.heard.is_emergency:
                # It is written down before anybody may rely on it.
                self._emergency.call_when_written(lambda: self._reply_to(told, finding, report))
            else:
                self._reply_to(told, finding, report)
        if not finding.is_first or not finding.obedience.is_complete:
            rospy.logwarn("%s", sentence)

    def _reply_to(self, told: _Told, finding: Finding, report: StopReport) -> None:
        """Publish the reply to a stop, with its report."""
        rest = sentence_of_rest(words_not_done(told.heard.text))
        code = "NOT_STOPPED" if not finding.obedience.is_complete else REST_NOT_DONE if rest else "DONE"
        if told.heard.is_emergency and not self._emergency.is_written:
            code = "STAGE_ERROR" if finding.obedience.is_complete else code
        report.reply = Reply(
            command=told.command,
            stage=STAGE,
            sentence=" ".join(filter(None, [report.sentence, self._emergency.sentence, rest])),
            stamp=rospy.Time.now(),
            outcome=Reply.DONE if code == "DONE" else Reply.FAILED,
            code=code,
        )
        self._report.publish(report)
        self._reply.publish(report.reply)

    def _report_of(self, told: _Told, *, finding: Optional[Finding] = None, sentence: str = "") -> StopReport:
        return StopReport(
            command=told.command,
            stop_stamp=told.heard.stamp,
            cancelled_servers=list(told.braked.cancelled),
            disobeying=[] if finding is None else list(finding.obedience.names),
            sentence=sentence,
        )

    def _sentence_of(self, finding: Finding, *, server_count: int) -> str:
        if self._emergency.state.is_engaged and not finding.obedience.is_complete:
            return may_still_move(finding.obedience)
        return sentence_of(finding, server_count=server_count, limit_s=self._settings.zero_velocity_limit_s)

    def _is_answered(self, told: _Told) -> bool:
        """Whether the command server has replied already: this node seemed silent, or took an order back for a cry."""
        with self._lock:
            return self._others.take(
                told.heard.command_id,
                told.heard.text,
                stamp_ns=told.heard.stamp.to_nsec(),
                is_just_awake=told.braked.is_just_awake,
            )


def _start() -> StopServerNode:
    settings = read_parameters(BrakeSettings)
    rospy.loginfo("stop_server: %s", settings)
    node = StopServerNode(settings)
    node.start()
    return node


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("stop_server", _start)
