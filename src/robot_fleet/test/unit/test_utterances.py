"""What was said to all robots has one answer, whatever becomes of those who are meant."""

import time
from typing import Any, List, Tuple

import pytest
import rospy
from roboframenet_msgs.msg import Reply

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
        self.is_connected = True

    def send(self, robot: str, text: str, *, command_id: str) -> bool:
        if self.is_connected:
            self.sent.append((robot, text, command_id))
        return self.is_connected

    def cancel(self, robot: str, *, command_id: str) -> None:
        self.cancelled.append(command_id)


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
def utterances(clock: Clock, links: Any, replies: List[Reply]) -> Utterances:
    made = Utterances(SETTINGS, links, replies.append)
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
    made = Utterances(SETTINGS, links, replies.append)  # type: ignore[arg-type]
    made.say("Beta, turn left.", COMPANY, command_id="text-1", near=None)
    clock.now_s += 1.1 * SETTINGS.connection_timeout_s
    made.send()
    assert told(replies) == [("ROBOT_LOST", "Beta: I cannot reach it.")]
