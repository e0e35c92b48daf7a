"""What the tests of the whole graph share."""

import time
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
    """Whether every stage listens."""
    _, subscribers, _ = rosgraph.Master(rospy.get_name()).getSystemState()
    heard = {topic for topic, nodes in subscribers if set(nodes) - {rospy.get_name()}}
    return all(rospy.resolve_name(topic) in heard for topic in STAGE_TOPICS)
