"""Scopes, which end as a whole, and the clock by which everything in a running plan waits."""

import enum
import math
import threading
import time
from typing import Callable, Dict, Iterable, Optional

#: Someone else may have to end: a wait looks at its scope this often even if nobody wakes it.
_LONGEST_SLEEP_S = 1.0


class Cause(enum.Enum):
    """Why a scope was cancelled."""

    PREEMPTED = "preempted"  # from outside of the plan
    ENOUGH = "enough"  # the part of the plan around it has been decided
    LATE = "late"  # its limit is over


class Clock:
    """Monotonic time, and how threads wait. A subclass may let time run otherwise.

    `lock` guards the scopes, and may be taken again by the thread that holds it.
    """

    def __init__(self) -> None:
        self.lock = threading.Condition(threading.RLock())

    def now_s(self) -> float:
        """Return the time, seconds."""
        return time.monotonic()

    def wait(self, rank: int, is_over: Callable[[], bool], until_s: float) -> None:
        """Wait until `is_over()` after a wake-up, or until a time, or for less.

        Args:
            rank: number of the part of the plan that waits; no two wait at a time with the same one
            is_over: asked with the lock held
            until_s: infinite for no time
        """
        with self.lock:
            if not is_over():
                self.lock.wait(max(0.0, min(until_s - self.now_s(), _LONGEST_SLEEP_S)))

    def wake(self) -> None:
        """Let all that wait look again."""
        with self.lock:
            self.lock.notify_all()

    def fork(self, ranks: Iterable[int]) -> None:
        """The calling thread starts one thread for each of some parts, and waits for their end."""

    def begin(self, rank: int) -> None:
        """The calling thread begins the part that it was started for."""

    def end(self, *, is_last: bool) -> None:
        """The calling thread ends; with the last one the thread that started them goes on."""


class Scope:
    """A part of a plan while it runs. To cancel it cancels all scopes below it.

    Any thread may call. Whoever runs in a scope waits by `wait`, or calls `tick` and looks at `is_cancelled`.
    """

    def __init__(self, clock: Clock, parent: Optional["Scope"] = None, *, limit_s: float = 0.0) -> None:
        """
        Args:
            clock: of the plan
            parent: the scope around it
            limit_s: it is cancelled as LATE after this time; 0 for no limit
        """
        self.clock = clock
        self._parent = parent
        self._limit_s = limit_s
        self._end_s = math.inf
        self.cause: Optional[Cause] = None
        self._listeners: Dict[Callable[[], None], None] = {}

    def begin(self) -> bool:
        """Begin, maybe anew; returns whether it may: False when a scope around it is cancelled."""
        with self.clock.lock:
            if self._parent is not None:
                self._parent.tick()
                if self._parent.is_cancelled:
                    return False
                self.cause = None
            # A root that was cancelled before it began stays so.
            self._end_s = self.clock.now_s() + self._limit_s if self._limit_s else math.inf
            return self.cause is None

    def cancel(self, cause: Cause) -> None:
        """End everything in it; only the first cause counts."""
        with self.clock.lock:
            if self.cause is not None:
                return
            self.cause = cause
            listeners = list(self._listeners)
        for listener in listeners:
            listener()
        self.clock.wake()

    @property
    def is_cancelled(self) -> bool:
        """Whether it, or a scope around it, is cancelled."""
        return self.cause is not None or (self._parent is not None and self._parent.is_cancelled)

    @property
    def is_cancelled_from_outside(self) -> bool:
        """Whether a scope around it is cancelled."""
        return self._parent is not None and self._parent.is_cancelled

    @property
    def end_s(self) -> float:
        """When the first limit of it and of the scopes around it is over."""
        return self._end_s if self._parent is None else min(self._end_s, self._parent.end_s)

    def tick(self) -> None:
        """Cancel the scopes around it, and then itself, whose limit is over."""
        if self._parent is not None:
            self._parent.tick()
        if not self.is_cancelled and self.clock.now_s() >= self._end_s:
            self.cancel(Cause.LATE)

    def wait(self, rank: int, is_over: Callable[[], bool], until_s: float = math.inf) -> None:
        """Wait until the scope is cancelled, `is_over()`, or a time; see `Clock.wait`."""
        while True:
            self.tick()
            with self.clock.lock:
                if self.is_cancelled or is_over() or self.clock.now_s() >= until_s:
                    return
            self.clock.wait(rank, lambda: self.is_cancelled or is_over(), min(until_s, self.end_s))

    def listen(self, on_cancel: Callable[[], None]) -> None:
        """Call a function, from any thread, when this scope or one around it is cancelled."""
        with self.clock.lock:
            scope: Optional[Scope] = self
            while scope is not None:
                scope._listeners[on_cancel] = None
                scope = scope._parent

    def unlisten(self, on_cancel: Callable[[], None]) -> None:
        """End `listen`."""
        with self.clock.lock:
            scope: Optional[Scope] = self
            while scope is not None:
                scope._listeners.pop(on_cancel, None)
                scope = scope._parent
