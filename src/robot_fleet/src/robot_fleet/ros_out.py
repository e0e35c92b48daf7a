"""What the node ``fleet`` tells right after its start: whoever listens must be connected before it is told."""

import time
from typing import List, Tuple

import rospy
from roboframenet_msgs.msg import Reply
from std_msgs.msg import Empty, String

from roboframenet_ros.ros_listeners import has_every_listener
from robot_fleet.untaken_texts import KEY_LENGTH

#: After this time whoever listens is connected, or hangs; seconds.
SETTLED_S = 3.0


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


class TakenOut:
    """Tells the robots which texts were taken: one of them answers the others. One thread owns it.

    Publishes: ``text_taken`` (the id, a blank and the text), ``fleet_started`` (latched).
    """

    def __init__(self) -> None:
        self._taken = rospy.Publisher("text_taken", String, queue_size=1000)
        self._started = rospy.Publisher("fleet_started", Empty, queue_size=1, latch=True)
        self._again_s = time.monotonic() + SETTLED_S
        self._again: List[Tuple[str, str]] = []

    def tell_start(self) -> None:
        """From now on texts are heard."""
        self._again_s = time.monotonic() + SETTLED_S
        self._started.publish(Empty())

    def tell(self, command_id: str, text: str) -> None:
        """A text was taken, and will be answered; right after the start it is told again when all are connected."""
        self._taken.publish(String(data=f"{command_id} {text[:KEY_LENGTH]}"))
        if time.monotonic() < self._again_s:
            self._again.append((command_id, text))

    def turn(self) -> None:
        """Tell again what was told before all were connected."""
        if self._again and time.monotonic() >= self._again_s:
            again, self._again = self._again, []
            for command_id, text in again:
                self.tell(command_id, text)
