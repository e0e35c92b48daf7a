"""Waits by the monotonic clock: those of actionlib end by the ROS time, those of rospy by the time of the machine.

The ROS time is 0 until the first message of a simulator's clock arrives, then jumps to any time, and may stand.
"""

import queue
import time
from typing import Any

import rospy

from roboframenet_ros.ros_server_links import ServerLinks, newest_link

_LOOK_S = 0.01
#: How often a wait looks whether ROS shuts down, seconds.
_SHUTDOWN_LOOK_S = 0.2


def wait_for_action_server(client: Any, timeout_s: float) -> bool:
    """Wait until a client and its server are connected both ways.

    Args:
        client: ``actionlib.ActionClient`` or ``actionlib.SimpleActionClient``
        timeout_s: how long to wait
    Returns:
        whether they are; False too when ROS shuts down
    """
    client = getattr(client, "action_client", client)
    links = ServerLinks(
        publishers=(client.pub_goal, client.pub_cancel), subscribers=(client.result_sub, client.feedback_sub)
    )
    end_s = time.monotonic() + timeout_s
    while not rospy.is_shutdown():
        status = client.last_status_msg
        node = "" if status is None else str(status._connection_header["callerid"])
        if links.are_complete(node, newest_link(client.status_sub, node)[1] if node else ""):
            return True
        if time.monotonic() >= end_s:
            return False
        time.sleep(_LOOK_S)
    return False


def wait_for_message(topic: str, message_type: Any, timeout_s: float) -> Any:
    """Return the next message of a topic, or the latched one.

    Args:
        topic: its name
        message_type: class of its messages
        timeout_s: how long to wait
    Raises:
        rospy.ROSException: none came, or ROS shuts down
    """
    messages: queue.Queue[Any] = queue.Queue()
    subscriber = rospy.Subscriber(topic, message_type, messages.put)
    end_s = time.monotonic() + timeout_s
    try:
        while not rospy.is_shutdown():
            rest_s = end_s - time.monotonic()
            if rest_s <= 0.0 and messages.empty():
                raise rospy.ROSException(f"no message on {topic} within {timeout_s:g} s")
            try:
                return messages.get(timeout=min(_SHUTDOWN_LOOK_S, max(0.0, rest_s)))
            except queue.Empty:
                continue
        raise rospy.ROSException(f"ROS shut down before a message on {topic} came")
    finally:
        subscriber.unregister()
