"""Checks of the running graph for ``rfn doctor``."""

import contextlib
from typing import List

import rosgraph
import rosnode
import rospy
from roboframenet_msgs.msg import FrameCatalogue

from roboframenet_tools.finding import Finding
from roboframenet_tools.registrations import registration_findings
from semantic_frames import FileRefused, load_frame

#: Nodes of the pipeline; the names are those of the launch file.
PIPELINE = (
    "command_server",
    "stanford_parser_ros",
    "semantic_framer",
    "frame_registrar",
    "arbitrator",
    "executor",
    "stop_server",
)


def graph_findings() -> List[Finding]:
    """Check the master, the nodes of the pipeline, and the time."""
    if not rosgraph.is_master_online():
        return [
            Finding(
                "master",
                f"none at {rosgraph.get_master_uri()}",
                "start the pipeline ('make run'), or set ROS_MASTER_URI",
            )
        ]
    findings = [Finding("master", rosgraph.get_master_uri())]
    names = rosnode.get_node_names()
    for wanted in PIPELINE:
        found = [name for name in names if name.rsplit("/", 1)[-1] == wanted]
        if not found:
            findings.append(
                Finding(wanted, "not running", "start the pipeline ('make run'); its log says why a node ended")
            )
        for name in found:
            is_alive = rosnode.rosnode_ping(name, max_count=1, verbose=False)
            findings.append(
                Finding(
                    wanted,
                    "answers" if is_alive else "is registered but does not answer",
                    "" if is_alive else "restart it; 'rosnode cleanup' forgets dead nodes",
                )
            )
    return findings + _registrations() + [_time()]


def _registrations() -> List[Finding]:
    try:
        rospy.init_node("rfn_doctor", anonymous=True, disable_signals=True)
        catalogue = rospy.wait_for_message("frame_catalogue", FrameCatalogue, timeout=5.0)
    except rospy.ROSException as error:
        return [Finding("registrations", f"unknown: {error}", "start frame_registrar")]
    frames = set()
    for file in catalogue.files:
        with contextlib.suppress(FileRefused):
            frames.add(load_frame(file.text, file.path).name)
    registrations = [(one.frame_name, one.callback_topic, one.is_alive) for one in catalogue.callbacks]
    return list(registration_findings(frames, registrations))


def _time() -> Finding:
    master = rosgraph.Master("/rfn_doctor")
    if not master.hasParam("/use_sim_time") or not master.getParam("/use_sim_time"):
        return Finding("time", "of the machine")
    try:
        rospy.init_node("rfn_doctor", anonymous=True, disable_signals=True)
        rospy.wait_for_message("/clock", rospy.AnyMsg, timeout=5.0)
    except rospy.ROSException as error:
        return Finding(
            "time",
            f"simulated, but no clock arrives: {error}",
            "start the publisher of /clock, or set /use_sim_time to false",
        )
    return Finding("time", "simulated, the clock runs")
