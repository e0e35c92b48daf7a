"""What was said to all robots: it is passed on to those who are meant, and answered once."""

import time
from dataclasses import asdict, dataclass, field
from typing import Any, Callable, Collection, Dict, List, Mapping, Optional, Tuple

import rospy
from roboframenet_msgs.msg import Command, CommandStatus, Reply

from roboframenet_ros.command_ids import sent_on_id
from roboframenet_ros.ros_kept_value import KeptValue
from robot_fleet.addressing import Addressed, Company, Dialogue, Unaddressed, address
from robot_fleet.answers import Answer, OpenUtterance, Outcome, Sending, missing_answer, robot_of_question
from robot_fleet.places import Place
from robot_fleet.ros_robots import RobotLinks
from robot_fleet.settings import FleetSettings
from robot_fleet.taken_over import TakenOver

STAGE = "robot_fleet"
#: The outcome of an utterance that nobody carries out, by its code.
_OUTCOMES = {"WHO": Reply.NEEDS_INFORMATION, "ATTENTION": Reply.DONE}


@dataclass
class _Entry:
    command: Command
    utterance: OpenUtterance
    unsent: List[Tuple[Sending, float]] = field(default_factory=list)


class Utterances:
    """The open utterances; one thread owns them. They are kept for a node that is started again."""

    def __init__(
        self, settings: FleetSettings, links: RobotLinks, publish: Callable[[Reply], None], store: KeptValue
    ) -> None:
        """
        Args:
            settings: of the node
            links: to the robots
            publish: called with each reply
            store: where they are kept
        """
        self._settings, self._links, self._publish, self._store = settings, links, publish, store
        self._saved: List[Any] = []
        self._taken_over = TakenOver()
        self._entries: Dict[str, _Entry] = {}
        self._sent: Dict[str, Tuple[str, Sending]] = {}
        # What robots have not begun yet: until when they may, monotonic seconds.
        self._may_begin_s: Dict[str, float] = {}
        self._dialogue = Dialogue()
        self._count = 0

    def take_over(self) -> Tuple[Command, ...]:
        """Go on with what the previous run left open; returns what was said."""
        try:
            record: Any = self._store.load() or {"count": 0, "open": []}
            self._count = int(record["count"])
            kept = [_entry_of(one) for one in record["open"]]
        except (ValueError, KeyError, TypeError) as error:
            rospy.logwarn("what the previous run of fleet left open cannot be read: %s", error)
            return ()
        for entry, sent in kept:
            self._entries[entry.command.id] = entry
            for sent_id, sending in sent.items():
                self._sent[sent_id] = (entry.command.id, sending)
                self._taken_over.add(sent_id, sending.robot, now_s=time.monotonic())
                self._links.watch(sending.robot)
        return tuple(entry.command for entry, _ in kept)

    def hear_status(self, robot: str, status: CommandStatus) -> None:
        """A robot tells what it does: that says what became of what the previous run sent it."""
        active = tuple(command.id for command in status.active)
        last = status.last_reply
        for sent_id in self._taken_over.hear(robot, active, last.command.id, now_s=time.monotonic()):
            self.hear(sent_id, last)
        self._end_taken_over()

    def _end_taken_over(self) -> None:
        for sent_id in self._taken_over.take_overdue(now_s=time.monotonic()):
            self._answer_for(sent_id, "I was restarted meanwhile; I do not know how that ended.", "RESTARTED")
        for robot in self._taken_over.take_known():
            self._links.unwatch(robot)

    def save(self) -> None:
        """Keep what is open, if that has changed."""
        records = [
            {
                "command": {
                    "id": entry.command.id,
                    "stamp_ns": entry.command.stamp.to_nsec(),
                    "text": entry.command.text,
                },
                "utterance": entry.utterance.record(),
                "sent": {at: asdict(one) for at, (whole_id, one) in self._sent.items() if whole_id == entry.command.id},
                "unsent": [asdict(sending) for sending, _ in entry.unsent],
            }
            for entry in self._entries.values()
        ]
        if records != self._saved:
            self._saved = records
            self._store.save({"count": self._count, "open": records} if records else {})

    def close(self) -> None:
        """Forget the file when nothing is open."""
        self._store.close()

    @property
    def busy(self) -> Tuple[str, ...]:
        """The robots whose answer is missing."""
        return tuple(robot for entry in self._entries.values() for _, robot in entry.utterance.waiting)

    def say(self, text: str, company: Company, *, command_id: str, near: Optional[Place]) -> None:
        """Decide whom an utterance is for, and send it."""
        command = Command(id=command_id, stamp=rospy.Time.now(), text=text)
        now_s = time.monotonic()
        decided = address(
            text,
            company,
            self._dialogue,
            now_s=now_s,
            timeout_s=self._settings.dialogue_timeout_s,
            answer_timeout_s=self._settings.answer_timeout_s,
            near=near,
        )
        self._dialogue = decided.dialogue
        if isinstance(decided, Unaddressed):
            outcome = _OUTCOMES.get(decided.code, Reply.REFUSED)
            self._reply(command, outcome=outcome, code=decided.code, sentence=decided.sentence)
            return
        self._open(command, decided, now_s)

    def refuse(self, text: str, sentence: str, *, code: str, command_id: str) -> None:
        """Answer an utterance that is for nobody."""
        command = Command(id=command_id, stamp=rospy.Time.now(), text=text)
        self._reply(command, outcome=Reply.REFUSED, code=code, sentence=sentence)

    def _open(self, command: Command, decided: Addressed, now_s: float) -> None:
        rospy.loginfo("cmd=%s is for %s", command.id, "; ".join(", ".join(order.robots) for order in decided.orders))
        entry = _Entry(command, OpenUtterance(decided.orders, decided.remark))
        self._entries[command.id] = entry
        entry.unsent += [(sending, now_s) for sending in entry.utterance.begin()]
        self.send()

    def cancel(self, command_id: str) -> None:
        """The client takes an utterance back: each robot answers that."""
        for sent_id, (whole_id, sending) in list(self._sent.items()):
            if whole_id == command_id:
                self._links.cancel(sending.robot, command_id=sent_id)

    def send(self) -> None:
        """Send what waits for a connection; a robot that is not connected in time answers nothing."""
        due: List[Tuple[_Entry, Sending, float, str]] = []
        for entry in self._entries.values():
            unsent, entry.unsent = entry.unsent, []
            for sending, since_s in unsent:
                self._count += 1
                sent_id = sent_on_id(entry.command.id, self._count)
                self._sent[sent_id] = (entry.command.id, sending)
                due.append((entry, sending, since_s, sent_id))
        # What may have been sent is not sent again by a node that is started again.
        self.save()
        for entry, sending, since_s, sent_id in due:
            if self._links.send(sending.robot, sending.text, command_id=sent_id):
                self._may_begin_s[sent_id] = time.monotonic() + self._settings.delivery_timeout_s
                continue
            del self._sent[sent_id]
            if time.monotonic() - since_s < self._settings.connection_timeout_s:
                entry.unsent.append((sending, since_s))
            else:
                self._take(entry, sending, missing_answer(sending.robot, "I cannot reach it.", "ROBOT_LOST"))

    def hear_begun(self, sent_id: str) -> None:
        """A robot has begun what it was told."""
        self._may_begin_s.pop(sent_id, None)

    def hear(self, sent_id: str, reply: Reply) -> None:
        """A robot has answered."""
        self.hear_begun(sent_id)
        self._taken_over.drop(sent_id)
        whole_id, sending = self._sent.pop(sent_id, ("", None))
        entry = self._entries.get(whole_id)
        if entry is None or sending is None:
            return
        answer = Answer(sending.robot, Outcome(reply.outcome), reply.code, reply.sentence, stage=reply.stage)
        self._take(entry, sending, answer)

    def lose(self, robot: str) -> None:
        """A robot has left: what it has begun has no answer any more."""
        for sent_id, (_, sending) in list(self._sent.items()):
            if sending.robot == robot and sent_id not in self._may_begin_s:
                self._answer_for(sent_id, "It is gone; I do not know how far it came.")

    def end_undelivered(self, gone: Collection[str]) -> None:
        """Answer what robots did not begin in time: when the network delivers it later, it is refused.

        A robot that is there is given the time twice: it may be slow, and what it tells may be unread.
        """
        self._end_taken_over()
        now_s = time.monotonic()
        for sent_id, until_s in list(self._may_begin_s.items()):
            _, sending = self._sent[sent_id]
            is_gone = sending.robot in gone
            if now_s >= until_s + (0.0 if is_gone else self._settings.delivery_timeout_s):
                self._links.cancel(sending.robot, command_id=sent_id)
                self._answer_for(sent_id, "It was gone before it began." if is_gone else "It did not take that.")

    def _answer_for(self, sent_id: str, sentence: str, code: str = "ROBOT_LOST") -> None:
        """Answer in the place of a robot that is gone."""
        self._may_begin_s.pop(sent_id, None)
        self._taken_over.drop(sent_id)
        whole_id, sending = self._sent.pop(sent_id)
        self._take(self._entries[whole_id], sending, missing_answer(sending.robot, sentence, code))

    def _take(self, entry: _Entry, sending: Sending, answer: Answer) -> None:
        now_s = time.monotonic()
        entry.unsent += [(following, now_s) for following in entry.utterance.hear(sending.order, answer)]
        if not entry.utterance.is_complete:
            return
        del self._entries[entry.command.id]
        asking = robot_of_question(entry.utterance.answers)
        kept = tuple(robot for robot in self._dialogue.asking if robot not in asking)
        self._dialogue = Dialogue(
            # Of several that were asked, who does it is spoken to from now on.
            last=(answer.robot,) if _is_one_of_several(entry.utterance, answer) else self._dialogue.last,
            asking=kept + asking,
            pending=self._dialogue.pending,
            said_s=self._dialogue.said_s,
        )
        whole = entry.utterance.whole_answer()
        self._reply(
            entry.command,
            outcome=int(whole.outcome),
            code=whole.code,
            sentence=whole.sentence,
            stage=whole.stage or STAGE,
        )

    def _reply(self, command: Command, *, outcome: int, code: str, sentence: str, stage: str = STAGE) -> None:
        now = rospy.Time.now()
        self._publish(Reply(command=command, outcome=outcome, stage=stage, code=code, sentence=sentence, stamp=now))


def _entry_of(record: Mapping[str, Any]) -> Tuple[_Entry, Dict[str, Sending]]:
    """Return what the previous run kept of an utterance, and what it had sent.

    Raises:
        KeyError: a value is missing
        TypeError: a value is of a wrong type
        ValueError: a value cannot be
    """
    said = record["command"]
    stamp = rospy.Time(0, int(said["stamp_ns"]))
    entry = _Entry(
        Command(id=str(said["id"]), stamp=stamp, text=str(said["text"])),
        OpenUtterance.of_record(record["utterance"]),
        [(Sending(**sending), time.monotonic()) for sending in record["unsent"]],
    )
    return entry, {str(sent_id): Sending(**sending) for sent_id, sending in record["sent"].items()}


def _is_one_of_several(utterance: OpenUtterance, answer: Answer) -> bool:
    return len(utterance.orders) == 1 and utterance.orders[0].is_any and answer.outcome is Outcome.DONE
