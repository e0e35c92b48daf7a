"""Publishes zero velocity, and records the nodes that publish other velocities."""

import threading
import time
from typing import Dict, List, Tuple

import rospy
from geometry_msgs.msg import Twist

from roboframenet_ros.ros_publishing import publish
from robot_stop.braking import VelocitySeen

# A node that has published no velocity for this long is forgotten, seconds.
_FORGET_S = 5.0


class Velocities:
    """Publishes zero velocity, and records what other nodes publish on the same topics.

    While it holds the robot, it answers each velocity of another node with a zero at once: without a multiplexer the
    last message counts, and a fixed rate would lose against a faster publisher.
    """

    def __init__(self, topics: Tuple[str, ...]) -> None:
        """Connect.

        Args:
            topics: names of topics of geometry_msgs/Twist
        """
        self._lock = threading.Lock()
        self._seen: Dict[Tuple[str, str], VelocitySeen] = {}
        self._is_holding = False
        self._publishers = {topic: rospy.Publisher(topic, Twist, queue_size=1, tcp_nodelay=True) for topic in topics}
        self._subscribers: List[rospy.Subscriber] = []

    def start(self) -> None:
        """Subscribe to the velocity topics."""
        self._subscribers = [
            rospy.Subscriber(topic, Twist, self._hear, callback_args=topic, queue_size=10, tcp_nodelay=True)
            for topic in self._publishers
        ]

    def stop(self) -> None:
        """Publish zero velocity once."""
        for topic in self._publishers:
            self._publish_zero(topic)

    def hold(self, is_holding: bool) -> None:
        """Begin or cease to answer the velocities of other nodes with zero."""
        self._is_holding = is_holding

    def seen(self) -> Tuple[VelocitySeen, ...]:
        """The last velocity of each node that published one recently."""
        with self._lock:
            now_s = time.monotonic()
            self._seen = {key: seen for key, seen in self._seen.items() if now_s - seen.heard_s < _FORGET_S}
            return tuple(self._seen.values())

    def _hear(self, message: Twist, topic: str) -> None:
        # NaN does not count as zero.
        if not any(
            value != 0.0 for vector in (message.linear, message.angular) for value in (vector.x, vector.y, vector.z)
        ):
            return
        if self._is_holding:
            self._publish_zero(topic)
        node = message._connection_header.get("callerid", "somebody")
        now_s = time.monotonic()
        with self._lock:
            before = self._seen.get((node, topic))
            self._seen[(node, topic)] = VelocitySeen(
                node=node,
                topic=rospy.resolve_name(topic),
                heard_s=now_s,
                period_s=None if before is None else now_s - before.heard_s,
            )

    def _publish_zero(self, topic: str) -> None:
        publish(self._publishers[topic], Twist())
