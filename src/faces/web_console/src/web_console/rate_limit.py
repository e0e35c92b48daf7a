"""A limit on how often something may be done."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Rate:
    """At most `burst` at once, and `per_s` each second on average."""

    per_s: float
    burst: float


class RateLimit:
    """A bucket of tokens: each act takes one, and they come back with time."""

    def __init__(self, rate: Rate, now_s: float) -> None:
        """Start full.

        Args:
            rate: the limit
            now_s: time on a monotonic clock, seconds
        """
        self._rate = rate
        self._tokens = rate.burst
        self._last_s = now_s

    def take(self, now_s: float) -> bool:
        """Whether one more is allowed now."""
        self._tokens = min(self._rate.burst, self._tokens + self._rate.per_s * max(0.0, now_s - self._last_s))
        self._last_s = now_s
        if self._tokens < 1.0:
            return False
        self._tokens -= 1.0
        return True
