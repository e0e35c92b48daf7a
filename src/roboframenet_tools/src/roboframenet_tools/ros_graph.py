"""Frames, lexical units and servers of the running graph."""
from typing import Tuple

import rosgraph
import rospy

from roboframenet_msgs.msg import FrameCatalogue, Lexicon
from offline_pipeline.knowledge import Knowledge, load_texts


def is_master_up() -> bool:
    """Whether a ROS master answers."""
    return bool(rosgraph.is_master_online())


def live_knowledge(*, timeout_s: float) -> Knowledge:
    """Read the latched catalogue and lexicon.

    Args:
        timeout_s: how long to wait for each, seconds
    Raises:
        LookupError: no master, or nobody publishes them
    """
    if not is_master_up():
        raise LookupError("no ROS master answers: start the pipeline, or leave --live away")
    try:
        rospy.init_node("rfn", anonymous=True, disable_signals=True)
        catalogue = rospy.wait_for_message("frame_catalogue", FrameCatalogue, timeout=timeout_s)
        lexicon = rospy.wait_for_message("lexicon", Lexicon, timeout=timeout_s)
    except rospy.ROSException as error:
        raise LookupError(f"the pipeline is not up: {error}") from error
    knowledge = load_texts([(file.path, lambda file=file: file.text) for file in catalogue.files],
                           [(file.path, lambda file=file: file.text) for file in lexicon.files])
    for callback in catalogue.callbacks:
        if callback.is_alive:
            knowledge.graph.register(callback.frame_name, callback.callback_topic)
    return knowledge


#: Subscribed by a PR2, real or simulated; a robot that takes velocities and has no such arm counts as a Turtlebot.
_ARM_GOAL = "r_arm_controller/joint_trajectory_action/goal"


def robots_up() -> Tuple[str, ...]:
    """Return the robots in the running graph, by what is subscribed to in each namespace."""
    _, subscribers, _ = rosgraph.Master("/rfn").getSystemState()
    topics = [topic for topic, nodes in subscribers if nodes]
    arms = {topic[:-len(_ARM_GOAL)] for topic in topics if topic.endswith("/" + _ARM_GOAL)}
    bases = {topic[:-len("cmd_vel")] for topic in topics if topic.endswith("/cmd_vel")}
    return ("turtlebot",) * len(bases - arms) + ("pr2",) * len(arms)
