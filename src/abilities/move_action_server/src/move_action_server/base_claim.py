"""Decides which of several servers may drive the one base.

The newest claim wins. It revokes the claim before it, and is granted when that claim is released. The holder of a
revoked claim stops the base before it releases the claim.
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
        """Whether a newer claim wants the base. If so, the holder must stop the base and release this claim."""
        return self._claims.newest_ticket != self._ticket

    def release(self) -> None:
        """Give the base back. Stop the base first."""
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
        """Number of the newest claim."""
        with self._condition:
            return self._newest

    def claim(self, *, timeout_s: float, is_cancelled: Callable[[], bool] = lambda: False) -> Optional[BaseClaim]:
        """Revoke the current claim, and wait until it is released.

        Args:
            timeout_s: how long to wait
            is_cancelled: called several times a second, without a lock
        Returns:
            None if the base was not released in time, if a newer claim came, or if the claim was cancelled
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
        """Release the claim with this ticket."""
        with self._condition:
            if self._holder == ticket:
                self._holder = 0
                self._condition.notify_all()
