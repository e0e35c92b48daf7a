"""Odometry, read as it comes only while somebody asks where the base is."""

import math
import threading
import time
from functools import partial
from typing import Optional, Tuple

import rospy
from nav_msgs.msg import Odometry

from move_action_server.motion import OdometrySample
from move_action_server.unasked import MOST_UNREAD_BYTES, Unasked
from roboframenet_ros.suspension import SuspensionWatch

# A longer wait looks as often whether the process runs.
_LONGEST_WAIT_S = 0.25


class UnreadOdometry(Odometry):
    """An odometry message that is read when one of its fields is asked for.

    A base sends fifty messages a second, also while it stands; reading them all costs a per cent of a core. In one
    process, all subscribers of a topic get messages of the class that the first of them named, so this one has the
    fields of the message.
    """

    __slots__ = ("_encoded",)

    def __init__(self) -> None:
        """Hold nothing; the fields are made when they are asked for."""
        self._encoded = b""

    @property
    def encoded_size(self) -> int:
        """Bytes that were sent."""
        return len(self._encoded)

    def deserialize(self, encoded: bytes) -> "UnreadOdometry":
        """Keep what was sent."""
        self._encoded = encoded
        return self

    def __getattr__(self, name: str) -> object:
        """Read the message. Python asks here for fields that have no value yet."""
        if name not in Odometry.__slots__:
            raise AttributeError(name)
        read = Odometry()
        if self._encoded:
            read.deserialize(self._encoded)
        # Another thread that asks meanwhile meets fields that are whole, or reads the message as well.
        for field in Odometry.__slots__:
            setattr(self, field, getattr(read, field))
        return getattr(read, name)


def sample_of(message: Odometry) -> OdometrySample:
    """Read an odometry message; an orientation that is not a rotation gives a sample that is not finite."""
    rotation = message.pose.pose.orientation
    length = math.sqrt(rotation.x**2 + rotation.y**2 + rotation.z**2 + rotation.w**2)
    yaw_rad = math.nan
    if 0.5 < length < 2.0:
        yaw_rad = math.atan2(
            2.0 * (rotation.w * rotation.z + rotation.x * rotation.y),
            rotation.w**2 + rotation.x**2 - rotation.y**2 - rotation.z**2,
        )
    position = message.pose.pose.position
    return OdometrySample(stamp_s=message.header.stamp.to_sec(), x_m=position.x, y_m=position.y, yaw_rad=yaw_rad)


class LatestOdometry:
    """Holds the newest odometry message and wakes threads that wait for the next one.

    Subscribes ``odom`` (nav_msgs/Odometry). While nobody asks, its thread reads the topic a few times a second; what
    comes meanwhile stays in the socket, and all but the newest message of it is dropped unread (``queue_size=1``).
    """

    def __init__(self) -> None:
        self._condition = threading.Condition()
        self._message: Optional[Odometry] = None
        self._count = self._wakes = 0
        self._unasked = Unasked(now_s=time.monotonic())
        self._is_pausing = False
        self._subscriber = rospy.Subscriber("odom", UnreadOdometry, self._take, queue_size=1, tcp_nodelay=True)

    @property
    def topic(self) -> str:
        """Resolved name of the topic."""
        return self._subscriber.resolved_name

    def _take(self, message: Odometry) -> None:
        with self._condition:
            self._message = message
            self._count += 1
            self._condition.notify_all()
            # Of another class, it is for somebody else in the process, too.
            size = message.encoded_size if isinstance(message, UnreadOdometry) else MOST_UNREAD_BYTES
            pause_s = self._unasked.pause_s(count=self._count, size=size, now_s=time.monotonic())
            if pause_s > 0.0 and self._is_alone():
                self._is_pausing = True
                self._condition.wait_for(lambda: not self._is_pausing, pause_s)
                self._is_pausing = False

    def _is_alone(self) -> bool:
        """Whether nobody else in the process hears the topic: one thread of rospy brings the messages to all."""
        return len(self._subscriber.impl.callbacks) == 1

    @property
    def count(self) -> int:
        """Number of messages so far."""
        with self._condition:
            return self._count

    def wake(self) -> None:
        """Wake all waiting threads."""
        with self._condition:
            self._wakes += 1
            self._condition.notify_all()

    def latest(self) -> Optional[OdometrySample]:
        """Return the newest sample; None if there is none, or if its numbers are not finite."""
        with self._condition:
            message = self._message
        return self._read(message) if message is not None else None

    def wait_newer(self, *, than: int, timeout_s: float) -> Tuple[Optional[OdometrySample], int]:
        """Wait for a usable sample behind the ``than``-th message, or until the thread is woken.

        Returns:
            the sample, or None if there is none; and the count of messages so far
        """
        end_s = time.monotonic() + timeout_s
        with self._condition:
            wakes = self._wakes
            self._unasked.ask(count=self._count, now_s=time.monotonic())
            if self._is_pausing:
                # What comes first has waited in the socket: its source may be dead.
                than = max(than, self._count + 1)
                self._is_pausing = False
                self._condition.notify_all()
        suspension = SuspensionWatch(longest_turn_s=_LONGEST_WAIT_S + 0.4)
        while True:
            with self._condition:
                left_s = max(0.0, end_s - time.monotonic())
                is_over = self._condition.wait_for(
                    partial(self._is_over, than=than, wakes=wakes), min(left_s, _LONGEST_WAIT_S)
                )
                message, count = self._message, self._count
            # What arrived while the process did not run is still unread.
            end_s += suspension.turn()
            if not is_over and time.monotonic() < end_s:
                continue
            if count <= than or message is None:
                return None, count
            sample = self._read(message)
            if sample is not None or time.monotonic() >= end_s:
                return sample, count
            than = count

    def _is_over(self, *, than: int, wakes: int) -> bool:
        return self._count > than or self._wakes != wakes

    def _read(self, message: Odometry) -> Optional[OdometrySample]:
        sample = sample_of(message)
        if sample.is_finite():
            return sample
        rospy.logerr_throttle(1.0, "odometry with numbers that are not finite on %s", self.topic)
        return None
