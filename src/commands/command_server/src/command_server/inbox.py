"""Events for a worker thread, in the order in which they arrived."""

import queue
import time
from typing import Generic, Iterable, List, Optional, TypeVar

T = TypeVar("T")

_MOST_AT_ONCE = 1000


class Inbox(Generic[T]):
    """A queue from which the worker takes all events at once. Any thread may put."""

    def __init__(self) -> None:
        """Start empty."""
        self._queue: queue.SimpleQueue[T] = queue.SimpleQueue()

    def put(self, event: T) -> None:
        """Add an event; returns at once."""
        self._queue.put(event)

    def take(self, *, longest_wait_s: float, deadlines_s: Iterable[Optional[float]]) -> List[T]:
        """Remove and return all events; waits for the first one.

        Args:
            longest_wait_s: longest wait, seconds
            deadlines_s: when the worker must run without an event, monotonic seconds; None for never
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
