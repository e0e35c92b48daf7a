"""Finds out whether the pipeline is ready for commands."""

import xmlrpc.client
from typing import Dict, Optional, Set, Tuple

import rospy

from roboframenet_ros.ros_master import NO_ANSWER, TimedMaster
from roboframenet_ros.timed_transport import TimedTransport

#: The topic that each stage of the pipeline subscribes to. The parser subscribes when its models are loaded.
STAGE_TOPICS = (
    "text",
    "command_text",
    "command_parse",
    "command_lexical_units",
    "command_semantic_frames",
    "command_plan",
)
#: Topics that bypass stages of the pipeline, or lead back to earlier ones.
OTHER_TOPICS = ("command_cancel", "stop_report", "stage_events", "reply", "lexicon", "frame_catalogue", "frame_servers")
#: How long a node may take to answer, seconds.
_ANSWER_TIMEOUT_S = 5.0


def is_pipeline_complete() -> bool:
    """Whether all stages have subscribed, and they and this node are connected to all their publishers.

    Messages that are published before are lost. Nodes that were killed are ignored; the master still lists them.
    """
    graph = _Graph()
    try:
        state = graph.master.system_state()
    except NO_ANSWER:
        return False
    speakers, listeners = state.publishers, state.subscribers
    stages = {rospy.get_name()}
    # Observers listen too; only stages report events. The command server hears the texts, and reports none.
    reporting = speakers.get(rospy.resolve_name("stage_events"), frozenset())
    for topic in map(rospy.resolve_name, STAGE_TOPICS):
        found = {node for node in listeners.get(topic, ()) if node != rospy.get_name() and graph.is_alive(node)}
        if topic != rospy.resolve_name("text"):
            found &= reporting
        if not found:
            return False
        stages |= found
    return all(
        graph.is_heard(speaker, topic, node) or not graph.is_alive(speaker)
        for topic in map(rospy.resolve_name, STAGE_TOPICS + OTHER_TOPICS)
        for node in stages.intersection(listeners.get(topic, ()))
        for speaker in speakers.get(topic, ())
    )


class _Graph:
    """The connections that the nodes report. Each node is asked once."""

    def __init__(self) -> None:
        self.master = TimedMaster(timeout_s=_ANSWER_TIMEOUT_S)
        self._listeners: Dict[str, Optional[Set[Tuple[str, str]]]] = {}

    def is_alive(self, node: str) -> bool:
        """Whether a node answers."""
        return self._listeners_of(node) is not None

    def is_heard(self, speaker: str, topic: str, listener: str) -> bool:
        """Whether a node that publishes a topic is connected to a subscriber."""
        return (topic, listener) in (self._listeners_of(speaker) or ())

    def _listeners_of(self, node: str) -> Optional[Set[Tuple[str, str]]]:
        """Return the topics and subscribers of a publishing node; None when the node does not answer.

        The publisher is asked, because a subscriber lists a connection a moment before the publisher sends on it.
        """
        if node not in self._listeners:
            try:
                uri = self.master.uri_of(node)
                api = xmlrpc.client.ServerProxy(uri, transport=TimedTransport(_ANSWER_TIMEOUT_S))
                bus = api.getBusInfo(rospy.get_name())[2]
                self._listeners[node] = {(entry[4], entry[1]) for entry in bus if entry[2] == "o" and entry[5]}
            except NO_ANSWER:
                self._listeners[node] = None
        return self._listeners[node]
