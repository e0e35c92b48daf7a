"""Publishes the status of an action server: soon after a change, and again and again while it has goals."""

import threading
import time
from typing import Callable, Optional


class StatusThread:
    """Calls a function when a status is due, by the machine's time: a server is alive while a simulation is paused.

    One thread does it from the first `ask` until `close`: to start a thread for a goal takes longer than to take the
    goal. Whoever changes a status only wakes it, and nobody waits for it.
    """

    def __init__(self, publish: Callable[[], bool], *, pause_s: float, period_s: Optional[float]) -> None:
        """Prepare; nothing is due.

        Args:
            publish: called in the thread; returns whether the status must be repeated
            pause_s: least time between two calls; changes within it are told by one
            period_s: between a call and its repetition; None for none
        """
        self._publish = publish
        self._pause_s = pause_s
        self._period_s = period_s
        self._changed = threading.Condition()
        self._due_s = float("inf")
        self._is_asked = False
        self._published_s = float("-inf")
        self._is_closed = False
        self._thread: Optional[threading.Thread] = None

    def ask(self) -> None:
        """Let the status be published soon; returns at once."""
        with self._changed:
            if self._is_asked or self._is_closed:
                return
            self._is_asked = True
            self._due_s = self._published_s + self._pause_s
            if self._thread is None:
                # A daemon: it holds nothing that must be closed.
                self._thread = threading.Thread(target=self._run, name="goal_status", daemon=True)
                self._thread.start()
            self._changed.notify()

    def close(self) -> None:
        """End the thread; returns at once."""
        with self._changed:
            self._is_closed = True
            self._changed.notify()

    def _run(self) -> None:
        while True:
            with self._changed:
                while not self._is_closed and time.monotonic() < self._due_s:
                    # Without a limit while nothing is due.
                    left_s = self._due_s - time.monotonic()
                    self._changed.wait(None if left_s == float("inf") else max(0.0, left_s))
                if self._is_closed:
                    return
                self._is_asked = False
                self._published_s = time.monotonic()
                self._due_s = float("inf")
            must_repeat = self._publish()
            with self._changed:
                if must_repeat and self._period_s is not None and not self._is_asked:
                    self._due_s = self._published_s + self._period_s
