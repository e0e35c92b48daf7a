"""Whether the pipeline is ready for commands."""

import xmlrpc.client
from http.client import HTTPConnection, HTTPException
from typing import Dict, Optional, Set, Tuple
from xml.parsers.expat import ExpatError

import rosgraph
import rospy

#: Topic that each stage of the pipeline subscribes to; the parser subscribes when its models are loaded.
STAGE_TOPICS = (
    "text",
    "command_text",
    "command_parse",
    "command_lexical_units",
    "command_semantic_frames",
    "command_plan",
)
#: Connections that bypass the pipeline, or lead back.
OTHER_TOPICS = ("command_cancel", "stop_report", "stage_events", "reply", "lexicon", "frame_catalogue")
#: How long a node may take to answer, seconds.
_ANSWER_TIMEOUT_S = 5.0
#: Errors of a call to a node. The port of a dead node may now belong to a program without XML-RPC.
_NO_ANSWER = (OSError, HTTPException, ExpatError, xmlrpc.client.Error, rosgraph.MasterException)


def is_pipeline_complete() -> bool:
    """Whether all stages have subscribed, and they and this node are connected to all their publishers.

    Messages published earlier are lost. The master still lists killed nodes; they are ignored.
    """
    graph = _Graph()
    try:
        publishers, subscribers, _ = graph.master.getSystemState()
    except _NO_ANSWER:
        return False
    speakers, listeners = dict(publishers), dict(subscribers)
    stages = {rospy.get_name()}
    for topic in map(rospy.resolve_name, STAGE_TOPICS):
        found = {node for node in listeners.get(topic, ()) if node != rospy.get_name() and graph.is_alive(node)}
        if not found:
            return False
        stages |= found
    return all(
        graph.is_heard(speaker, topic, node) or not graph.is_alive(speaker)
        for topic in map(rospy.resolve_name, STAGE_TOPICS + OTHER_TOPICS)
        for node in stages.intersection(listeners.get(topic, ()))
        for speaker in speakers.get(topic, ())
    )


class _TimedTransport(xmlrpc.client.Transport):
    """HTTP that gives up on a node that hangs."""

    def make_connection(self, host: object) -> HTTPConnection:
        connection = super().make_connection(host)
        connection.timeout = _ANSWER_TIMEOUT_S
        return connection


class _Graph:
    """Connections of the nodes, as the nodes report them; each node is asked once."""

    def __init__(self) -> None:
        self.master = rosgraph.Master(rospy.get_name())
        self._listeners: Dict[str, Optional[Set[Tuple[str, str]]]] = {}

    def is_alive(self, node: str) -> bool:
        """Whether a node answers."""
        return self._listeners_of(node) is not None

    def is_heard(self, speaker: str, topic: str, listener: str) -> bool:
        """Whether a node that publishes a topic is connected to a subscriber."""
        return (topic, listener) in (self._listeners_of(speaker) or ())

    def _listeners_of(self, node: str) -> Optional[Set[Tuple[str, str]]]:
        """Topics that a node publishes, each with a subscriber; None for a node that does not answer.

        The publisher is asked, because the subscriber counts a connection a moment before the publisher sends on it.
        """
        if node not in self._listeners:
            try:
                api = xmlrpc.client.ServerProxy(self.master.lookupNode(node), transport=_TimedTransport())
                bus = api.getBusInfo(rospy.get_name())[2]
                self._listeners[node] = {(entry[4], entry[1]) for entry in bus if entry[2] == "o" and entry[5]}
            except _NO_ANSWER:
                self._listeners[node] = None
        return self._listeners[node]
