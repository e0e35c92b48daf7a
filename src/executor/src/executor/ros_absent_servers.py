"""Looks for servers that are not connected: at the master, and in their own processes."""

import time
from typing import AbstractSet, Dict, FrozenSet, Iterable, Optional

import rospy

from executor.absences import Absences
from roboframenet_ros.ros_master import NO_ANSWER, MasterError, TimedMaster, is_running

#: How long the master, or a node, may take to answer, seconds.
_ANSWER_S = 0.5
#: A server that was killed may be back within so long, seconds.
_STARTING_S = 5.0
#: Nodes are asked for so long, seconds; of the others nothing is known.
_LOOK_S = 1.0


class AbsentServers:
    """Knows which servers are missing; any thread may call.

    The master knows nobody who publishes the status of a server that does not run, or a node whose process has ended.
    """

    def __init__(self, absences: Optional[Absences] = None) -> None:
        """
        Args:
            absences: where they are noted; none if left out
        """
        self._absences = absences or Absences()
        self._living: FrozenSet[str] = frozenset()

    def hear_living(self, servers: FrozenSet[str]) -> None:
        """The registrar tells who lives; one that is new, or lives again, is waited for again."""
        self._absences.forget(servers - self._living)
        self._living = servers

    def hear_connected(self, servers: Iterable[str]) -> None:
        """Servers are connected."""
        self._absences.forget(servers)

    def hear_vain(self, server: str) -> None:
        """A server was waited for in vain."""
        self._absences.note({server})

    def is_missing(self, server: str) -> bool:
        """Whether a server was found missing the last time; nobody is asked."""
        return self._absences.is_missing(server)

    def is_given_up(self, server: str) -> bool:
        """Whether a server has been missing for so long that its connection is of no use; nobody is asked."""
        return self.is_missing(server) and not self._absences.left_s(server, _STARTING_S)

    def look(self, servers: AbstractSet[str]) -> FrozenSet[str]:
        """Return those of some servers that are missing. It takes a second at most, and only where somebody hangs."""
        try:
            self._look(servers)
        except NO_ANSWER as error:
            rospy.logdebug("the master does not list the servers: %s", error)
        return frozenset(filter(self.is_missing, servers))

    def left_s(self, server: str, wait_s: float) -> float:
        """Look for a server that is not connected; return for how long it is still waited for, seconds.

        Args:
            server: its name
            wait_s: for how long each server is waited for
        """
        self.look({server})
        return self._absences.left_s(server, wait_s)

    def _look(self, servers: AbstractSet[str]) -> None:
        if not servers:
            return
        end_s = time.monotonic() + _LOOK_S
        master = TimedMaster(timeout_s=_ANSWER_S)
        publishers = master.system_state().publishers
        nodes_of = {
            server: publishers.get(rospy.resolve_name(rospy.remap_name(server) + "/status"), frozenset())
            for server in servers
        }
        is_there: Dict[str, Optional[bool]] = {}
        for node in sorted(frozenset().union(*nodes_of.values())):
            is_there[node] = _is_there(master, node) if time.monotonic() < end_s else None
        found = {server: [is_there[node] for node in nodes] for server, nodes in nodes_of.items()}
        self._absences.forget(server for server, answers in found.items() if True in answers)
        self._absences.note({server for server, answers in found.items() if all(one is False for one in answers)})


def _is_there(master: TimedMaster, node: str) -> Optional[bool]:
    """Whether the process of a node runs; None when that is not known.

    Raises:
        Exception: one of `NO_ANSWER`: the master does not answer
    """
    if node == rospy.get_name():
        return True
    try:
        uri = master.uri_of(node)
    except MasterError:
        return False
    return is_running(uri, timeout_s=_ANSWER_S)
