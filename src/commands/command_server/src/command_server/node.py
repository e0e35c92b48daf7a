"""The command server node: accepts commands, and gives exactly one reply to each.

Callbacks only enqueue; one worker thread owns the commands.
"""

import threading
import time
from dataclasses import replace
from typing import Tuple, Union

import rospy
from roboframenet_msgs.msg import (
    CommandLexicalUnits,
    CommandPlan,
    OrderDue,
    Reply,
    StageEvent,
    StoppedPlan,
    StopReport,
)
from std_msgs.msg import String

from command_server.emergency_words import is_release
from command_server.follow_ups import FollowUps
from command_server.inbox import Inbox
from command_server.open_commands import (
    OWN_STAGE,
    CommandText,
    Ending,
    OpenCommands,
    Outcome,
    ending_at_shutdown,
    ending_of_cancelled,
    refusal_of_delay,
    refusal_of_text,
    stamp_after,
)
from command_server.orders_back import SPARED_NS, order_words, said_behind
from command_server.pending_stops import PendingStops
from command_server.ros_called_frames import CalledFrames
from command_server.ros_cancel_topic import CancelTopic
from command_server.ros_command_action import CommandActionServer
from command_server.ros_emergency import RELEASE_TIMEOUT_S, EmergencyGate, Released
from command_server.ros_events import GoalCancelled, Said, said_by_goal, said_by_text
from command_server.ros_going_on import StoppedPlans
from command_server.ros_language_service import LanguageService
from command_server.ros_left_over import EXECUTOR_TIMEOUT_S, LeftOver
from command_server.ros_messages import ending_of_event, reply_of_stopped
from command_server.ros_open_commands import OpenCommandStore
from command_server.ros_orders_back import takes_back
from command_server.ros_orders_due import OrdersDue
from command_server.ros_replayed import Replayed
from command_server.ros_replies import Replies
from command_server.ros_stops_in_place import StopsInPlace
from command_server.ros_texts_out import TextsOut
from command_server.settings import Settings
from command_server.stop_words import find_cry
from command_server.withdrawals import Withdrawals, is_against_what_runs
from roboframenet_ros.command_ids import TextIds, TextSource
from roboframenet_ros.health import Health
from roboframenet_ros.ros_hand_over import HandOver
from roboframenet_ros.suspension import SuspensionWatch
from robot_stop.braking import Finding, StopOrder
from robot_stop.emergency import CODE as EMERGENCY_STOP
from robot_stop.ros_brake import Brake, Braked
from robot_stop.sentences import STOPPED_CODES, may_still_move
from robot_stop.settings import BrakeSettings

# How often the worker looks at what tells nothing: who is connected. While nothing is open, that can wait.
_LONGEST_WAIT_S, _IDLE_WAIT_S = 0.2, 1.0
# A longer turn of the worker means that the process was suspended.
_LONGEST_TURN_S = 2.0
# A stop is answered within this multiple of its time-out: for its report, then for its reply.
_WAIT_FOR_STOP = 3.0
# How long a brake may take to report which nodes obey, beyond its own time-out.
_BRAKE_SLACK_S = 1.0
# At the end: for the worker, and for the last messages to leave the process.
_JOIN_TIMEOUT_S, _FLUSH_S = 5.0, 0.1
_ALL_STOPPED = "Everything that it had started is stopped: zero velocity, and no goal is left."
# Key of the stop for commands of the previous run; other stops have the id of their command.
_RESTART_KEY = "restart"

_Event = Union[
    Said,
    GoalCancelled,
    CommandLexicalUnits,
    StageEvent,
    StopReport,
    OrderDue,
    StoppedPlan,
    Released,
    Braked,
    Finding,
    None,
]


class CommandServerNode:
    """Owns the commands.

    Subscribes: ``text``, ``called_frames``, ``called_frames/cancel``, ``stage_events``, ``stop_report``, ``order_due``,
    ``stopped_plan``, ``fleet_service``.
    Publishes: ``command_text``, ``command_lexical_units``, ``reply``, ``command_cancel``, ``command_plan``, ``status``,
    ``text_taken``, ``command_server_started``, and what a `Brake` and an `EmergencyGate` do. Actions: ``command``.
    """

    def __init__(self, settings: Settings, brake_settings: BrakeSettings, *, private: str = "~") -> None:
        """
        Args:
            settings: its own
            brake_settings: what a stop applies to
            private: prefix of its private names
        """
        self._settings = settings
        self._commands = OpenCommands(settings.stage_timeouts_s)
        self._stops = PendingStops(timeout_s=settings.stop_timeout_s)
        self._last_stop_ns = self._last_stamp_ns = 0
        self._follow_ups = FollowUps(pause_s=settings.pause_after_stop_s)
        self._withdrawals = Withdrawals(timeout_s=settings.cancel_timeout_s)
        self._store = OpenCommandStore(private + "open_commands")
        self._saved: Tuple[CommandText, ...] = ()
        self._text_ids = TextIds(TextSource.TEXT)
        self._events: Inbox[_Event] = Inbox()
        self._suspension = SuspensionWatch(longest_turn_s=_LONGEST_TURN_S)
        self._worker = threading.Thread(target=self._work, name="command_server_worker")
        self._texts, self._language = TextsOut(), LanguageService()
        command_plan = HandOver("command_plan", CommandPlan)
        self._stopped_plans = StoppedPlans(self._commands, command_plan, on_declined=self._conclude)
        self._cancels, self._replies = CancelTopic(), Replies()
        self._replayed = Replayed(self._replies, settings)
        self._brake = Brake(brake_settings, on_braked=self._events.put, on_finding=self._events.put)
        self._emergency = gate = EmergencyGate(self._brake, on_released=self._events.put)
        self._orders_due = OrdersDue(self._commands, command_plan, gate.refusal, on_not_begun=self._conclude)
        self._called = CalledFrames(self._commands, settings, gate.refusal, on_not_begun=self._conclude)
        self._brake_answer_s = brake_settings.confirmation_timeout_s + _BRAKE_SLACK_S
        self._in_place = StopsInPlace(
            self._stops,
            self._brake,
            gate,
            timeout_s=settings.stop_timeout_s,
            brake_answer_s=self._brake_answer_s,
            limit_s=brake_settings.zero_velocity_limit_s,
        )
        self._start_ns = rospy.Time.now().to_nsec()
        left_over = self._store.load()
        self._left_over = LeftOver(left_over, self._replies.publisher)
        for command in left_over:
            self._commands.adopt(command, timeout_s=EXECUTOR_TIMEOUT_S + self._brake_answer_s)
            self._cancels.cancel(command)
        self._action = CommandActionServer(
            on_goal=lambda handle: self._events.put(said_by_goal(handle)),
            on_cancel=lambda command_id: self._events.put(GoalCancelled(command_id)),
        )

    def start(self) -> None:
        """Start to accept commands."""
        rospy.on_shutdown(self._shutdown)
        self._brake.start()
        self._worker.start()
        self._subscribers = [
            *self._called.subscribe(self._events.put),
            rospy.Subscriber("stage_events", StageEvent, self._events.put),
            rospy.Subscriber("stop_report", StopReport, self._events.put),
            rospy.Subscriber("order_due", OrderDue, self._events.put),
            rospy.Subscriber("stopped_plan", StoppedPlan, self._events.put),
            rospy.Subscriber("text", String, lambda message: self._events.put(said_by_text(message))),
        ]
        self._replies.tell_start()
        self._action.start()

    def health(self) -> Health:
        """How the node is."""
        values = {"open commands": len(self._saved), "last reply": self._replies.last_reply.code}
        return self._emergency.health(values)

    def _shutdown(self) -> None:
        self._events.put(None)
        self._worker.join(_JOIN_TIMEOUT_S)
        self._brake.close(timeout_s=1.0)
        self._store.close()

    def _work(self) -> None:
        while True:
            events = self._events.take(
                longest_wait_s=_IDLE_WAIT_S if self._is_idle() else _LONGEST_WAIT_S,
                deadlines_s=(
                    self._commands.next_deadline_s(),
                    self._stops.next_deadline_s(),
                    self._follow_ups.next_due_s(),
                    self._withdrawals.next_deadline_s(),
                    self._replies.next_status_s(),
                ),
            )
            self._excuse_suspension()
            for event in events:
                if event is None:
                    self._answer_all_at_shutdown()
                    return
                try:
                    self._handle(event)
                except Exception as error:  # boundary: one event must not keep the others from being handled
                    kind, fault = type(event).__name__, type(error).__name__
                    rospy.logerr("command_server could not handle a %s: %s: %s", kind, fault, error)
            # The stages work while this thread looks after everything else.
            self._send()
            self._cancel_silent()
            for ending in self._in_place.turn():
                self._answer(ending)
                self._pass_on_answer(ending.command.command_id, self._replies.last_reply)
            for command in self._follow_ups.take_due():
                refusal = self._emergency.refusal(command)
                if refusal is not None:
                    self._conclude(refusal)
                    continue
                self._commands.begin(command)
                self._texts.add(command)
            for ending in self._withdrawals.take_overdue():
                self._conclude(ending)
            if self._left_over.take_brake(is_executor_connected=self._cancels.is_heard):
                self._brake.stop(StopOrder(key=_RESTART_KEY, stamp_ns=self._start_ns, is_for_frames_only=True))
            for ending in self._left_over.take_answers():
                self._answer(ending)
            self._send()
            self._replies.publish_status(self._commands.open_commands)

    def _is_idle(self) -> bool:
        """Whether nothing waits but what has a deadline, or comes as an event."""
        return not (self._commands.open_commands or self._in_place.is_busy or self._left_over.is_waiting)

    def _handle(self, event: _Event) -> None:
        if isinstance(event, Said):
            self._hear(event)
        elif isinstance(event, GoalCancelled):
            self._cancel(self._action.command_of(event.command_id))
        elif isinstance(event, StageEvent):
            self._hear_stage(event)
        elif isinstance(event, StopReport):
            self._hear_stop_report(event)
        elif isinstance(event, OrderDue) and not self._replayed.refuses_order(event):
            self._orders_due.begin(event, stop_stamp_ns=self._last_stop_ns)
        elif isinstance(event, CommandLexicalUnits) and not self._replayed.refuses_call(event):
            self._called.begin(event, stop_stamp_ns=self._last_stop_ns)
        elif isinstance(event, StoppedPlan):
            self._stopped_plans.hear(event)
        elif isinstance(event, Released):
            self._conclude(event.ending)
        elif isinstance(event, Braked):
            self._in_place.hear_braked(event)
        elif isinstance(event, Finding):
            self._hear_finding(event)

    def _hear(self, said: Said) -> None:
        cry = find_cry(said.text)
        # A stop is a stop, whoever repeats it.
        if said.handle is not None and cry is None and self._replayed.refuses_goal(said.handle):
            return
        self._last_stamp_ns = stamp_after(said.arrival_ns, self._last_stamp_ns)
        if said.handle is not None:
            command_id = said.handle.get_goal_id().id
            self._action.accept(said.handle)
        else:
            command_id = self._text_ids.next_id()
            self._replies.note_taken(command_id, said.text, heard_s=said.arrival_s)
        refusal = refusal_of_text(said.text, max_length=self._settings.max_text_length) or refusal_of_delay(
            said.delay_s, longest_s=self._replayed.longest_delay_s
        )
        command = CommandText(command_id, self._last_stamp_ns, said.text[: self._settings.max_text_length])
        self._replies.note_heard(command)
        is_free = not self._commands.open_commands
        is_order_meant = refusal is None and takes_back(said.text, self._replies.last_reply, is_free=is_free)
        if refusal is None and is_release(said.text):
            self._commands.open(command)
            self._commands.extend(command.command_id, timeout_s=RELEASE_TIMEOUT_S)
            self._emergency.release(command, is_played=said.is_played, suspension=self._suspension)
        elif self._emergency.sentence and (cry is None or is_order_meant):
            self._answer_at_once(command, Outcome.REFUSED, code=EMERGENCY_STOP, sentence=self._emergency.sentence)
        elif is_order_meant:
            command = replace(command, stamp_ns=command.stamp_ns + SPARED_NS)
            self._last_stamp_ns = command.stamp_ns
            self._commands.open(command)
            self._texts.add(replace(command, text=order_words(command.text)))
        elif cry is not None:
            self._replies.tell_cry(command)
            # Of a text that was cut, the rest is no command.
            self._hear_stop(
                command,
                behind="" if command.text != said.text else said_behind(cry),
                is_action=said.handle is not None,
                heard_s=said.arrival_s,
            )
        elif refusal is not None:
            self._answer_at_once(command, Outcome.REFUSED, code=refusal[0], sentence=refusal[1])
        elif len(self._commands.open_commands) >= self._settings.max_open_commands:
            sentence = "Too many commands are waiting already."
            self._answer_at_once(command, Outcome.FAILED, code="BUSY", sentence=sentence)
        elif not (self._stopped_plans.takes(command) or self._language.declines(command, self._answer_at_once)):
            self._commands.open(command)
            self._texts.add(command)
            self._replies.note(f"Heard {command.text!r}.")

    def _hear_stop(self, command: CommandText, *, behind: str, is_action: bool, heard_s: float) -> None:
        # The stop server and the executor hear it too. But a command that was said just before the stop may reach this
        # node after the report of the stop server, so each open command is cancelled by name.
        for entry in self._commands.open_commands:
            self._cancels.cancel(entry.command)
        for ending in self._commands.finish_stopped(command.stamp_ns):
            self._answer(ending)
        self._replies.note(f"Stopping; then {behind!r}." if behind else "Stopping.")
        if behind:
            follow_up = self._follow_ups.add(behind, stop=command, stop_stamp_ns=self._last_stop_ns)
            self._commands.open(follow_up)
            self._commands.extend(
                follow_up.command_id,
                timeout_s=_WAIT_FOR_STOP * self._settings.stop_timeout_s
                + self._brake_answer_s
                + self._settings.pause_after_stop_s,
            )
            if is_action:
                self._action.hand_over(command.command_id, command_id=follow_up.command_id)
        early = self._stops.hear_stop(
            command.command_id, command.text, stamp_ns=command.stamp_ns, is_action=is_action, heard_s=heard_s
        )
        if early is not None:
            is_last = self._replies.last_reply.command.id == early
            self._pass_on_answer(command.command_id, self._replies.last_reply if is_last else reply_of_stopped(early))

    def _pass_on_answer(self, stop_id: str, reply: Reply) -> None:
        """The stop server has replied to a stop: its goal ends, and the command after it starts."""
        self._action.finish(reply, command_id=stop_id)
        for ending in self._follow_ups.hear_answer(
            stop_id, is_stopped=reply.code in STOPPED_CODES, reason=reply.sentence
        ):
            self._conclude(ending)

    def _hear_stop_report(self, report: StopReport) -> None:
        self._last_stop_ns = report.stop_stamp.to_nsec()
        spared = self._follow_ups.spared_by(report.command.text, self._last_stop_ns)
        for ending in self._commands.finish_stopped(self._last_stop_ns, spared=spared):
            # An executor that is being restarted hears of the stop only by this.
            self._cancels.cancel(ending.command)
            self._answer(ending)
        stop = None
        if report.reply.command.id:
            stop = self._stops.hear_reply(report.reply.command.id, report.reply.command.text)
            if stop is not None:
                self._pass_on_answer(stop.command_id, report.reply)
            self._replies.last_reply = report.reply
            self._replies.note(report.reply.sentence)
        elif report.sentence:
            self._replies.note(report.sentence)
        else:
            stop = self._stops.hear_report(report.command.id, report.command.text)
            self._replies.note("Stopping.")
        if stop is not None:
            self._in_place.drop(stop.command_id)

    def _cancel(self, command_id: str) -> None:
        entry = self._commands.get(command_id)
        if entry is None:
            return
        self._cancels.cancel(entry.command)
        self._stopped_plans.going_on.hear_cancelled(command_id)
        if entry.may_be_planned:
            # The executor ends it, when the robot has stopped if it had begun; its deadline still holds.
            return
        self._conclude(ending_of_cancelled(entry.command))

    def _hear_stage(self, event: StageEvent) -> None:
        self._texts.drop(event.command.id)
        entry = self._commands.get(event.command.id)
        is_done = event.is_final and event.reply.outcome == Reply.DONE
        if entry is None and self._replayed.tells(event):
            return
        if entry is None or (self._withdrawals.is_waiting(event.command.id) and not is_done):
            rospy.logdebug("cmd=%s waits for no stage; event of %s dropped", event.command.id, event.stage)
            return
        self._action.feed_back(event)
        if not event.is_final:
            self._commands.progress(event.command.id, event.stage)
            self._replies.note(event.sentence)
            return
        ending = replace(ending_of_event(event), command=entry.command)
        if not entry.may_have_started:
            ending = self._stopped_plans.going_on.asked(ending, stop_stamp_ns=self._last_stop_ns)
        if entry.verdict is not None or not self._withdraw(ending):
            self._conclude(ending)

    def _withdraw(self, ending: Ending) -> bool:
        """End what a command takes back or forbids; returns whether its reply must wait for that."""
        if not is_against_what_runs(ending):
            return False
        older = self._withdrawals.begin(ending, [entry.command for entry in self._commands.open_commands])
        if older:
            self._commands.hold(ending.command.command_id, timeout_s=2.0 * self._settings.cancel_timeout_s)
        for command in older:
            self._cancel(command.command_id)
        return bool(older)

    def _conclude(self, ending: Ending) -> None:
        """Close an open command and answer it; nothing when it is closed already."""
        closed = self._commands.finish(ending)
        if closed is not None:
            self._answer(closed)

    def _answer_at_once(self, command: CommandText, outcome: Outcome, *, code: str, sentence: str) -> None:
        self._commands.open(command)
        ending = Ending(command=command, outcome=outcome, stage=OWN_STAGE, code=code, sentence=sentence)
        if not self._withdraw(ending):
            self._conclude(ending)

    def _excuse_suspension(self) -> None:
        """Extend all deadlines by the time in which this process was suspended: messages from then are still unread."""
        away_s = self._suspension.turn()
        if away_s:
            rospy.logwarn("this process did not run for %.1f s", away_s)
            self._commands.postpone(away_s)
            self._stops.postpone(away_s)

    def _cancel_silent(self) -> None:
        """Close commands whose stage is silent: everything they started is cancelled before they are answered."""
        for entry in self._commands.condemn_silent(timeout_s=self._brake_answer_s):
            command_id = entry.command.command_id
            self._cancels.cancel(entry.command)
            if not entry.may_have_started:
                remark = "It was not started."
                if not self._withdraw(entry.ending(entry.verdict, remark)):
                    self._answer_condemned(command_id, remark)
                continue
            # An executor that hangs cannot cancel its goals.
            self._brake.stop(StopOrder(key=command_id, stamp_ns=rospy.Time.now().to_nsec(), is_for_frames_only=True))
        for command_id in self._commands.overdue_condemned():
            self._answer_condemned(command_id, "I do not know whether the robot still moves.")

    def _hear_finding(self, finding: Finding) -> None:
        """The brake reports which nodes obey."""
        key, is_stopped = finding.order.key, finding.obedience.is_complete
        self._in_place.hear_finding(finding)
        if not finding.is_first:
            self._replies.note("The robot stands still now." if is_stopped else may_still_move(finding.obedience))
            return
        remark = _ALL_STOPPED if is_stopped else may_still_move(finding.obedience)
        for entry in self._commands.open_commands:
            if key in (entry.command.command_id, _RESTART_KEY) and entry.command.stamp_ns <= finding.order.stamp_ns:
                self._answer_condemned(entry.command.command_id, remark)

    def _answer_condemned(self, command_id: str, remark: str) -> None:
        ending = self._commands.finish_condemned(command_id, remark)
        if ending is not None:
            self._answer(ending)

    def _answer(self, ending: Ending) -> None:
        """Give the one reply to a command that is closed."""
        self._follow_ups.forget(ending.command.command_id)
        if not self._left_over.hold(ending):
            self._publish_reply(ending)
        for held in self._withdrawals.hear_end(ending):
            self._conclude(held)

    def _publish_reply(self, ending: Ending) -> None:
        self._texts.drop(ending.command.command_id)
        self._action.finish(self._replies.publish(ending), command_id=ending.command.command_id)

    def _send(self) -> None:
        """Save which commands are open, and send what is new to the parser."""
        open_ones = tuple(entry.command for entry in self._commands.open_commands)
        before, self._saved = self._saved, self._left_over.commands + open_ones
        if self._saved != before:
            self._store.save(self._saved)
        self._texts.send()

    def _answer_all_at_shutdown(self) -> None:
        open_commands = self._commands.open_commands
        for entry in open_commands:
            self._cancels.cancel(entry.command)
        if open_commands:
            time.sleep(_FLUSH_S)
        for entry in open_commands:
            self._conclude(ending_at_shutdown(entry.command))
        for ending in self._left_over.take_answers(is_last_chance=True):
            self._answer(ending)
        self._send()
