"""What the tests of the whole graph share."""

import os
import time
import xmlrpc.client
from typing import Callable, Iterable, Set, Tuple

import rosgraph
import rospy
from roboframenet_msgs.msg import FrameCatalogue, Lexicon

#: What each stage of the pipeline listens to; the parser does only when its models are loaded.
STAGE_TOPICS = (
    "text",
    "command_text",
    "command_parse",
    "command_lexical_units",
    "command_semantic_frames",
    "command_procedure",
)
#: What goes past the pipeline, or back.
OTHER_TOPICS = ("command_cancel", "stop_report", "stage_events", "reply", "lexicon", "frame_catalogue")


def wait_until(condition: Callable[[], bool], timeout_s: float = 60.0) -> bool:
    """Wait for a condition; return whether it came true in time."""
    end = time.monotonic() + timeout_s
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.02)
    return condition()


def can_do(frames: Iterable[str], *, unit_files: Iterable[str] = (), timeout_s: float = 60.0) -> bool:
    """Wait until somebody who lives has registered for each frame; a server may come later than the pipeline.

    Args:
        frames: names of frames
        unit_files: names of lexical unit files, without folders, that are read by then
        timeout_s: how long to wait
    Returns:
        whether all is there
    """
    done: Set[str] = set()
    known: Set[str] = set()

    def on_catalogue(catalogue: FrameCatalogue) -> None:
        done.update(callback.frame_name for callback in catalogue.callbacks if callback.is_alive)

    def on_lexicon(lexicon: Lexicon) -> None:
        known.update(os.path.basename(file.path) for file in lexicon.files)

    subscribers = [
        rospy.Subscriber("frame_catalogue", FrameCatalogue, on_catalogue),
        rospy.Subscriber("lexicon", Lexicon, on_lexicon),
    ]
    try:
        return wait_until(lambda: done.issuperset(frames) and known.issuperset(unit_files), timeout_s)
    finally:
        for subscriber in subscribers:
            subscriber.unregister()


def is_pipeline_complete() -> bool:
    """Whether every stage listens, and it and this test are connected to all who speak to them: what is said before
    is lost."""
    master = rosgraph.Master(rospy.get_name())
    publishers, subscribers, _ = master.getSystemState()
    speakers, listeners = dict(publishers), dict(subscribers)
    stages = {rospy.get_name()}
    for topic in map(rospy.resolve_name, STAGE_TOPICS):
        heard_by = set(listeners.get(topic, ())) - {rospy.get_name()}
        if not heard_by:
            return False
        stages |= heard_by
    try:
        for node in stages:
            heard = heard_publishers(master.lookupNode(node))
            for topic in map(rospy.resolve_name, STAGE_TOPICS + OTHER_TOPICS):
                if node in listeners.get(topic, ()) and not all(
                    (topic, master.lookupNode(speaker)) in heard for speaker in speakers.get(topic, ())
                ):
                    return False
    except (rosgraph.MasterException, OSError):
        return False  # a node is about to come, or to go
    return True


def heard_publishers(uri: str) -> Set[Tuple[str, str]]:
    """Topics that a node is connected to, each with the address of the publisher.

    Raises:
        OSError: the node is not there
    """
    connections = xmlrpc.client.ServerProxy(uri).getBusInfo(rospy.get_name())[2]
    return {(entry[4], entry[1]) for entry in connections if entry[2] == "i" and entry[5]}
