"""The master and the nodes, asked by XML-RPC with a deadline."""

import http.client
import xmlrpc.client
from dataclasses import dataclass
from typing import Any, FrozenSet, Mapping, Optional, Tuple, Type
from xml.parsers.expat import ExpatError

import rosgraph
import rospy

from roboframenet_ros.timed_transport import RememberingTransport, TimedTransport


class MasterError(RuntimeError):
    """The master refused a call; the message says why."""


#: Errors of a call to the master or to a node. The port of a dead node may now belong to a program without XML-RPC.
NO_ANSWER: Tuple[Type[Exception], ...] = (
    OSError,
    http.client.HTTPException,
    ExpatError,
    xmlrpc.client.Error,
    MasterError,
)


@dataclass(frozen=True)
class SystemState:
    """Publishers and subscribers of each topic: names of nodes by name of the topic."""

    publishers: Mapping[str, FrozenSet[str]]
    subscribers: Mapping[str, FrozenSet[str]]


class TimedMaster:
    """Calls to the master with a deadline. One thread owns it.

    Every method raises one of `NO_ANSWER`.
    """

    def __init__(self, *, timeout_s: float) -> None:
        """Prepare.

        Args:
            timeout_s: how long the master may take to answer
        """
        self._proxy = xmlrpc.client.ServerProxy(rosgraph.get_master_uri(), transport=RememberingTransport(timeout_s))
        # What the master said last, and what was made of it.
        self._last: Tuple[object, SystemState] = (None, SystemState({}, {}))
        self._typed: Optional[SystemState] = None
        self._types: Mapping[str, str] = {}

    def system_state(self) -> SystemState:
        """Return the publishers and subscribers of all topics."""
        code, message, state = self._proxy.getSystemState(rospy.get_name())
        if code != 1:
            raise MasterError(str(message))
        if state is not self._last[0]:
            publishers, subscribers, _ = state
            made = SystemState(
                publishers={topic: frozenset(nodes) for topic, nodes in publishers},
                subscribers={topic: frozenset(nodes) for topic, nodes in subscribers},
            )
            self._last = (state, made)
        return self._last[1]

    def graph(self) -> Tuple[SystemState, Mapping[str, str]]:
        """Return the system state, and the type of each topic that the master knows, also of nodes that have ended.

        The same objects come again as long as the state is the same: a topic gets its type from a node that publishes
        it or subscribes to it, so the types are asked for after a state that is new.
        """
        state = self.system_state()
        if state is not self._typed:
            self._typed = None
            code, message, types = self._proxy.getTopicTypes(rospy.get_name())
            if code != 1:
                raise MasterError(str(message))
            self._typed, self._types = state, dict(types)
        return state, self._types

    def uri_of(self, node: str) -> str:
        """Return the address of a node."""
        code, message, uri = self._proxy.lookupNode(rospy.get_name(), node)
        if code != 1:
            raise MasterError(str(message))
        return str(uri)


def is_running(uri: str, *, timeout_s: float) -> Optional[bool]:
    """Whether the process of a node runs; None if that is not known: the node hangs, or its host cannot be reached.

    The master is not asked: it knows nodes long after they were killed, and none after it was restarted itself.

    Args:
        uri: XML-RPC address of the node
        timeout_s: how long the node may take to answer
    """
    try:
        xmlrpc.client.ServerProxy(uri, transport=TimedTransport(timeout_s)).getPid(rospy.get_name())
    except ConnectionRefusedError:
        return False
    except NO_ANSWER:
        return None
    return True


def is_process_gone(uri: str, *, timeout_s: float) -> bool:
    """Whether the process of a node has certainly ended: nothing listens at its address. See :func:`is_running`."""
    return is_running(uri, timeout_s=timeout_s) is False


def listeners_of(uri: str, *, timeout_s: float) -> FrozenSet[Tuple[str, str]]:
    """Return who hears what a node publishes: names of topics, and of the nodes that it sends their messages to.

    A subscriber counts a connection a little earlier than the publisher, which sends it nothing until then.

    Args:
        uri: XML-RPC address of the node
        timeout_s: how long the node may take to answer

    Raises:
        NO_ANSWER: it does not answer, or not as ROS demands
    """
    # ROS's slave API describes a link so.
    answer: Any = xmlrpc.client.ServerProxy(uri, transport=TimedTransport(timeout_s)).getBusInfo(rospy.get_name())
    return frozenset((str(link[4]), str(link[1])) for link in answer[2] if link[2] == "o" and link[5])
