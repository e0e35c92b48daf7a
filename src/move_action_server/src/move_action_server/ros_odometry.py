"""Odometry, read only while somebody asks where the base is."""

import math
import threading
import time
from typing import Optional, Tuple

import rospy
from nav_msgs.msg import Odometry

from move_action_server.motion import OdometrySample


class _EncodedOdometry(Odometry):
    """An odometry message that is kept as it was sent.

    A base sends fifty messages a second, also while it stands; reading them all costs a per cent of a core.
    """

    __slots__ = ("encoded",)

    def __init__(self) -> None:
        """Hold nothing; the fields of the message are never made."""
        self.encoded = b""

    def deserialize(self, encoded: bytes) -> "_EncodedOdometry":
        """Keep what was sent."""
        self.encoded = encoded
        return self


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

    Subscribes ``odom`` (nav_msgs/Odometry).
    """

    def __init__(self) -> None:
        self._condition = threading.Condition()
        self._encoded = b""
        self._count = 0
        self._subscriber = rospy.Subscriber("odom", _EncodedOdometry, self._take, queue_size=1, tcp_nodelay=True)

    @property
    def topic(self) -> str:
        """Resolved name of the topic."""
        return self._subscriber.resolved_name

    def _take(self, message: _EncodedOdometry) -> None:
        with self._condition:
            self._encoded = message.encoded
            self._count += 1
            self._condition.notify_all()

    @property
    def count(self) -> int:
        """Number of messages so far."""
        with self._condition:
            return self._count

    def wake(self) -> None:
        """Wake all waiting threads."""
        with self._condition:
            self._condition.notify_all()

    def latest(self) -> Optional[OdometrySample]:
        """Return the newest sample; None if there is none, or if its numbers are not finite."""
        with self._condition:
            encoded = self._encoded
        return self._read(encoded) if encoded else None

    def wait_newer(self, *, than: int, timeout_s: float) -> Tuple[Optional[OdometrySample], int]:
        """Wait for a usable sample behind the ``than``-th message, or until the thread is woken.

        Returns:
            the sample, or None if there is none; and the count of messages so far
        """
        end_s = time.monotonic() + timeout_s
        while True:
            with self._condition:
                if self._count <= than:
                    self._condition.wait(max(0.0, end_s - time.monotonic()))
                encoded, count = self._encoded, self._count
            if count <= than:
                return None, count
            sample = self._read(encoded)
            if sample is not None or time.monotonic() >= end_s:
                return sample, count
            than = count

    def _read(self, encoded: bytes) -> Optional[OdometrySample]:
        sample = sample_of(Odometry().deserialize(encoded))
        if sample.is_finite():
            return sample
        rospy.logerr_throttle(1.0, "odometry with numbers that are not finite on %s", self.topic)
        return None
