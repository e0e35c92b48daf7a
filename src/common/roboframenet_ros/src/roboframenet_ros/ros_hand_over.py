"""Hands commands over to the next stage, also to one that is just starting."""

import threading
import time
from typing import Any, Callable, List, Set, Tuple

import rospy

from roboframenet_ros.recent import Recent
from roboframenet_ros.ros_publishing import connections_of, publish_to

# A command that waits longer would be done at a time at which nobody expects it any more. It is a third of the default
# deadline of a stage, so the command is still open when it is handed over.
_MAX_AGE_S = 5.0
_MAX_COUNT = 100


class HandOver(rospy.SubscribeListener):
    """Publishes on the topic that the next stage reads.

    rospy drops a message that nobody is connected to receive. This class keeps it and sends it to the first subscriber
    that connects within 5 s. Others may read the topic, too (a recording, the page): a node that was connected before
    and comes back gets what was published meanwhile, even if they heard it. So a stage that was killed and starts
    again does what was said meanwhile, and what was sent to it is not sent again.
    """

    def __init__(self, topic: str, message_class: Any, *, max_age_s: float = _MAX_AGE_S) -> None:
        """Advertise the topic.

        Args:
            topic: its name
            message_class: its type
            max_age_s: for how long a message is kept, seconds
        """
        self._lock = threading.Lock()
        # Whoever starts at the same time may still connect.
        self._may_come_until_s = time.monotonic() + max_age_s
        # Messages, and the names of the nodes that each is no more to be sent to.
        self._kept: Recent[Tuple[Any, Set[str]]] = Recent(max_count=_MAX_COUNT, max_age_s=max_age_s)
        self._known_connections: List[Any] = []
        # Names of nodes that were connected.
        self._left: Recent[str] = Recent(max_count=_MAX_COUNT, max_age_s=max_age_s)
        self._was_connected = False
        with self._lock:  # the first subscriber may connect before the publisher has its name here
            self._publisher = rospy.Publisher(topic, message_class, subscriber_listener=self, queue_size=_MAX_COUNT)

    def publish(self, message: Any) -> None:
        """Send a message to who is connected, and keep it for a stage that is not."""
        with self._lock:
            connections = self._connections()
            self._kept.add((message, {connection.endpoint_id for connection in connections}))
            for connection in connections:
                publish_to(self._publisher, connection, message)

    @property
    def is_read(self) -> bool:
        """Whether there is a next stage: it has connected, even if it does not run now, or it may still start."""
        return self._was_connected or self.is_connected or time.monotonic() < self._may_come_until_s

    @property
    def is_connected(self) -> bool:
        """Whether a living subscriber is connected."""
        return bool(connections_of(self._publisher))

    def peer_subscribe(
        self, topic_name: str, topic_publish: Callable[[Any], None], peer_publish: Callable[[Any], None]
    ) -> None:
        """Send what was kept to a new subscriber; called by rospy."""
        with self._lock:
            self._connections()

    def _connections(self) -> List[Any]:
        """Return the connections; new ones were sent first what was kept for them."""
        connections = connections_of(self._publisher)
        for connection in self._known_connections:
            if connection not in connections:
                self._left.add(connection.endpoint_id)
        for connection in connections:
            if connection not in self._known_connections:
                self._catch_up(connection)
        self._known_connections = connections
        return connections

    def _catch_up(self, connection: Any) -> None:
        self._was_connected = True
        node = connection.endpoint_id
        is_back = node in self._left.values()
        for message, nodes in self._kept.values():
            if not nodes or (is_back and node not in nodes):
                publish_to(self._publisher, connection, message)
            # A node that is new has no part in what others heard before, not even when it comes back.
            nodes.add(node)
