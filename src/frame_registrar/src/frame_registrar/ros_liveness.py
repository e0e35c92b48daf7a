"""Finds out which action servers are running, from the master and the nodes themselves."""

import socket
import threading
import time
import xmlrpc.client
from typing import Callable, Dict, FrozenSet, Iterable, Tuple

import rospy
from roboframenet_msgs.msg import FilledSemanticFrameActionResult

from roboframenet_ros.ros_master import NO_ANSWER, MasterError, TimedMaster
from roboframenet_ros.timed_transport import TimedTransport

#: A server that seems dead is checked again after this time, seconds: its node may be busy, or the server may have
#: registered just before it started.
_SECOND_LOOK_S = 1.0
#: So long after the last change, seconds, a server that is not running is looked for at that pace: it may be starting.
_HOPE_S = 30.0
#: A node that listens and does not answer is busy; after this time, seconds, it counts as hung. Nobody listens at the
#: address of one that has ended.
_LONGEST_SILENCE_S = 10.0
#: An action server publishes its results itself, so the master knows their type from it.
_RESULT_TYPE = FilledSemanticFrameActionResult._type


class LivenessWatch:
    """Asks the nodes of action servers at a low rate whether they still answer.

    The master knows which node publishes ``<server>/status``, also long after that node was killed; the node itself
    answers ``getPid``. Both are interfaces of ROS: servers need no code for it, and a process with many servers is
    asked once.
    """

    def __init__(
        self,
        servers: Callable[[], Iterable[str]],
        on_dead: Callable[[FrozenSet[str]], None],
        *,
        period_s: float,
        timeout_s: float,
    ) -> None:
        """
        Args:
            servers: returns the names of the servers to watch
            on_dead: called from the thread of the watch with the servers that are not running
            period_s: pause between two rounds
            timeout_s: how long a node, or the master, may take to answer
        """
        self._servers = servers
        self._on_dead = on_dead
        self._period_s = period_s
        self._timeout_s = timeout_s
        self._master = TimedMaster(timeout_s=timeout_s)
        # By address of the node. Connections are kept: a new one costs the node a thread and more time than the answer.
        self._proxies: Dict[str, xmlrpc.client.ServerProxy] = {}
        # When nodes that listen were first asked in vain, by the monotonic clock.
        self._silent_since_s: Dict[str, float] = {}
        self._dead: FrozenSet[str] = frozenset()
        self._changed_s = 0.0
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, name="liveness", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """End the watch; return when its thread has ended."""
        self._stop.set()
        self._thread.join(self._period_s + 10.0 * self._timeout_s)

    def _run(self) -> None:
        while not self._stop.wait(self._pause_s()):
            servers = tuple(self._servers())
            if not servers:
                continue
            try:
                dead = self._dead_among(servers)
                if dead - self._dead and not self._stop.wait(min(_SECOND_LOOK_S, self._period_s)):
                    dead &= self._dead_among(servers)
            except NO_ANSWER as error:
                # When the master does not answer, nothing is known about the servers.
                rospy.logwarn_throttle(30.0, "cannot ask the master who is alive: %s", error)
                continue
            if dead != self._dead:
                self._dead, self._changed_s = dead, time.monotonic()
            self._on_dead(dead)

    def _pause_s(self) -> float:
        is_hopeful = self._dead and time.monotonic() < self._changed_s + _HOPE_S
        return min(_SECOND_LOOK_S, self._period_s) if is_hopeful else self._period_s

    def _dead_among(self, servers: Tuple[str, ...]) -> FrozenSet[str]:
        state, types = self._master.graph()
        nodes_of = state.publishers
        answers: Dict[str, bool] = {}
        dead = set()
        known = self._proxies
        self._proxies = {}
        for server in servers:
            nodes = nodes_of.get(rospy.resolve_name(server + "/status"), ())
            for node in nodes:
                if node not in answers:
                    answers[node] = node == rospy.get_name() or self._is_running(node, known)
            result_type = types.get(rospy.resolve_name(server + "/result"), _RESULT_TYPE)
            if not any(answers[node] for node in nodes):
                dead.add(server)
            elif result_type != _RESULT_TYPE:
                # Nothing could be sent to it.
                dead.add(server)
                if server not in self._dead:
                    rospy.logerr("%s takes no frames: its results are of type %s", server, result_type)
        return frozenset(dead)

    def _is_running(self, node: str, known: Dict[str, xmlrpc.client.ServerProxy]) -> bool:
        """Whether a node answers, or may be too busy to.

        Raises:
            Exception: one of `NO_ANSWER`: the master does not answer
        """
        try:
            uri = self._master.uri_of(node)
        except MasterError:
            self._silent_since_s.pop(node, None)
            return False
        proxy = known.get(uri) or xmlrpc.client.ServerProxy(uri, transport=TimedTransport(self._timeout_s))
        try:
            is_alive: bool = proxy.getPid(rospy.get_name())[0] == 1
        except socket.timeout:
            now_s = time.monotonic()
            return now_s < self._silent_since_s.setdefault(node, now_s) + _LONGEST_SILENCE_S
        except NO_ANSWER:
            is_alive = False
        else:
            self._proxies[uri] = proxy
        self._silent_since_s.pop(node, None)
        return is_alive
