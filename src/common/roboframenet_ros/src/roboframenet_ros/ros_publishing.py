"""Publishing while a node may be shutting down."""

from contextlib import contextmanager
from typing import Any, Iterator, List, Optional

import rospy


def is_shutting_down() -> bool:
    """Whether the node has begun to shut down. rospy closes topics before ``rospy.is_shutdown()`` says so."""
    return bool(rospy.is_shutdown() or rospy.core.is_shutdown_requested())


@contextmanager
def _may_close_at_shutdown() -> Iterator[None]:
    """Let a topic close while the node shuts down; otherwise its ROSException goes on."""
    try:
        yield
    except rospy.ROSException:
        if not is_shutting_down():
            raise


def publish(publisher: Optional[rospy.Publisher], message: Any) -> None:
    """Publish; a topic that closes because the node shuts down is not an error.

    Raises:
        ROSException: the topic was closed although the node goes on
    """
    with _may_close_at_shutdown():
        if publisher is not None:
            publisher.publish(message)


def connections_of(publisher: rospy.Publisher) -> List[Any]:
    """Return the connections to living subscribers; ``endpoint_id`` of each is the name of its node."""
    if publisher.impl is None:
        return []  # the node shuts down
    # Without this call, rospy notices that a subscriber has died only when it writes to it; what it writes is lost.
    publisher.impl.check()
    return list(publisher.impl.connections)


def publish_to(publisher: rospy.Publisher, connection: Any, message: Any) -> None:
    """Publish for one subscriber only; a topic that closes because the node shuts down is not an error.

    Args:
        publisher: of the topic
        connection: one of `connections_of` it
        message: to send

    Raises:
        ROSException: the topic was closed although the node goes on
    """
    topic = publisher.impl
    if topic is None:
        return
    with _may_close_at_shutdown():
        topic.acquire()
        try:
            topic.publish(message, connection_override=connection)
        finally:
            topic.release()


def unregister(end: Any) -> None:
    """Unregister a publisher or a subscriber, and give its descriptors back.

    rospy leaves one of each topic, with which it notices broken connections, to the garbage collector: in a node that
    loses one server after the other, they pile up.

    Args:
        end: ``rospy.Publisher`` or ``rospy.Subscriber``
    """
    topic = end.impl
    end.unregister()
    # Another end of this process may use the topic still.
    if topic is not None and topic.closed and hasattr(topic.connection_poll.poller, "close"):
        topic.connection_poll.poller.close()
