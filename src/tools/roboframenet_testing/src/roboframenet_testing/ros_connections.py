"""Connections between nodes. A message that is published before its subscriber has connected is lost."""

import xmlrpc.client

import rosgraph
import rospy


def is_connected(publisher: str, topic: str, subscriber: str) -> bool:
    """Return whether a node that publishes a topic is connected to a node that subscribes.

    The subscriber counts its connection a little earlier than the publisher, so ``get_num_connections()`` of a
    subscriber is too early to say that nothing will be lost.

    Args:
        publisher: name of the node that publishes
        topic: name of the topic, relative or not
        subscriber: name of the node that subscribes
    """
    try:
        node = xmlrpc.client.ServerProxy(rosgraph.Master(rospy.get_name()).lookupNode(publisher))
        connections = node.getBusInfo(rospy.get_name())[2]
    except (rosgraph.MasterException, OSError):
        return False  # it is not up yet
    wanted = [subscriber, "o", rospy.resolve_name(topic)]
    return any([entry[1], entry[2], entry[4]] == wanted and entry[5] for entry in connections)
