"""Notices that the process was suspended."""

import time
from typing import Callable


class SuspensionWatch:
    """Tells a loop, and other threads, that the process was suspended (SIGSTOP) or starved.

    After a suspension deadlines are over and sockets are full: the process must read messages before it calls a node
    silent. One loop calls `turn`; other threads may call `is_just_awake`.
    """

    def __init__(self, *, longest_turn_s: float, now: Callable[[], float] = time.monotonic) -> None:
        """Start now.

        Args:
            longest_turn_s: a longer turn of the loop means that the process was suspended
            now: monotonic clock, seconds
        """
        self._longest_turn_s = longest_turn_s
        self._now = now
        self._turn_s = now()
        self._woke_s = float("-inf")

    def turn(self) -> float:
        """Called in each turn of the loop; returns how long the process was suspended, 0 if it was not."""
        now_s = self._now()
        away_s, self._turn_s = now_s - self._turn_s, now_s
        if away_s <= self._longest_turn_s:
            return 0.0
        self._woke_s = now_s
        return away_s

    def is_just_awake(self, *, within_s: float) -> bool:
        """Whether the process was resumed within this time, or its loop has not turned since then."""
        now_s = self._now()
        return now_s - self._turn_s > self._longest_turn_s or now_s - self._woke_s < within_s
