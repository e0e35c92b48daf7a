"""Zero velocity, and who publishes another one."""

import threading
import time
from typing import Dict, List, Tuple

import rospy
from geometry_msgs.msg import Twist

from robot_stop.braking import VelocitySeen

# Who has published no velocity for so long is forgotten, seconds.
_FORGET_S = 5.0


class Velocities:
    """Publishes zero velocity and watches what others publish on the same topics.

    While it holds, it answers each velocity of somebody else with a zero of its own at once: where there is no
    multiplexer the last message counts, and a fixed rate would lose against a faster publisher.
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
        """Begin to watch."""
        self._subscribers = [
            rospy.Subscriber(topic, Twist, self._hear, callback_args=topic, queue_size=10, tcp_nodelay=True)
            for topic in self._publishers
        ]

    def stop(self) -> None:
        """Publish zero velocity once."""
        for topic in self._publishers:
            self._publish_zero(topic)

    def hold(self, is_holding: bool) -> None:
        """Answer velocities of others with zero, or no longer."""
        self._is_holding = is_holding

    def seen(self) -> Tuple[VelocitySeen, ...]:
        """The last velocity of each node that published one not long ago."""
        with self._lock:
            now_s = time.monotonic()
            self._seen = {key: seen for key, seen in self._seen.items() if now_s - seen.heard_s < _FORGET_S}
            return tuple(self._seen.values())

    def _hear(self, message: Twist, topic: str) -> None:
        # Not a number is not zero.
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
        try:
            self._publishers[topic].publish(Twist())
        except rospy.ROSException:
            if not rospy.is_shutdown():
                raise
