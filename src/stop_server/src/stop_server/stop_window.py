"""For how long a stop is repeated."""
import time
from typing import Callable, Optional


class StopWindow:
    """The short time after a stop in which zero velocity and cancels are repeated.

    A server that is just starting, or a goal that was on its way when the stop came, must not get past it.
    """

    def __init__(self, *, duration_s: float, now: Callable[[], float] = time.monotonic) -> None:
        """Start closed.

        Args:
            duration_s: how long the window is open after a stop, seconds
            now: monotonic clock, seconds
        """
        self._duration_s = duration_s
        self._now = now
        self._end_s: Optional[float] = None

    def open(self) -> None:
        """A stop was heard."""
        self._end_s = self._now() + self._duration_s

    @property
    def is_open(self) -> bool:
        """Whether the stop is to be repeated still."""
        return self._end_s is not None and self._now() < self._end_s
