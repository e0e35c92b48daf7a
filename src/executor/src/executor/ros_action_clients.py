"""Connections to action servers, kept for the next goal."""

import threading
import time
from collections import Counter, OrderedDict
from typing import AbstractSet, Callable, FrozenSet, List, Optional, Set

import rospy
from roboframenet_msgs.msg import FilledSemanticFrameAction

from executor.ros_absent_servers import AbsentServers
from roboframenet_ros.deadline import NoAnswer, within
from roboframenet_ros.ros_action_connection import ActionConnection
from roboframenet_ros.suspension import SuspensionWatch

#: Between two looks at a server that is connected beforehand, seconds, and how many there are: a graph that starts has
#: more to do.
_PAUSE_S, _LOOKS = 0.05, 10
#: A server that is not connected is looked for after this time, seconds.
_GRACE_S = 0.3
#: A longer turn of a wait means that this process did not run, seconds.
_LONGEST_TURN_S = 0.5


class ActionClients:
    """Keeps connections to servers, by name of the server: those that were used last, and those made beforehand.

    A new connection needs the master, which may hang when a command comes.

    Attributes:
        absent: which servers are missing
    """

    def __init__(self, *, max_kept: int, prepare: Callable[[str], object] = lambda _: None) -> None:
        """Start with none.

        Args:
            max_kept: how many connections stay when no goal uses them
            prepare: called with each server that is connected beforehand, for all else that its goals ask the master
        """
        self._prepare_server = prepare
        self.absent = AbsentServers()
        self._max_kept = max_kept
        self._lock = threading.Lock()
        self._connections: OrderedDict[str, ActionConnection] = OrderedDict()
        # How many goals use each connection; those are not closed.
        self._users: Counter[str] = Counter()
        # Servers that are still to be connected beforehand.
        self._wanted: Set[str] = set()
        self._is_preparing = False

    def get(self, server: str, *, timeout_s: float) -> Optional[ActionConnection]:
        """Return the connection to a server; connects if necessary. It stays open until `release`.

        Returns:
            None when the master did not answer in time

        Raises:
            ValueError: the name cannot be that of an action server
        """
        with self._lock:
            # Also while it is being made: a connection that comes late is kept, and not one more for each goal.
            self._users[server] += 1
            known = self._connections.get(server)
            if known is not None:
                self._connections.move_to_end(server)
                return known
        try:
            return within(timeout_s, lambda: self._connect(server), name=f"connect_{server}")
        except NoAnswer:
            self.release(server)
            return None
        except Exception as error:  # boundary: the master or the name may be at fault in many ways
            self.release(server)
            raise ValueError(str(error)) from error

    def _connect(self, server: str) -> ActionConnection:
        """Connect to a server, however long the master takes; another thread may have done so meanwhile."""
        made = ActionConnection(server, FilledSemanticFrameAction)
        with self._lock:
            used = self._connections.setdefault(server, made)
            dropped = self._take_unused() + ([] if used is made else [made])
        self._close_later(dropped)
        return used

    def release(self, server: str) -> None:
        """A goal does not use the connection to a server any more; that to one that is given up is closed.

        Where each command takes the place of the one before, a connection that is made anew with each of them is never
        complete, and a server that starts just then is refused what it asks for.
        """
        with self._lock:
            self._users[server] -= 1
            if self._users[server] <= 0:
                del self._users[server]
            dropped = self._take_unused()
            if server not in self._users and server in self._connections and self.absent.is_given_up(server):
                dropped.append(self._connections.pop(server))
        self._close_later(dropped)

    def wait_until_ready(
        self,
        connection: ActionConnection,
        *,
        timeout_s: float,
        pause: Callable[[], object],
        is_over: Callable[[], bool],
    ) -> str:
        """Wait until a server is connected; one that is missing is waited for once, and not with each goal.

        Args:
            connection: to the server
            timeout_s: how long to wait
            pause: sleeps for a moment
            is_over: whether nobody waits any more
        Returns:
            why it is not connected, a clause that follows its name; empty when it is, and when the wait is over
        """
        server = connection.server
        # Most are connected before a look would be answered.
        end_s = time.monotonic() + (0.0 if self.absent.is_missing(server) else min(_GRACE_S, timeout_s))
        left_s: Optional[float] = None
        suspension = SuspensionWatch(longest_turn_s=_LONGEST_TURN_S)
        while not connection.is_ready():
            end_s += suspension.turn()
            if is_over():
                return ""
            if time.monotonic() < end_s:
                pause()
            elif left_s is None:
                left_s = self.absent.left_s(server, timeout_s)
                end_s = time.monotonic() + left_s
            else:
                self.absent.hear_vain(server)
                return "is not running" + (f": no answer within {timeout_s:g} s" if left_s else "")
        self.absent.hear_connected([server])
        return ""

    def missing(self, servers: AbstractSet[str]) -> FrozenSet[str]:
        """Return those of some servers that are not connected, and missing."""
        with self._lock:
            known = {server: self._connections.get(server) for server in servers}
        connected = frozenset(server for server, one in known.items() if one is not None and one.is_ready())
        self.absent.hear_connected(connected)
        return self.absent.look(servers - connected)

    def hear_living(self, servers: FrozenSet[str]) -> None:
        """The registrar tells who lives: connect to them, and disconnect from those that are gone; returns at once.

        What a goal uses is not closed. Not more connections are made beforehand than are kept.
        """
        self.absent.hear_living(servers)
        with self._lock:
            gone = [
                server
                for server, connection in self._connections.items()
                if server not in servers and server not in self._users and not connection.is_ready()
            ]
            dropped = [self._connections.pop(server) for server in gone]
            self._wanted = set(servers)
            is_idle, self._is_preparing = not self._is_preparing, True
        self._close_later(dropped)
        if is_idle:
            threading.Thread(target=self._prepare, name="prepare_connections", daemon=True).start()

    def _prepare(self) -> None:
        """Connect to those that are wanted, one after the other."""
        while True:
            with self._lock:
                wanted = sorted(self._wanted.difference(self._connections))
                if not wanted or len(self._connections) >= self._max_kept:
                    self._is_preparing = False
                    return
                server = wanted[0]
                self._wanted.discard(server)
                self._users[server] += 1
            try:
                made = self._connect(server)
                self._prepare_server(server)
                for _ in range(_LOOKS):
                    time.sleep(_PAUSE_S)
                    if made.is_ready():
                        break
            except Exception as error:  # boundary: as in `get`; a goal for that server says why
                rospy.logdebug("cannot connect to %s ahead of time: %s", server, error)
            finally:
                self.release(server)

    def _take_unused(self) -> List[ActionConnection]:
        """With the lock held: take out the connections that were used longest ago, down to as many as are kept."""
        unused = [server for server in self._connections if server not in self._users]
        excess = max(0, len(self._connections) - self._max_kept)
        return [self._connections.pop(server) for server in unused[:excess]]

    def _close_later(self, dropped: List[ActionConnection]) -> None:
        if dropped:
            # To close asks the master, which may hang.
            threading.Thread(target=self._close_all, args=(dropped,), name="close_connections", daemon=True).start()

    def close(self) -> None:
        """Close all connections."""
        with self._lock:
            connections = list(self._connections.values())
            self._connections.clear()
            self._wanted.clear()
        self._close_all(connections)

    @staticmethod
    def _close_all(connections: List[ActionConnection]) -> None:
        for connection in connections:
            connection.close()
