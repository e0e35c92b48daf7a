"""One command at a time: messages of 2012 have no id, so an answer belongs to the command that is outside."""

from collections import deque
from typing import Deque, Generic, List, Optional, Tuple, TypeVar

T = TypeVar("T")


class Turns(Generic[T]):
    """Whose turn it is. One thread owns it; times are of the monotonic clock."""

    def __init__(self, *, answer_timeout_s: float, most_waiting: int) -> None:
        """
        Args:
            answer_timeout_s: how long an answer may take
            most_waiting: commands that may wait for their turn
        """
        self._answer_timeout_s = answer_timeout_s
        self._most_waiting = most_waiting
        self._waiting: Deque[T] = deque()
        self._outside: Optional[Tuple[T, float]] = None

    def come(self, command: T) -> bool:
        """Let a command wait for its turn; returns False if too many wait."""
        if len(self._waiting) >= self._most_waiting:
            return False
        self._waiting.append(command)
        return True

    def next(self, now_s: float) -> Optional[T]:
        """Return the command that is to be sent outside now; None if there is none, or another one is outside."""
        if self._outside is not None or not self._waiting:
            return None
        command = self._waiting.popleft()
        self._outside = (command, now_s + self._answer_timeout_s)
        return command

    def answered(self) -> Optional[T]:
        """Take an answer: return the command that it belongs to; None if nothing is outside."""
        if self._outside is None:
            return None
        command, self._outside = self._outside[0], None
        return command

    def silent(self, now_s: float) -> List[T]:
        """Return the command whose answer did not come in time; what comes later belongs to nobody."""
        if self._outside is None or now_s < self._outside[1]:
            return []
        command, self._outside = self._outside[0], None
        return [command]

    def rest_s(self, now_s: float) -> Optional[float]:
        """Return how long the answer that is awaited may still take; None if none is awaited."""
        return None if self._outside is None else max(0.0, self._outside[1] - now_s)
