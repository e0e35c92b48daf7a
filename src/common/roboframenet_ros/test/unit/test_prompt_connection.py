"""Who publishes waits for nobody, and what is published arrives whole and in order."""

import socket
import threading
from typing import Iterator, List

import pytest
from rospy.exceptions import TransportTerminated

from roboframenet_ros.ros_prompt_connection import PromptConnection
from roboframenet_testing import wait_until

#: Longer than what a socket takes at once.
LONG = 1 << 20


class Transport:
    """The part of rospy's transport that a connection uses."""

    def __init__(self, sink: socket.socket) -> None:
        self.socket, self.done = sink, False
        self.stat_bytes = self.stat_num_msg = self.closed = 0
        self.endpoint_id = "/reader"

    def close(self) -> None:
        self.done = True
        self.closed += 1
        self.socket.close()


class Ends:
    """A connection, and the socket of its subscriber."""

    def __init__(self, queue_size: int) -> None:
        sink, self.reader = socket.socketpair()
        self.transport = Transport(sink)
        self.connection = PromptConnection(self.transport, queue_size)

    def read(self, count: int) -> bytes:
        """Read bytes; fails after 30 s without one."""
        self.reader.settimeout(30.0)
        read = b""
        while len(read) < count:
            part = self.reader.recv(min(1 << 16, count - len(read)))
            assert part, "the connection was closed"
            read += part
        return read


@pytest.fixture
def ends(request: pytest.FixtureRequest) -> Iterator[Ends]:
    """Both ends of a connection; its queue holds ten messages unless the test says otherwise."""
    ends = Ends(getattr(request, "param", 10))
    yield ends
    ends.transport.close()
    ends.reader.close()


def late_writers() -> List[threading.Thread]:
    """The threads that write what could not be written at once."""
    return [thread for thread in threading.enumerate() if thread.name == "late_messages"]


def message(number: int, length: int) -> bytes:
    """A message that no other one looks like."""
    return bytes([number]) * length


def test_message_is_written_by_the_thread_that_publishes(ends: Ends) -> None:
    ends.connection.write_data(b"hello")
    assert not late_writers()
    assert ends.read(5) == b"hello"
    assert (ends.transport.stat_bytes, ends.transport.stat_num_msg) == (5, 1)


def test_everything_else_is_what_the_transport_says(ends: Ends) -> None:
    assert ends.connection.endpoint_id == "/reader"
    with pytest.raises(AttributeError):
        _ = ends.connection.no_such_thing


def test_who_publishes_does_not_wait_for_who_does_not_read(ends: Ends) -> None:
    messages = [message(number, LONG) for number in range(5)]
    for one in messages:
        ends.connection.write_data(one)
    assert len(late_writers()) == 1
    assert ends.read(5 * LONG) == b"".join(messages)
    wait_until(lambda: not late_writers())
    assert (ends.transport.stat_bytes, ends.transport.stat_num_msg) == (5 * LONG, 5)


def test_what_comes_after_the_late_messages_stays_after_them(ends: Ends) -> None:
    sent = b""
    for number in range(40):
        length = LONG if number % 10 == 0 else 7
        sent += message(number, length)
        ends.connection.write_data(message(number, length))
        if number % 10 == 9:
            assert ends.read(LONG + 9 * 7) == sent[-LONG - 9 * 7 :]


@pytest.mark.parametrize("ends", [3], indirect=True)
def test_oldest_messages_are_dropped_but_none_is_cut(ends: Ends) -> None:
    for number in range(10):
        ends.connection.write_data(message(number, LONG))
    # The first was begun.
    assert ends.read(4 * LONG) == b"".join(message(number, LONG) for number in (0, 7, 8, 9))


@pytest.mark.parametrize("ends", [0], indirect=True)
def test_queue_of_size_zero_drops_nothing(ends: Ends) -> None:
    for number in range(20):
        ends.connection.write_data(message(number, LONG))
    assert ends.read(20 * LONG) == b"".join(message(number, LONG) for number in range(20))


def test_who_publishes_is_told_that_the_subscriber_is_gone(ends: Ends) -> None:
    ends.reader.close()
    with pytest.raises(TransportTerminated):
        ends.connection.write_data(b"hello")


def test_late_message_to_a_subscriber_that_is_gone_closes_the_connection(ends: Ends) -> None:
    ends.connection.write_data(message(0, LONG))
    ends.reader.close()
    wait_until(lambda: ends.transport.closed == 1)
    with pytest.raises(TransportTerminated):
        ends.connection.write_data(b"hello")


def test_late_writer_ends_when_the_connection_is_closed(ends: Ends) -> None:
    ends.connection.write_data(message(0, LONG))
    assert late_writers()
    ends.transport.close()
    wait_until(lambda: not late_writers())
