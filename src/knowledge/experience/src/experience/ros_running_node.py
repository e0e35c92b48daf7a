"""What ``rfn experience`` needs of a running node; without a master there is none."""

import rosgraph
import rospy
from std_srvs.srv import Trigger

from roboframenet_ros.deadline import NoAnswer, within

_CALLER = "/rfn_experience"
_LONGEST_S = 3.0


def file_of_the_node() -> str:
    """Return the parameter ``~file`` of the node; empty when there is no master, or it is not set."""
    master = rosgraph.Master(_CALLER)
    try:
        return str(master.getParam(rospy.resolve_name("experience/file")))
    except (OSError, rosgraph.MasterException):
        return ""


def reload_experience() -> str:
    """Tell the node to read its file again; returns why it did not, empty for success and when no node runs."""
    name = rospy.resolve_name("reload_experience")
    try:
        rosgraph.Master(_CALLER).lookupService(name)
    except (OSError, rosgraph.MasterException):
        return ""
    try:
        answer = within(_LONGEST_S, rospy.ServiceProxy(name, Trigger), name="reload experience")
    except (rospy.ServiceException, rospy.ROSException, NoAnswer) as error:
        return str(error)
    return "" if answer.success else str(answer.message)
