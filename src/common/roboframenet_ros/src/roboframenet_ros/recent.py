"""The last few of many, no older than a given age."""

import time
from collections import deque
from typing import Callable, Deque, Generic, List, Tuple, TypeVar

T = TypeVar("T")


class Recent(Generic[T]):
    """Keeps what was added last, bounded in number and in age. Not for several threads at once."""

    def __init__(self, *, max_count: int, max_age_s: float, now: Callable[[], float] = time.monotonic) -> None:
        """Start with nothing.

        Args:
            max_count: how many are kept at most
            max_age_s: for how long each is kept, seconds
            now: monotonic clock, seconds
        Raises:
            ValueError: a bound that is not positive
        """
        if max_count < 1 or not max_age_s > 0.0:
            raise ValueError(f"bounds must be positive, got {max_count} and {max_age_s} s")
        self._max_age_s = max_age_s
        self._now = now
        self._kept: Deque[Tuple[float, T]] = deque(maxlen=max_count)

    def add(self, value: T) -> None:
        """Keep a value, in the place of the oldest where there are too many."""
        self._forget_old()
        self._kept.append((self._now(), value))

    def values(self) -> List[T]:
        """What is not too old, oldest first."""
        self._forget_old()
        return [value for _, value in self._kept]

    def clear(self) -> None:
        """Keep nothing of what was added."""
        self._kept.clear()

    def _forget_old(self) -> None:
        oldest_s = self._now() - self._max_age_s
        while self._kept and self._kept[0][0] < oldest_s:
            self._kept.popleft()
