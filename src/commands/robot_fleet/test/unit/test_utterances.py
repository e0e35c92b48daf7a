"""What was said to all robots has one answer, whatever becomes of those who are meant."""

import json
import time
from typing import Any, List, Tuple

import pytest
import rospy
from roboframenet_msgs.msg import Command, CommandStatus, Reply

from command_server.cries import COMMAND_VERBS, STRONG
from roboframenet_testing import Clock
from robot_fleet.addressing import Company, Robot
from robot_fleet.ros_utterances import Utterances
from robot_fleet.settings import FleetSettings

SETTINGS = FleetSettings()
COMPANY = Company((Robot("alpha"), Robot("beta")), (), COMMAND_VERBS | STRONG)


class Links:
    """Robots that get what they are sent, if they are connected."""

    def __init__(self) -> None:
        self.sent: List[Tuple[str, str, str]] = []
        self.cancelled: List[str] = []
        self.watched: List[str] = []
        self.is_connected = True

    def send(self, robot: str, text: str, *, command_id: str) -> bool:
        if self.is_connected:
            self.sent.append((robot, text, command_id))
        return self.is_connected

    def watch(self, robot: str) -> None:
        self.watched.append(robot)

    def unwatch(self, robot: str) -> None:
        self.watched.remove(robot)

    def cancel(self, robot: str, *, command_id: str) -> None:
        self.cancelled.append(command_id)


class Store:
    """A file that outlives the node."""

    def __init__(self) -> None:
        self.text = ""

    def load(self) -> Any:
        return json.loads(self.text) if self.text else None

    def save(self, value: Any) -> None:
        self.text = json.dumps(value)


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr(time, "monotonic", clock)
    monkeypatch.setattr(rospy.Time, "now", lambda: rospy.Time(100))
    return clock


@pytest.fixture
def links() -> Links:
    return Links()


@pytest.fixture
def replies() -> List[Reply]:
    return []


@pytest.fixture
def store() -> Store:
    return Store()


@pytest.fixture
def utterances(clock: Clock, links: Any, replies: List[Reply], store: Any) -> Utterances:
    made = Utterances(SETTINGS, links, replies.append, store)
    made.say("Beta, turn left.", COMPANY, command_id="text-1", near=None)
    return made


def told(replies: List[Reply]) -> List[Tuple[str, str]]:
    return [(reply.code, reply.sentence) for reply in replies]


def test_what_a_robot_that_is_there_never_takes_is_answered(
    utterances: Utterances, links: Links, replies: List[Reply], clock: Clock
) -> None:
    clock.now_s += 1.5 * SETTINGS.delivery_timeout_s
    utterances.end_undelivered(())
    assert not replies
    clock.now_s += SETTINGS.delivery_timeout_s
    utterances.end_undelivered(())
    assert told(replies) == [("ROBOT_LOST", "Beta: It did not take that.")]
    assert links.cancelled == [links.sent[0][2]]
    utterances.hear(links.sent[0][2], Reply(outcome=Reply.DONE, sentence="Done."))
    assert len(replies) == 1


def test_what_a_robot_that_is_gone_never_took_is_answered_sooner(
    utterances: Utterances, replies: List[Reply], clock: Clock
) -> None:
    clock.now_s += 1.1 * SETTINGS.delivery_timeout_s
    utterances.end_undelivered(("beta",))
    assert told(replies) == [("ROBOT_LOST", "Beta: It was gone before it began.")]


def test_what_a_robot_has_begun_may_take_long(
    utterances: Utterances, links: Links, replies: List[Reply], clock: Clock
) -> None:
    utterances.hear_begun(links.sent[0][2])
    clock.now_s += 100.0
    utterances.end_undelivered(())
    assert not replies
    utterances.hear(links.sent[0][2], Reply(outcome=Reply.DONE, code="DONE", sentence="Done."))
    assert told(replies) == [("DONE", "Beta: Done.")]


def test_robot_that_is_never_connected_is_told_of(links: Links, replies: List[Reply], clock: Clock) -> None:
    links.is_connected = False
    made = Utterances(SETTINGS, links, replies.append, Store())  # type: ignore[arg-type]
    made.say("Beta, turn left.", COMPANY, command_id="text-1", near=None)
    clock.now_s += 1.1 * SETTINGS.connection_timeout_s
    made.send()
    assert told(replies) == [("ROBOT_LOST", "Beta: I cannot reach it.")]


def started_again(links: Any, replies: List[Reply], store: Any) -> Utterances:
    """The node was killed and runs again; what it had sent is not sent again."""
    links.sent, before = [], links.sent
    made = Utterances(SETTINGS, links, replies.append, store)
    assert [command.text for command in made.take_over()] == ["Beta, turn left."]
    made.send()
    assert not links.sent
    assert links.watched == ["beta"]
    links.sent = before
    return made


def test_what_a_robot_still_does_after_a_restart_is_answered_when_it_is_done(
    utterances: Utterances, links: Links, replies: List[Reply], store: Store, clock: Clock
) -> None:
    again, sent_id = started_again(links, replies, store), links.sent[0][2]
    again.hear_status("beta", CommandStatus(active=[Command(id=sent_id)]))
    clock.now_s += 100.0
    again.end_undelivered(())
    assert not replies
    again.hear(sent_id, Reply(outcome=Reply.DONE, code="DONE", sentence="Done."))
    again.hear_status("beta", CommandStatus(last_reply=Reply(command=Command(id=sent_id), outcome=Reply.DONE)))
    assert told(replies) == [("DONE", "Beta: Done.")]
    assert not links.watched
    again.save()
    assert store.load() == {}


def test_what_a_robot_has_done_during_a_restart_is_answered_by_its_last_reply(
    utterances: Utterances, links: Links, replies: List[Reply], store: Store
) -> None:
    again, sent_id = started_again(links, replies, store), links.sent[0][2]
    reply = Reply(command=Command(id=sent_id), outcome=Reply.FAILED, code="X", sentence="I am stuck.")
    again.hear_status("beta", CommandStatus(last_reply=reply))
    assert told(replies) == [("X", "Beta: I am stuck.")]


@pytest.mark.parametrize("is_there", [True, False])
def test_what_nobody_can_say_after_a_restart_is_told_as_unknown(
    utterances: Utterances, links: Links, replies: List[Reply], store: Store, clock: Clock, is_there: bool
) -> None:
    again = started_again(links, replies, store)
    if is_there:
        again.hear_status("beta", CommandStatus())
    clock.now_s += 1.5 if is_there else 11.0
    again.end_undelivered(())
    unknown = "Beta: I was restarted meanwhile; I do not know how that ended."
    assert told(replies) == [("RESTARTED", unknown)]


@pytest.mark.parametrize("text", ["", "[]", '{"count": 1, "open": [{}]}', '{"count": "x"}'])
def test_a_file_that_cannot_be_read_is_left(clock: Clock, links: Any, replies: List[Reply], text: str) -> None:
    store: Any = Store()
    store.text = text
    assert Utterances(SETTINGS, links, replies.append, store).take_over() == ()
