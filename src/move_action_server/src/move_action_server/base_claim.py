"""One base, several servers: who may drive it.

The newest wins: a claim revokes the one before it, and is granted when that one has been released, which its holder
does after it has stopped the base.
"""

import threading
import time
from typing import Callable, Optional


class BaseClaim:
    """The right to drive, until it is released. Made by :meth:`BaseClaims.claim`."""

    def __init__(self, claims: "BaseClaims", ticket: int) -> None:
        self._claims = claims
        self._ticket = ticket

    @property
    def is_revoked(self) -> bool:
        """Whether somebody newer wants the base: stop it, and release the claim."""
        return self._claims.newest_ticket != self._ticket

    def release(self) -> None:
        """Give the base back. Only after it has been told to stop."""
        self._claims.release(self._ticket)


class BaseClaims:
    """Grants the base to one claim at a time.

    Args:
        now: monotonic clock in seconds
    """

    POLL_S = 0.05

    def __init__(self, *, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._condition = threading.Condition()
        self._newest = 0
        self._holder = 0

    @property
    def newest_ticket(self) -> int:
        """Number of the claim that was made last."""
        with self._condition:
            return self._newest

    def claim(self, *, timeout_s: float, is_cancelled: Callable[[], bool] = lambda: False) -> Optional[BaseClaim]:
        """Revoke the claim that holds, and wait until it is released.

        Args:
            timeout_s: how long to wait
            is_cancelled: asked several times a second, without a lock held
        Returns:
            None if the base was not released in time, if a still newer claim came, or if cancelled
        """
        end_s = self._now() + timeout_s
        with self._condition:
            self._newest += 1
            ticket = self._newest
        while not is_cancelled():
            with self._condition:
                if self._newest != ticket:
                    return None
                if not self._holder:
                    self._holder = ticket
                    return BaseClaim(self, ticket)
                remaining_s = end_s - self._now()
                if remaining_s <= 0.0:
                    return None
                self._condition.wait(min(self.POLL_S, remaining_s))
        return None

    def release(self, ticket: int) -> None:
        """Take the base back from the holder of a ticket."""
        with self._condition:
            if self._holder == ticket:
                self._holder = 0
                self._condition.notify_all()
