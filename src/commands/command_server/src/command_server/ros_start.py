"""Starts the command server: as a node, or with other stages in one process."""

import rospy

from command_server.node import CommandServerNode
from command_server.ros_settings import read_brake_settings
from command_server.settings import Settings
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_place import Place


def start(place: Place) -> CommandServerNode:
    """Start the stage.

    Raises:
        ParameterError: a parameter is wrong
    """
    settings = read_parameters(Settings, prefix=place.private)
    brake_settings = read_brake_settings(place.private)
    rospy.loginfo("command_server: %s", settings)
    node = CommandServerNode(settings, brake_settings, private=place.private)
    node.start()
    return node


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("command_server", lambda: start(Place()))
