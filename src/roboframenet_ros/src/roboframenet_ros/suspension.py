"""Notices that the process did not run for a while."""

import time
from typing import Callable


class SuspensionWatch:
    """Tells a loop, and the threads beside it, that the process was suspended (SIGSTOP), or starved.

    A process that wakes finds its deadlines over and its sockets full: it must read before it judges. One loop calls
    `turn`; other threads may call `is_just_awake`.
    """

    def __init__(self, *, longest_turn_s: float, now: Callable[[], float] = time.monotonic) -> None:
        """Begin now.

        Args:
            longest_turn_s: a turn of the loop that takes longer means that the process did not run
            now: monotonic clock, seconds
        """
        self._longest_turn_s = longest_turn_s
        self._now = now
        self._turn_s = now()
        self._woke_s = float("-inf")

    def turn(self) -> float:
        """The loop turns; returns for how long the process was away, 0 if it was not."""
        now_s = self._now()
        away_s, self._turn_s = now_s - self._turn_s, now_s
        if away_s <= self._longest_turn_s:
            return 0.0
        self._woke_s = now_s
        return away_s

    def is_just_awake(self, *, within_s: float) -> bool:
        """Whether the process woke so little ago, or has not turned since it was away."""
        now_s = self._now()
        return now_s - self._turn_s > self._longest_turn_s or now_s - self._woke_s < within_s
