"""What the tests of the whole graph share."""

import time
import xmlrpc.client
from typing import Callable

import rosgraph
import rospy

#: What each stage of the pipeline listens to; the parser does only when its models are loaded.
STAGE_TOPICS = (
    "text",
    "command_text",
    "command_parse",
    "command_lexical_units",
    "command_semantic_frames",
    "command_procedure",
)


def wait_until(condition: Callable[[], bool], timeout_s: float = 60.0) -> bool:
    """Wait for a condition; return whether it came true in time."""
    end = time.monotonic() + timeout_s
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.02)
    return condition()


def is_pipeline_complete() -> bool:
    """Whether every stage listens and is connected to those that speak to it: what is said before is lost."""
    publishers, subscribers, _ = rosgraph.Master(rospy.get_name()).getSystemState()
    spoken = {topic for topic, _ in publishers}
    heard = {topic: set(nodes) - {rospy.get_name()} for topic, nodes in subscribers}
    for topic in map(rospy.resolve_name, STAGE_TOPICS):
        if not heard.get(topic):
            return False
        if topic in spoken and not all(is_connected(node, topic) for node in heard[topic]):
            return False
    return True


def is_connected(node: str, topic: str) -> bool:
    """Whether a subscriber has a connection from a publisher of the topic."""
    try:
        api = xmlrpc.client.ServerProxy(rosgraph.Master(rospy.get_name()).lookupNode(node))
        connections = api.getBusInfo(rospy.get_name())[2]
    except (rosgraph.MasterException, OSError):
        return False  # it is about to come, or to go
    return any(entry[2] == "i" and entry[4] == topic and entry[5] for entry in connections)
