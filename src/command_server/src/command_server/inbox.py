"""What a worker thread is to handle, in the order in which it came."""

import queue
import time
from typing import Generic, Iterable, List, Optional, TypeVar

T = TypeVar("T")

_MOST_AT_ONCE = 1000


class Inbox(Generic[T]):
    """A queue of which the worker takes many at a time. Any thread may put."""

    def __init__(self) -> None:
        """Start empty."""
        self._queue: queue.Queue[T] = queue.Queue()

    def put(self, event: T) -> None:
        """Add something; returns at once."""
        self._queue.put(event)

    def take(self, *, longest_wait_s: float, deadlines_s: Iterable[Optional[float]]) -> List[T]:
        """Take out what has come; waits for the first.

        Args:
            longest_wait_s: how long at most, seconds
            deadlines_s: when the worker has something to do in any case, monotonic seconds; None for never
        """
        wait_s = longest_wait_s
        for deadline_s in deadlines_s:
            if deadline_s is not None:
                wait_s = min(wait_s, max(0.001, deadline_s - time.monotonic()))
        try:
            events = [self._queue.get(timeout=wait_s)]
        except queue.Empty:
            return []
        while len(events) < _MOST_AT_ONCE:
            try:
                events.append(self._queue.get_nowait())
            except queue.Empty:
                break
        return events
