"""Goals whose client is gone: nobody would cancel them any more."""

from typing import Callable, Dict, Iterable, List, Set


class OrphanWatch:
    """Finds the goals whose client listened to the status of its server, and listens no more: it died, or has left.

    Who only publishes a goal, as ``rostopic pub`` does, never listens, and its goal is no orphan.
    """

    def __init__(self, is_listening: Callable[[str], bool]) -> None:
        """Start empty.

        Args:
            is_listening: whether the node of a name listens to the status now
        """
        self._is_listening = is_listening
        self._clients: Dict[str, str] = {}
        self._have_listened: Set[str] = set()

    def note(self, goal_id: str, client: str) -> None:
        """A goal has come.

        Args:
            goal_id: of the goal
            client: name of the node that sent it
        """
        self._clients[goal_id] = client

    def orphans(self, goal_ids: Iterable[str]) -> List[str]:
        """Return those of the goals whose client is gone.

        Args:
            goal_ids: of all goals that are not over; others are forgotten
        """
        self._clients = {goal_id: self._clients[goal_id] for goal_id in goal_ids if goal_id in self._clients}
        listening = {client for client in set(self._clients.values()) if self._is_listening(client)}
        gone = self._have_listened - listening
        self._have_listened = (self._have_listened & set(self._clients.values())) | listening
        return [goal_id for goal_id, client in self._clients.items() if client in gone]
