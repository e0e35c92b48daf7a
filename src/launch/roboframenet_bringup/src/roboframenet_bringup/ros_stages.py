"""The stages of the pipeline in one process, for computers with little memory; the parser and stop_server stay out."""

import argparse

import rospy

import arbitrator.node
import command_server.ros_start
import executor.node
import frame_registrar.node
import question_answering.node
import semantic_framer.node
import standing_orders.node
import world_model.node
from roboframenet_ros.ros_node import HostedStage, run_stages

#: Who must hear of a stop first starts first: rospy hands a message to the stages of a topic in this order.
STAGES = (
    HostedStage("executor", executor.node.start),
    HostedStage("command_server", command_server.ros_start.start),
    HostedStage("arbitrator", arbitrator.node.start),
    HostedStage("frame_registrar", frame_registrar.node.start),
    HostedStage("semantic_framer", semantic_framer.node.start),
    HostedStage("world_model", world_model.node.start),
    HostedStage("question_answering", question_answering.node.start),
    HostedStage("standing_orders", standing_orders.node.start),
)


def main() -> None:
    """Run the stages until ROS shuts down; exits with a sentence when one cannot start."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--without", nargs="*", default=[], choices=[stage.name for stage in STAGES])
    without = parser.parse_args(rospy.myargv()[1:]).without
    run_stages("stages", [stage for stage in STAGES if stage.name not in without])
