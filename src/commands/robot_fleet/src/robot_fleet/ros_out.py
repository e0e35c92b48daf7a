"""The replies of the node ``fleet``: right after its start, whoever listens must be connected before they are told."""

import time
from typing import List

import rospy
from roboframenet_msgs.msg import Reply

from roboframenet_ros.ros_listeners import has_every_listener
from roboframenet_ros.ros_taken_texts import SETTLED_S


class RepliesOut:
    """Publishes ``reply``. One thread owns it."""

    def __init__(self) -> None:
        self._publisher = rospy.Publisher("reply", Reply, queue_size=1000)
        self._settled_s = time.monotonic() + SETTLED_S
        self._held: List[Reply] = []
        self._is_settled = False

    def publish(self, reply: Reply) -> None:
        """Publish a reply; right after the start, when its listeners are connected."""
        self._held.append(reply)
        self.turn()

    def turn(self) -> None:
        """Publish what is held back, if that may be."""
        if not self._held:
            return
        self._is_settled = (
            self._is_settled or time.monotonic() >= self._settled_s or has_every_listener(self._publisher)
        )
        if self._is_settled:
            for reply in self._held:
                self._publisher.publish(reply)
            self._held.clear()
