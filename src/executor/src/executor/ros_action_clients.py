"""Connections to action servers, kept for the next goal."""

import threading
from collections import Counter, OrderedDict
from typing import List, Optional

from roboframenet_msgs.msg import FilledSemanticFrameAction

from roboframenet_ros.deadline import NoAnswer, within
from roboframenet_ros.ros_action_connection import ActionConnection


class ActionClients:
    """Keeps the connections that were used last, by name of the server."""

    def __init__(self, *, max_kept: int) -> None:
        """Start with none.

        Args:
            max_kept: how many connections stay when no goal uses them
        """
        self._max_kept = max_kept
        self._lock = threading.Lock()
        self._connections: OrderedDict[str, ActionConnection] = OrderedDict()
        # How many goals use each connection; those are not closed.
        self._users: Counter[str] = Counter()

    def get(self, server: str, *, timeout_s: float) -> Optional[ActionConnection]:
        """Return the connection to a server; connects if necessary. It stays open until `release`.

        Returns:
            None when the master did not answer in time

        Raises:
            ValueError: the name cannot be that of an action server
        """
        with self._lock:
            known = self._connections.get(server)
            if known is not None:
                self._connections.move_to_end(server)
                self._users[server] += 1
                return known
        try:
            made = within(
                timeout_s, lambda: ActionConnection(server, FilledSemanticFrameAction), name=f"connect_{server}"
            )
        except NoAnswer:
            return None
        except Exception as error:  # boundary: the master or the name may be at fault in many ways
            raise ValueError(str(error)) from error
        with self._lock:
            # A branch of the plan that runs at the same time may have connected meanwhile.
            used = self._connections.setdefault(server, made)
            self._users[server] += 1
            dropped = self._take_unused() + ([] if used is made else [made])
        self._close_later(dropped)
        return used

    def release(self, server: str) -> None:
        """A goal does not use the connection to a server any more."""
        with self._lock:
            self._users[server] -= 1
            if self._users[server] <= 0:
                del self._users[server]
            dropped = self._take_unused()
        self._close_later(dropped)

    def close_gone(self) -> None:
        """Disconnect from servers that are gone and that no goal uses; returns at once."""
        with self._lock:
            gone = [
                server
                for server, connection in self._connections.items()
                if server not in self._users and not connection.is_ready()
            ]
            dropped = [self._connections.pop(server) for server in gone]
        self._close_later(dropped)

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
        self._close_all(connections)

    @staticmethod
    def _close_all(connections: List[ActionConnection]) -> None:
        for connection in connections:
            connection.close()
