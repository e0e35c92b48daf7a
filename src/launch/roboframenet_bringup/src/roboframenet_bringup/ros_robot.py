"""A robot of a fleet in one process: what carries commands out, and the abilities and the simulation of a Turtlebot."""

import argparse
from typing import Tuple

import rospy

import arbitrator.node
import command_server.ros_start
import executor.node
import question_answering.node
import roboframenet_sim.ros_turtlebot
import robot_fleet.ros_member
import standing_orders.node
from roboframenet_bringup.ros_turtlebot_abilities import ABILITIES
from roboframenet_ros.ros_node import HostedStage, run_stages

#: Who must hear of a stop first starts first: rospy hands a message to the stages of a topic in this order.
STAGES: Tuple[HostedStage, ...] = (
    HostedStage("executor", executor.node.start),
    HostedStage("command_server", command_server.ros_start.start),
    HostedStage("arbitrator", arbitrator.node.start),
    HostedStage("question_answering", question_answering.node.start),
    HostedStage("standing_orders", standing_orders.node.start),
    HostedStage("fleet_member", robot_fleet.ros_member.start),
    HostedStage("turtlebot_sim", roboframenet_sim.ros_turtlebot.start),
    *ABILITIES,
)


def main() -> None:
    """Run the robot until ROS shuts down; exits with a sentence when a stage cannot start."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--without", nargs="*", default=[], choices=[stage.name for stage in STAGES])
    without = parser.parse_args(rospy.myargv()[1:]).without
    run_stages("robot", [stage for stage in STAGES if stage.name not in without])
