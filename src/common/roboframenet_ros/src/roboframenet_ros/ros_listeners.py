"""Whether whoever listens to a topic is connected."""

import rospy

from roboframenet_ros.ros_master import NO_ANSWER, TimedMaster, is_running
from roboframenet_ros.ros_publishing import connections_of

#: How long the master, and a listener that is not connected, may take to answer, seconds.
_MASTER_S, _LISTENER_S = 1.0, 0.2


def has_every_listener(publisher: rospy.Publisher) -> bool:
    """Whether all nodes that listen to a topic are connected to this one, for what is published only once.

    The master knows a node that was killed for ever: it is not waited for. A topic without a listener has not all of
    them: they may be starting, as this node is.

    Args:
        publisher: of the topic
    """
    connected = {connection.endpoint_id for connection in connections_of(publisher)}
    if not connected:
        return False
    master = TimedMaster(timeout_s=_MASTER_S)
    try:
        missing = master.system_state().subscribers.get(publisher.resolved_name, frozenset()) - connected
        return all(is_running(master.uri_of(node), timeout_s=_LISTENER_S) is False for node in sorted(missing))
    except NO_ANSWER as error:
        rospy.logdebug("who listens to %s is not known: %s", publisher.resolved_name, error)
        return False
