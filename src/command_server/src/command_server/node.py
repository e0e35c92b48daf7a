"""The command server node: the doors for commands, and the one reply to each.

Callbacks only enqueue; one worker thread owns the commands.
"""
import queue
import threading
import time
import uuid
from collections import deque
from dataclasses import dataclass
from typing import Deque, List, Optional, Tuple, Union

import actionlib
import rosgraph
import rospy
from roboframenet_msgs.msg import Command, CommandStatus, Reply, StageEvent, StopReport
from std_msgs.msg import String

from command_server.command_book import (
    CommandBook, CommandText, Ending, OWN_STAGE, Outcome, STOP_STAGE, endings_after_restart, refusal_of_text,
    stamp_after)
from command_server.ros_action_door import ActionDoor
from command_server.ros_messages import (
    command_from_message, command_to_message, ending_from_message, ending_to_message)
from command_server.ros_open_commands import OpenCommandStore
from command_server.settings import Settings
from command_server.stop_book import StopBook
from command_server.stop_words import is_stop

_SAVE_TIMEOUT_S = 0.5
_LONGEST_WAIT_S = 0.2
# How long replies of the last run wait for listeners that still start and connect.
_LISTENER_TIMEOUT_S = 10.0
_JOIN_TIMEOUT_S = 5.0


@dataclass(frozen=True)
class _Said:
    """A text or a goal, with the time of its arrival."""

    text: str
    arrival_ns: int
    handle: Optional[actionlib.ServerGoalHandle] = None


@dataclass(frozen=True)
class _GoalCancelled:
    """The client of a goal asked to cancel it."""

    command_id: str


_Event = Union[_Said, _GoalCancelled, StageEvent, StopReport, None]


class CommandServerNode:
    """Owns the commands.

    Subscribes: ``text``, ``stage_events``, ``stop_report``. Publishes: ``command_text``, ``command_cancel``, ``reply``,
    ``status`` (latched). Actions: ``command``.
    """

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._book = CommandBook(settings.stage_timeouts_s)
        self._stops = StopBook(timeout_s=settings.stop_timeout_s)
        self._store = OpenCommandStore()
        self._saved: Tuple[CommandText, ...] = ()
        self._unsent: Deque[CommandText] = deque()
        self._run_tag = uuid.uuid4().hex[:8]
        self._text_count = 0
        self._last_stamp_ns = 0
        self._sentence = "Ready."
        self._last_reply = Reply()
        self._is_status_due = True
        self._events: "queue.Queue[_Event]" = queue.Queue()
        self._worker = threading.Thread(target=self._work, name="command_server_worker")

        self._command_text = rospy.Publisher("command_text", Command, queue_size=1000)
        self._command_cancel = rospy.Publisher("command_cancel", Command, queue_size=1000)
        self._reply = rospy.Publisher("reply", Reply, queue_size=1000)
        self._status = rospy.Publisher("status", CommandStatus, queue_size=1, latch=True)
        self._left_over: Deque[Ending] = deque(endings_after_restart(self._store.load()))
        self._left_over_end_s = time.monotonic() + _LISTENER_TIMEOUT_S
        self._door = ActionDoor(
            on_goal=lambda handle: self._events.put(_Said(handle.get_goal().text, _now_ns(), handle)),
            on_cancel=lambda command_id: self._events.put(_GoalCancelled(command_id)))

    def start(self) -> None:
        """Open the doors."""
        rospy.on_shutdown(self._shutdown)
        self._worker.start()
        self._subscribers = [
            rospy.Subscriber("stage_events", StageEvent, self._events.put),
            rospy.Subscriber("stop_report", StopReport, self._events.put),
            rospy.Subscriber("text", String, lambda message: self._events.put(_Said(message.data, _now_ns())))]
        self._door.start()

    def _shutdown(self) -> None:
        self._events.put(None)
        self._worker.join(_JOIN_TIMEOUT_S)
        self._door.shutdown()
        self._store.close(timeout_s=1.0)

    def _work(self) -> None:
        while True:
            events = self._take_events()
            for event in events:
                if event is None:
                    self._answer_all_at_shutdown()
                    return
                try:
                    self._handle(event)
                except Exception as error:  # boundary: one event must not end the answers to all others
                    rospy.logerr("command_server could not handle a %s: %s: %s",
                                 type(event).__name__, type(error).__name__, error)
            for ending in self._book.finish_overdue():
                self._answer(ending)
            for stop in self._stops.take_overdue():
                self._answer_silent_stop(stop.command_id, stop.text)
            self._answer_left_over()
            self._save()
            self._send()
            self._publish_status()

    def _take_events(self) -> List[_Event]:
        deadline_s = self._book.next_deadline_s()
        wait_s = _LONGEST_WAIT_S
        if deadline_s is not None:
            wait_s = min(wait_s, max(0.001, deadline_s - time.monotonic()))
        try:
            events = [self._events.get(timeout=wait_s)]
        except queue.Empty:
            return []
        while len(events) < 1000:
            try:
                events.append(self._events.get_nowait())
            except queue.Empty:
                break
        return events

    def _handle(self, event: _Event) -> None:
        if isinstance(event, _Said):
            self._hear(event)
        elif isinstance(event, _GoalCancelled):
            self._cancel(event.command_id)
        elif isinstance(event, StageEvent):
            self._hear_stage(event)
        elif isinstance(event, StopReport):
            self._hear_stop_report(event)

    def _hear(self, said: _Said) -> None:
        self._last_stamp_ns = stamp_after(said.arrival_ns, self._last_stamp_ns)
        if said.handle is not None:
            command_id = said.handle.get_goal_id().id
            self._door.accept(said.handle)
        else:
            self._text_count += 1
            command_id = f"text-{self._run_tag}-{self._text_count}"
        refusal = refusal_of_text(said.text, max_length=self._settings.max_text_length)
        command = CommandText(command_id=command_id, stamp_ns=self._last_stamp_ns,
                              text=said.text[:self._settings.max_text_length])
        rospy.loginfo("cmd=%s heard %r", command_id, command.text)
        if is_stop(said.text):
            self._hear_stop(command, is_action=said.handle is not None)
        elif refusal is not None:
            self._answer_at_once(command, Outcome.REFUSED, code=refusal[0], sentence=refusal[1])
        elif len(self._book.open_commands) >= self._settings.max_open_commands:
            self._answer_at_once(command, Outcome.FAILED, code="STAGE_ERROR",
                                 sentence="Too many commands wait already.")
        else:
            self._book.open(command)
            self._unsent.append(command)
            self._note(f"Heard {command.text!r}.")

    def _hear_stop(self, command: CommandText, *, is_action: bool) -> None:
        # The stop server and the executor have heard it as well; but a command that was said just before the stop may
        # have reached this node after the stop server's report, so every open one is cancelled by name.
        for entry in self._book.open_commands:
            self._command_cancel.publish(command_to_message(entry.command))
        for ending in self._book.finish_stopped(command.stamp_ns):
            self._answer(ending)
        if self._stops.hear_stop(command.command_id, command.text, is_action=is_action) is not None and is_action:
            self._door.finish(self._last_reply_to(command.command_id), command_id=command.command_id)

    def _last_reply_to(self, command_id: str) -> Reply:
        """The reply of the report that came before its goal."""
        if self._last_reply.command.id == command_id:
            return self._last_reply
        return Reply(command=Command(id=command_id), outcome=Reply.DONE, stage=STOP_STAGE, code="DONE",
                     sentence="Stopped.", stamp=rospy.Time.now())

    def _hear_stop_report(self, report: StopReport) -> None:
        for ending in self._book.finish_stopped(report.stop_stamp.to_nsec()):
            self._answer(ending)
        stop = self._stops.hear_report(report.command.id, report.command.text)
        if stop is not None and stop.is_action:
            self._door.finish(report.reply, command_id=stop.command_id)
        self._last_reply = report.reply
        self._note(report.reply.sentence)

    def _cancel(self, command_id: str) -> None:
        entry = self._book.get(command_id)
        if entry is None:
            return
        self._command_cancel.publish(command_to_message(entry.command))
        if entry.is_with_executor:
            # The executor ends it when the robot has stopped; its silence is watched as ever.
            return
        self._conclude(Ending(command=entry.command, outcome=Outcome.SUPERSEDED, stage=OWN_STAGE, code="STOPPED",
                              sentence="Cancelled before it began."))

    def _hear_stage(self, event: StageEvent) -> None:
        if self._book.get(event.command.id) is None:
            rospy.logdebug("cmd=%s is not open; event of %s dropped", event.command.id, event.stage)
            return
        self._door.feed_back(event)
        if not event.is_final:
            self._book.progress(event.command.id, event.stage)
            self._note(event.sentence)
            return
        try:
            ending = ending_from_message(event.reply)
        except ValueError as error:
            ending = Ending(command=command_from_message(event.command), outcome=Outcome.FAILED, stage=event.stage,
                            code="STAGE_ERROR", sentence=f"{event.stage} ended it with a malformed reply: {error}.")
        # The event says which command it is about; a reply that was filled in carelessly must not end another.
        self._conclude(Ending(command=command_from_message(event.command), outcome=ending.outcome, stage=ending.stage,
                              code=ending.code, sentence=ending.sentence))

    def _conclude(self, ending: Ending) -> None:
        """Close an open command and answer it; nothing when it is closed already."""
        closed = self._book.finish(ending)
        if closed is not None:
            self._answer(closed)

    def _answer_at_once(self, command: CommandText, outcome: Outcome, *, code: str, sentence: str) -> None:
        self._answer(Ending(command=command, outcome=outcome, stage=OWN_STAGE, code=code, sentence=sentence))

    def _answer_silent_stop(self, command_id: str, text: str) -> None:
        self._answer(Ending(
            command=CommandText(command_id=command_id, stamp_ns=self._last_stamp_ns, text=text),
            outcome=Outcome.FAILED, stage=STOP_STAGE, code="STAGE_SILENT",
            sentence=f"{STOP_STAGE} did not answer within {self._settings.stop_timeout_s:g} s; "
                     "the executor was told to cancel what it runs."))

    def _answer(self, ending: Ending) -> None:
        """Give the one reply to a command that is closed, or was never opened."""
        self._unsent = deque(command for command in self._unsent if command != ending.command)
        reply = ending_to_message(ending)
        rospy.loginfo("cmd=%s -> %s %s (%s) %s", ending.command.command_id, ending.outcome.name, ending.code,
                      ending.stage, ending.sentence)
        self._reply.publish(reply)
        self._door.finish(reply, command_id=ending.command.command_id)
        self._last_reply = reply
        self._note(ending.sentence)

    def _answer_left_over(self) -> None:
        if not self._left_over:
            return
        if time.monotonic() < self._left_over_end_s and not self._has_every_listener():
            return
        while self._left_over:
            self._answer(self._left_over.popleft())

    def _has_every_listener(self) -> bool:
        """Whether everybody whom the master knows to listen is connected; nobody at all has only not come yet."""
        try:
            _, subscriptions, _ = rosgraph.Master(rospy.get_name()).getSystemState()
        except Exception as error:  # boundary: the master may be away in any way that XML-RPC knows
            rospy.logdebug("the listeners of replies are not known: %s", error)
            return False
        listeners = dict(subscriptions).get(self._reply.resolved_name, [])
        return 0 < len(listeners) <= self._reply.get_num_connections()

    def _save(self) -> None:
        commands = tuple(entry.command for entry in self._book.open_commands)
        if self._left_over:
            commands = tuple(ending.command for ending in self._left_over) + commands
        if commands != self._saved and not self._store.save(commands, timeout_s=_SAVE_TIMEOUT_S):
            rospy.logwarn_throttle(10.0, "the master is slow to keep the open commands")
        self._saved = commands

    def _send(self) -> None:
        # Before the parser has connected a message would be lost; its silence is watched meanwhile.
        while self._unsent and self._command_text.get_num_connections() > 0:
            self._command_text.publish(command_to_message(self._unsent.popleft()))

    def _note(self, sentence: str) -> None:
        self._sentence = sentence
        self._is_status_due = True

    def _publish_status(self) -> None:
        if not self._is_status_due:
            return
        self._is_status_due = False
        entries = self._book.open_commands
        self._status.publish(CommandStatus(
            stamp=rospy.Time.now(), active=[command_to_message(entry.command) for entry in entries],
            stage=entries[-1].awaited_stage if entries else self._last_reply.stage, sentence=self._sentence,
            last_reply=self._last_reply))

    def _answer_all_at_shutdown(self) -> None:
        for entry in self._book.open_commands:
            self._conclude(Ending(command=entry.command, outcome=Outcome.FAILED, stage=OWN_STAGE, code="RESTARTED",
                                  sentence="The command server shuts down."))
        while self._left_over:
            self._answer(self._left_over.popleft())
        self._save()


def _now_ns() -> int:
    return rospy.Time.now().to_nsec()


def read_settings() -> Settings:
    """Read the private parameters.

    Raises:
        ValueError: a parameter is out of its range
    """
    return Settings(
        stage_timeout_s=rospy.get_param("~stage_timeout_s", Settings.stage_timeout_s),
        executor_timeout_s=rospy.get_param("~executor_timeout_s", Settings.executor_timeout_s),
        stop_timeout_s=rospy.get_param("~stop_timeout_s", Settings.stop_timeout_s),
        max_text_length=rospy.get_param("~max_text_length", Settings.max_text_length),
        max_open_commands=rospy.get_param("~max_open_commands", Settings.max_open_commands))


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    rospy.init_node("command_server")
    try:
        settings = read_settings()
    except ValueError as error:
        rospy.logfatal("%s", error)
        raise SystemExit(f"command_server: {error}") from error
    rospy.loginfo("command_server: %s", settings)
    CommandServerNode(settings).start()
    rospy.spin()
