"""The processes of nodes."""

from xmlrpc.client import ServerProxy

import rosgraph
import rospy


def process_of(node: str) -> int:
    """Return the process id of a node.

    Args:
        node: its name; a relative one is resolved as that of a topic is

    Raises:
        OSError: the node, or the master, does not answer
        rosgraph.MasterException: the master knows no such node
    """
    caller = rospy.get_name()
    uri = rosgraph.Master(caller).lookupNode(rospy.resolve_name(node))
    return int(ServerProxy(uri).getPid(caller)[2])
