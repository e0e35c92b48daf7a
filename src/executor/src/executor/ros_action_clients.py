"""Connections to action servers, kept for the next goal."""

import threading
from collections import OrderedDict
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

    def get(self, server: str, *, timeout_s: float) -> Optional[ActionConnection]:
        """Return the connection to a server; connects if necessary.

        Returns:
            None when the master did not answer in time

        Raises:
            ValueError: the name cannot be that of an action server
        """
        with self._lock:
            known = self._connections.get(server)
            if known is not None:
                self._connections.move_to_end(server)
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
            self._connections[server] = made
            dropped = []
            while len(self._connections) > self._max_kept:
                dropped.append(self._connections.popitem(last=False)[1])
        if dropped:
            # To close asks the master, which may hang.
            threading.Thread(target=self._close_all, args=(dropped,), name="close_connections", daemon=True).start()
        return made

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
