"""Hands commands over to the next stage, also to one that is just starting."""

import threading
import time
from typing import Any, Callable

import rospy

from roboframenet_ros.recent import Recent
from roboframenet_ros.ros_publishing import publish

# A command that waits longer would be done at a time at which nobody expects it any more. It is a third of the default
# deadline of a stage, so the command is still open when it is handed over.
_MAX_AGE_S = 5.0
_MAX_COUNT = 100


class HandOver(rospy.SubscribeListener):
    """Publishes on the topic that the next stage reads.

    rospy drops a message that nobody is connected to receive. This class keeps it and sends it to the first subscriber
    that connects within 5 s: a stage that was killed and starts again does what was said meanwhile.
    """

    def __init__(self, topic: str, message_class: Any, *, max_age_s: float = _MAX_AGE_S) -> None:
        """Advertise the topic.

        Args:
            topic: its name
            message_class: its type
            max_age_s: for how long a message is kept while nobody is connected, seconds
        """
        self._lock = threading.Lock()
        # Whoever starts at the same time may still connect.
        self._may_come_until_s = time.monotonic() + max_age_s
        self._was_connected = False
        self._kept: Recent[Any] = Recent(max_count=_MAX_COUNT, max_age_s=max_age_s)
        self._publisher = rospy.Publisher(topic, message_class, subscriber_listener=self, queue_size=_MAX_COUNT)

    def publish(self, message: Any) -> None:
        """Send a message to the next stage, or keep it until that stage connects."""
        with self._lock:
            if self.is_connected:
                publish(self._publisher, message)
            else:
                self._kept.add(message)

    @property
    def is_read(self) -> bool:
        """Whether there is a next stage: it has connected, even if it does not run now, or it may still start."""
        return self._was_connected or self.is_connected or time.monotonic() < self._may_come_until_s

    @property
    def is_connected(self) -> bool:
        """Whether a living subscriber is connected."""
        if self._publisher.impl is None:
            return False  # the node shuts down
        # Without this call, rospy notices that a subscriber has died only when it writes to it; what it writes is lost.
        self._publisher.impl.check()
        return bool(self._publisher.get_num_connections())

    def peer_subscribe(
        self, topic_name: str, topic_publish: Callable[[Any], None], peer_publish: Callable[[Any], None]
    ) -> None:
        """Send what was kept to a new subscriber; called by rospy."""
        with self._lock:
            self._was_connected = True
            for message in self._kept.values():
                peer_publish(message)
            self._kept.clear()
