"""The node ``rfnserver_host``: many RFNServers in one process."""

import importlib
import inspect
import traceback
from typing import Any, List

import rospy

from roboframenet_ros.ros_node import StartError, run_node
from server_hosting.hosted import Hosted, HostedError, read_hosted


def host(hosted: Hosted) -> Any:
    """Construct a server.

    Raises:
        Exception: raised by its module or constructor
    """
    server_class = getattr(importlib.import_module(hosted.module), hosted.class_name)
    # Servers without parameters may have a constructor without arguments.
    takes_parameters = "parameters" in inspect.signature(server_class).parameters
    return server_class(parameters=hosted.parameters) if takes_parameters else server_class()


def _start() -> List[Any]:
    try:
        wanted = read_hosted(rospy.myargv()[1:])
    except HostedError as error:
        raise StartError(str(error)) from error
    servers: List[Any] = []
    for hosted in wanted:
        try:
            servers.append(host(hosted))
        except Exception as error:  # boundary: one bad server must not take the others with it
            rospy.logerr("%s cannot be hosted: %s: %s", hosted.name, type(error).__name__, error)
            rospy.logdebug("%s", traceback.format_exc())
    if not servers:
        raise StartError("no server could be hosted")
    rospy.loginfo("hosting %d of %d servers", len(servers), len(wanted))
    return servers


def main() -> None:
    """Run the node until ROS shuts down. A server that cannot be constructed is logged, and the others run."""
    run_node("rfnserver_host", _start)
