"""Tells the executor which commands are cancelled."""

import threading
from typing import Callable

import rospy
from roboframenet_msgs.msg import Command

from command_server.open_commands import CommandText
from command_server.ros_messages import command_to_message
from roboframenet_ros.recent import Recent

# A stage that hung may pass on a command that was closed meanwhile, up to this time later.
_MAX_AGE_S = 600.0
_MAX_COUNT = 1000


class CancelTopic(rospy.SubscribeListener):
    """Publishes ``command_cancel``, and resends it to subscribers that connect later.

    An executor that was restarted has received no cancels, and a command may still be on its way to it.
    """

    def __init__(self) -> None:
        """Advertise the topic."""
        self._recent: Recent[Command] = Recent(max_count=_MAX_COUNT, max_age_s=_MAX_AGE_S)
        # rospy calls peer_subscribe() without the lock of the publisher, and both ways of publishing share one buffer.
        self._lock = threading.Lock()
        self._publisher = rospy.Publisher(
            "command_cancel", Command, subscriber_listener=self, queue_size=2 * _MAX_COUNT
        )

    @property
    def is_heard(self) -> bool:
        """Whether there is a subscriber."""
        return self._publisher.get_num_connections() > 0

    def cancel(self, command: CommandText) -> None:
        """Cancel a command."""
        message = command_to_message(command)
        with self._lock:
            self._recent.add(message)
            self._publisher.publish(message)

    def peer_subscribe(
        self, topic_name: str, topic_publish: Callable[[Command], None], peer_publish: Callable[[Command], None]
    ) -> None:
        """Resend the cancels to a new subscriber; called by rospy."""
        with self._lock:
            for message in self._recent.values():
                peer_publish(message)
