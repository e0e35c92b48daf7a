"""A topic that nobody asks for is read a few times a second; who asks gets what is sent from then on."""

import io
import threading
import time
from unittest import mock

import pytest
from nav_msgs.msg import Odometry

from move_action_server import unasked
from move_action_server.ros_odometry import LatestOdometry, UnreadOdometry
from move_action_server.unasked import LIVELY_S, LONGEST_PAUSE_S, MOST_UNREAD_BYTES, Unasked
from roboframenet_testing import wait_until

RATE_HZ, SIZE = 50, 720


def unasked_for(seconds: float, *, rate_hz: int = RATE_HZ, size: int = SIZE) -> float:
    """The pause after so many seconds in which each message came and nobody asked."""
    return Unasked(now_s=100.0).pause_s(count=int(seconds * rate_hz), size=size, now_s=100.0 + seconds)


def test_no_pause_while_somebody_asks() -> None:
    assert unasked_for(LIVELY_S - 0.1) == 0.0
    topic = Unasked(now_s=100.0)
    for second in range(60):
        topic.ask(count=second * RATE_HZ, now_s=100.0 + second)
        assert topic.pause_s(count=second * RATE_HZ, size=SIZE, now_s=100.5 + second) == 0.0


def test_what_waits_in_the_socket_is_bounded() -> None:
    for rate_hz, size in ((50, 720), (200, 720), (50, 4000), (10, 100)):
        pause_s = unasked_for(LIVELY_S, rate_hz=rate_hz, size=size)
        assert 0.0 < pause_s <= LONGEST_PAUSE_S
        assert pause_s * rate_hz * size <= MOST_UNREAD_BYTES


def test_topic_that_is_too_quick_is_read_as_it_comes() -> None:
    assert unasked_for(LIVELY_S, rate_hz=1000) == 0.0


def test_pauses_end_when_somebody_asks_and_begin_again_later() -> None:
    topic = Unasked(now_s=0.0)
    assert topic.pause_s(count=100, size=SIZE, now_s=LIVELY_S) > 0.0
    topic.ask(count=104, now_s=10.0)
    assert topic.pause_s(count=110, size=SIZE, now_s=10.1) == 0.0
    # Twice as many messages now.
    late_s = 10.0 + LIVELY_S
    pause_s = topic.pause_s(count=104 + int(2 * RATE_HZ * LIVELY_S), size=SIZE, now_s=late_s)
    assert 0.0 < pause_s <= MOST_UNREAD_BYTES / (2 * RATE_HZ * SIZE) + 1e-9


@pytest.fixture
def odometry(monkeypatch: pytest.MonkeyPatch) -> LatestOdometry:
    """Odometry that nobody has asked for since long ago, alone on its topic; pauses are long."""
    monkeypatch.setattr(unasked, "LONGEST_PAUSE_S", 60.0)
    with mock.patch("rospy.Subscriber") as subscriber:
        subscriber.return_value.impl.callbacks = [object()]
        latest = LatestOdometry()
    latest._unasked = Unasked(now_s=time.monotonic() - 100.0)
    return latest


def message(x_m: float) -> UnreadOdometry:
    sent = Odometry()
    sent.pose.pose.position.x, sent.pose.pose.orientation.w = x_m, 1.0
    buffer = io.BytesIO()
    sent.serialize(buffer)
    return UnreadOdometry().deserialize(buffer.getvalue())


def test_who_asks_waits_for_a_message_that_has_not_waited_itself(odometry: LatestOdometry) -> None:
    reader = threading.Thread(target=lambda: [odometry._take(message(x_m)) for x_m in (1.0, 2.0, 3.0)], daemon=True)
    reader.start()
    wait_until(lambda: odometry.count == 1 and odometry._is_pausing)
    # The first of the others was sent before.
    sample, count = odometry.wait_newer(than=odometry.count, timeout_s=30.0)
    assert sample is not None and (sample.x_m, count) == (3.0, 3)


def test_dead_source_is_noticed_although_a_message_of_it_has_waited(odometry: LatestOdometry) -> None:
    reader = threading.Thread(target=lambda: [odometry._take(message(x_m)) for x_m in (1.0, 2.0)], daemon=True)
    reader.start()
    wait_until(lambda: odometry.count == 1 and odometry._is_pausing)
    assert odometry.wait_newer(than=odometry.count, timeout_s=0.2) == (None, 2)


def test_others_in_the_process_get_each_message_at_once(odometry: LatestOdometry) -> None:
    odometry._subscriber.impl.callbacks = [object(), object()]
    for number in range(1, 4):
        odometry._take(message(1.0))
        assert odometry.count == number


def test_wake_ends_a_wait_without_a_message(odometry: LatestOdometry) -> None:
    answers = []
    waiter = threading.Thread(target=lambda: answers.append(odometry.wait_newer(than=0, timeout_s=60.0)), daemon=True)
    waiter.start()
    wait_until(lambda: bool(odometry._condition._waiters))
    odometry.wake()
    waiter.join(30.0)
    assert answers == [(None, 0)]
