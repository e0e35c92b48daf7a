"""Looks that wait for the transform of their time."""

from collections import deque
from typing import Deque, Generic, Optional, Tuple, TypeVar

Look = TypeVar("Look")


class Pending(Generic[Look]):
    """A queue of looks, each with a deadline on the monotonic clock. Not thread-safe."""

    def __init__(self, *, most: int, wait_s: float) -> None:
        """
        Args:
            most: looks that wait; a further one drops the oldest
            wait_s: how long a look waits
        """
        self._most = most
        self._wait_s = wait_s
        self._looks: Deque[Tuple[float, Look]] = deque()
        self.dropped = 0

    def put(self, look: Look, now_s: float) -> None:
        """Add a look; ``now_s`` is of the monotonic clock."""
        while len(self._looks) >= self._most:
            self._looks.popleft()
            self.dropped += 1
        self._looks.append((now_s + self._wait_s, look))

    def first(self) -> Optional[Look]:
        """Return the oldest look; None if there is none."""
        return self._looks[0][1] if self._looks else None

    def done(self) -> None:
        """Remove the oldest look."""
        self._looks.popleft()

    def is_late(self, now_s: float) -> bool:
        """Whether the oldest look has waited too long."""
        return bool(self._looks) and now_s > self._looks[0][0]
