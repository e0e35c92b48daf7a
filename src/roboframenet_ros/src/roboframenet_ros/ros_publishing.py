"""Publishing while a node may be shutting down."""

from typing import Any, Optional

import rospy


def is_shutting_down() -> bool:
    """Whether the node has begun to shut down. rospy closes topics before ``rospy.is_shutdown()`` says so."""
    return bool(rospy.is_shutdown() or rospy.core.is_shutdown_requested())


def publish(publisher: Optional[rospy.Publisher], message: Any) -> None:
    """Publish; a topic that closes because the node shuts down is not an error.

    Raises:
        ROSException: the topic was closed although the node goes on
    """
    try:
        if publisher is not None:
            publisher.publish(message)
    except rospy.ROSException:
        if not is_shutting_down():
            raise
