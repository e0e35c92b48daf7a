"""Servers that are out of use because they owe the end of a goal."""

import threading
import time
from dataclasses import dataclass
from typing import Callable, Dict, Tuple


@dataclass(frozen=True)
class _Debt:
    """What a server owes.

    Attributes:
        goal_id: the goal that it did not end
        reason: why the goal was given up, a clause that follows the name of the server
        until_s: monotonic seconds
        keep: what must live as long as the entry
    """

    goal_id: str
    reason: str
    until_s: float
    keep: object


class Quarantine:
    """Servers that did not end a goal on cancel. No goal is sent to them until they do, or until a time is over.

    A server that hangs costs its deadlines once, and not with every command. Any thread may call.
    """

    def __init__(self, *, duration_s: float, now: Callable[[], float] = time.monotonic) -> None:
        """
        Args:
            duration_s: a server that stays silent is tried again after this time; 0 for no quarantine
            now: monotonic clock, seconds
        """
        self._duration_s = duration_s
        self._now = now
        self._lock = threading.Lock()
        self._debts: Dict[str, _Debt] = {}

    def put(self, server: str, goal_id: str, reason: str, *, keep: object = None) -> None:
        """A server has not ended a goal.

        Args:
            server: its name
            goal_id: the goal
            reason: a clause that follows the name of the server
            keep: kept until the goal ends, such as the handle that hears of it
        """
        with self._lock:
            self._debts[server] = _Debt(goal_id, reason, self._now() + self._duration_s, keep)

    def hear_end(self, server: str, goal_id: str) -> None:
        """A goal has ended: if the server owed it, it may be used again."""
        with self._lock:
            debt = self._debts.get(server)
            if debt is not None and debt.goal_id == goal_id:
                del self._debts[server]

    @property
    def servers(self) -> Tuple[str, ...]:
        """The servers that are out of use, in alphabetical order."""
        with self._lock:
            return tuple(sorted(server for server, debt in self._debts.items() if self._now() < debt.until_s))

    def refusal(self, server: str) -> str:
        """Return why a server may not be used, a clause that follows its name; empty when it may."""
        with self._lock:
            debt = self._debts.get(server)
            if debt is None:
                return ""
            if self._now() >= debt.until_s:
                del self._debts[server]
                return ""
            return f"is out of use until it ends its last goal: it {debt.reason}"
