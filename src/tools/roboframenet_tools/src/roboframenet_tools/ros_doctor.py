"""Checks of the running graph for ``rfn doctor``."""

import time
from typing import Iterable, List

import rosgraph
import rosnode
import rospy
from roboframenet_msgs.msg import FileProblem, FileProblems, FrameCatalogue, FrameServers

from offline_pipeline.knowledge import load_texts
from roboframenet_ros.ros_master import NO_ANSWER, TimedMaster
from roboframenet_ros.ros_waiting import wait_for_message
from roboframenet_tools.finding import Finding, clock_finding
from roboframenet_tools.registrations import Registered, registration_findings
from roboframenet_tools.robot_checks import robot_findings
from roboframenet_tools.ros_robot import look_at_robot

#: How long to wait for the latched catalogue, and then for latched problems of files; seconds.
_TIMEOUT_S = 5.0
_PAUSE_S = 0.5

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
#: With ``compact``, one process runs the stages of the others.
TOGETHER = "stages"
ALONE = ("stanford_parser_ros", "stop_server")


def graph_findings(*, robot: bool = False, moves_nothing: Iterable[str] = ()) -> List[Finding]:
    """Check the master, the nodes of the pipeline, and the time.

    Args:
        robot: whether to check what a robot needs, too
        moves_nothing: action servers that a stop need not cancel
    """
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
    is_compact = any(name.rsplit("/", 1)[-1] == TOGETHER for name in names)
    for wanted in (TOGETHER, *ALONE) if is_compact else PIPELINE:
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
    findings += [_time()] + _knowledge()
    return findings + _robot(moves_nothing) if robot else findings


def _robot(moves_nothing: Iterable[str]) -> List[Finding]:
    _join()
    try:
        graph = look_at_robot()
    except NO_ANSWER as error:
        return [Finding("robot", f"the master does not answer: {error}", "see whether roscore runs, and the network")]
    return robot_findings(graph, moves_nothing=[rospy.resolve_name(name) for name in moves_nothing])


def _knowledge() -> List[Finding]:
    """Check what the framer and the registrar know: their servers, and the files that they refused."""
    _join()
    problems: List[FileProblem] = []
    subscriber = rospy.Subscriber("file_problems", FileProblems, lambda message: problems.extend(message.problems))
    try:
        catalogue = wait_for_message("frame_catalogue", FrameCatalogue, _TIMEOUT_S)
        registered = wait_for_message("frame_servers", FrameServers, _TIMEOUT_S)
    except rospy.ROSException:
        return [Finding("catalogue", "the registrar publishes none", "look at the log of frame_registrar")]
    finally:
        # Both nodes have latched theirs.
        time.sleep(_PAUSE_S)
        subscriber.unregister()
    knowledge = load_texts([(file.path, lambda file=file: file.text) for file in catalogue.files], [])
    servers = [Registered(one.frame_name, one.callback_topic, one.is_alive) for one in registered.callbacks]
    refused = [
        Finding("file", f"{one.path}:{one.line}: {one.key}: {one.found}", f"expected {one.expected} {one.hint}".strip())
        for one in problems
    ]
    return registration_findings(knowledge.frames, servers) + refused


def _join() -> None:
    if not rospy.core.is_initialized():
        rospy.init_node("rfn_doctor", anonymous=True, disable_signals=True)


def _time() -> Finding:
    master = rosgraph.Master("/rfn_doctor")
    if not master.hasParam("/use_sim_time") or not master.getParam("/use_sim_time"):
        return Finding("time", "of the machine")
    try:
        _join()
        wait_for_message("/clock", rospy.AnyMsg, _TIMEOUT_S)
    except rospy.ROSException as error:
        return Finding(
            "time",
            f"simulated, but no clock arrives: {error}",
            "start the publisher of /clock, or set /use_sim_time to false",
        )
    return clock_finding(TimedMaster(timeout_s=_TIMEOUT_S).system_state().publishers.get("/clock", ()))
