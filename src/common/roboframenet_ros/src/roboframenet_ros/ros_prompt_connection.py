"""Connections to subscribers that write a message where it is published."""

import contextlib
import select
import socket
import threading
from collections import deque
from typing import Any, Deque, Optional

import rospy.topics
from rospy.exceptions import TransportTerminated

# How often the writer looks whether a connection whose subscriber does not read was closed, milliseconds.
_LOOK_MS = 1000


def publish_promptly() -> None:
    """Give the publishers of this process a `PromptConnection` to each subscriber; call it before their first one."""
    # rospy has no setting for it.
    rospy.topics.QueuedConnection = PromptConnection


class PromptConnection:
    """Takes the place of rospy's ``QueuedConnection``, which leaves each message to a thread of its own.

    To wake that thread takes longer than to write, once in each stage of each command. Here the publishing thread
    writes; a thread writes only what a subscriber is not ready to take, so nobody who publishes ever waits for one.
    """

    def __init__(self, connection: Any, queue_size: int) -> None:
        """
        Args:
            connection: the transport
            queue_size: most messages that wait, the newest; 0 for any number
        """
        self._connection = connection
        self._lock = threading.Lock()
        self._waiting: Deque[bytes] = deque(maxlen=queue_size or None)
        # What is left of a message that was begun: it must be ended, whatever else is dropped.
        self._rest = b""
        self._writer: Optional[threading.Thread] = None

    def __getattr__(self, name: str) -> Any:
        return getattr(self._connection, name)

    def write_data(self, data: bytes) -> bool:
        """Write a message, or what the subscriber is ready to take of it; returns True, as all transports do.

        Raises:
            TransportTerminated: the connection has ended; rospy closes it then
        """
        with self._lock:
            if self._connection.done:
                raise TransportTerminated("connection closed")
            if self._writer is not None:
                self._waiting.append(data)
            elif not self._write(data):
                self._writer = threading.Thread(target=self._write_waiting, name="late_messages", daemon=True)
                self._writer.start()
        return True

    def _write(self, data: bytes) -> bool:
        """Write what is possible at once, and keep the rest; returns whether there is none. Called with the lock."""
        sink = self._connection.socket
        if sink is None:
            raise TransportTerminated("connection closed")
        self._rest = data
        try:
            self._rest = data[sink.send(data, socket.MSG_DONTWAIT) :]
        except BlockingIOError:
            return False
        except OSError as error:
            raise TransportTerminated(str(error)) from error
        self._connection.stat_bytes += len(data) - len(self._rest)
        self._connection.stat_num_msg += not self._rest
        return not self._rest

    def _write_waiting(self) -> None:
        """Write whatever waits; ends when nothing does, or when the connection ends."""
        try:
            while self._write_some():
                self._wait_until_writable()
        except TransportTerminated:
            # It calls back, so not with the lock.
            self._connection.close()

    def _write_some(self) -> bool:
        """Write what is possible at once of what waits; returns whether something still waits."""
        with self._lock:
            while self._rest or self._waiting:
                if not self._write(self._rest or self._waiting.popleft()):
                    return True
            self._writer = None
            return False

    def _wait_until_writable(self) -> None:
        sink = self._connection.socket
        # A socket that is closed cannot be polled; the next write reports it.
        with contextlib.suppress(TypeError, ValueError):
            poll = select.poll()
            poll.register(sink, select.POLLOUT)
            poll.poll(_LOOK_MS)
