"""Keeps a thread ready for work that must begin at once."""

import queue
import threading
from typing import Callable, Optional

Work = Callable[[], None]


class ReadyThread:
    """Runs each work in a thread of its own, of which one waits for the next work.

    To start a thread takes longer than to wake one: the new thread and the old one wait for each other.
    """

    def __init__(self, name: str) -> None:
        """Start the first thread.

        Args:
            name: of the threads
        """
        self._name = name
        self._lock = threading.Lock()
        self._waiting: Optional[queue.SimpleQueue[Work]] = self._start()

    def run(self, work: Work) -> None:
        """Begin a work, whatever else still runs; returns at once. The work must handle its exceptions."""
        with self._lock:
            thread, self._waiting = self._waiting, None
        (thread or self._start()).put(work)

    def _start(self) -> "queue.SimpleQueue[Work]":
        works: queue.SimpleQueue[Work] = queue.SimpleQueue()
        # A daemon: a work that never returns must not keep the process alive.
        threading.Thread(target=self._work, args=(works,), name=self._name, daemon=True).start()
        return works

    def _work(self, works: "queue.SimpleQueue[Work]") -> None:
        while True:
            works.get()()
            with self._lock:
                if self._waiting is not None:
                    return
                self._waiting = works
