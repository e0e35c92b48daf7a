"""Servers that are missing, and since when."""

import threading
import time
from typing import AbstractSet, Callable, Dict, Iterable


class Absences:
    """Notes since when servers are missing; any thread may call.

    A server that is missing may be starting, so it is waited for: once, together with all others that are missing then.
    """

    def __init__(self, *, now: Callable[[], float] = time.monotonic) -> None:
        """Start with none.

        Args:
            now: monotonic clock, seconds
        """
        self._now = now
        self._lock = threading.Lock()
        self._since_s: Dict[str, float] = {}

    def note(self, missing: AbstractSet[str]) -> None:
        """Servers are missing: from now on, if they were not missing before."""
        with self._lock:
            now_s = self._now()
            for server in missing:
                self._since_s.setdefault(server, now_s)

    def forget(self, servers: Iterable[str]) -> None:
        """Servers are there, or may be starting anew."""
        with self._lock:
            for server in servers:
                self._since_s.pop(server, None)

    def is_missing(self, server: str) -> bool:
        """Whether a server was found missing, and not since found again."""
        with self._lock:
            return server in self._since_s

    def left_s(self, server: str, wait_s: float) -> float:
        """Return for how long a server is still waited for, seconds; 0 for one that was waited for.

        Args:
            server: that is not connected
            wait_s: for how long each server is waited for
        """
        with self._lock:
            now_s = self._now()
            return max(0.0, self._since_s.get(server, now_s) + wait_s - now_s)
