"""Whether whoever gives commands is still there."""

import time
from typing import Callable, Optional

#: A connection that breaks may come back; what is gone for longer has died, seconds.
_PATIENCE_S = 0.2


class CommanderWatch:
    """Notices that the commander is gone: a robot whose commander dies stops by itself."""

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        """Start with nobody there.

        Args:
            now: monotonic clock, seconds
        """
        self._now = now
        self._was_there = False
        self._gone_s: Optional[float] = None

    def is_lost(self, is_there: bool) -> bool:
        """Whether the commander was there and is gone; true once for each time.

        Args:
            is_there: whether it is connected now
        """
        if is_there or not self._was_there:
            self._was_there, self._gone_s = is_there, None
            return False
        if self._gone_s is None:
            self._gone_s = self._now()
        if self._now() - self._gone_s < _PATIENCE_S:
            return False
        self._was_there, self._gone_s = False, None
        return True
