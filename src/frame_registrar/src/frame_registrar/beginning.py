"""The first seconds of a registrar, in which the servers of the robot register one after the other."""

import threading
import time
from typing import Callable, TypeVar, Union

from frame_registrar.search import Refusal

#: The beginning is over after so many times the time in which one server may register.
_LONGEST = 3.0

What = TypeVar("What")


class Beginning:
    """Repeats a search that finds no server while servers may still register; safe for several threads.

    A registrar that has just started, also after a crash, knows no server; all of them hear of it and register. "No
    server is registered" would be no true answer before they have. On a busy machine they need longer: each one that
    registers makes the beginning last until the next one may have.
    """

    def __init__(self, settle_s: float) -> None:
        """
        Args:
            settle_s: how long the first server may take to register, and each further one behind the last, seconds
        """
        self._settle_s = settle_s
        self._end_s = time.monotonic() + settle_s
        self._latest_end_s = time.monotonic() + _LONGEST * settle_s
        self._changed = threading.Condition()
        self._registrations = 0

    def hear_registration(self) -> None:
        """A server has registered."""
        with self._changed:
            self._registrations += 1
            now_s = time.monotonic()
            if now_s < self._end_s:
                self._end_s = min(now_s + self._settle_s, self._latest_end_s)
            self._changed.notify_all()

    def search(self, find: Callable[[], Union[What, Refusal]]) -> Union[What, Refusal]:
        """Return what a search finds, at the latest when the beginning is over.

        Args:
            find: the search; called again when a server has registered
        """
        while True:
            with self._changed:
                before = self._registrations
            outcome = find()
            if not isinstance(outcome, Refusal) or outcome.code != "NO_SERVER" or not self._wait_for_more(before):
                return outcome

    def _wait_for_more(self, before: int) -> bool:
        """Wait until there are more registrations than before; return False when the beginning is over."""
        with self._changed:
            while self._registrations <= before:
                rest_s = self._end_s - time.monotonic()
                if rest_s <= 0.0 or not self._changed.wait(rest_s):
                    return self._registrations > before
            return True
