"""What arrives when, for the benchmarks."""

import statistics
import threading
import time
from typing import Any, Callable, Dict, Iterable, Sequence, Tuple


class Arrivals:
    """The moment when each thing arrived first, seconds on the monotonic clock; may be told from any thread."""

    def __init__(self, timeout_s: float) -> None:
        """Nothing has arrived.

        Args:
            timeout_s: how long `after` waits
        """
        self._timeout_s = timeout_s
        self._seen: Dict[str, float] = {}
        self._arrived = threading.Condition()

    def note(self, what: str) -> None:
        """Something has arrived."""
        now_s = time.monotonic()
        with self._arrived:
            self._seen.setdefault(what, now_s)
            self._arrived.notify_all()

    def clear(self) -> None:
        """Forget what has arrived."""
        with self._arrived:
            self._seen = {}

    def after(self, start_s: float, until: Iterable[str]) -> Dict[str, float]:
        """Wait until these things are there; return the milliseconds after which each arrived.

        Raises:
            SystemExit: something does not arrive
        """
        awaited = set(until)
        with self._arrived:
            if not self._arrived.wait_for(lambda: self._seen.keys() >= awaited, self._timeout_s):
                raise SystemExit(f"of {sorted(awaited)} came only {list(self._seen)}")
            return {what: 1000.0 * (seen_s - start_s) for what, seen_s in self._seen.items()}


def wait_for_connections(missing: Callable[[], Sequence[Any]], timeout_s: float) -> None:
    """Return when nothing is missing.

    Raises:
        SystemExit: something is still missing after this time
    """
    end_s = time.monotonic() + timeout_s
    while missing():
        if time.monotonic() > end_s:
            raise SystemExit(f"not connected: {missing()}")
        time.sleep(0.05)


def quantiles(values: Sequence[float]) -> Tuple[float, float]:
    """Median, and the value that 99 of 100 do not exceed."""
    ordered = sorted(values)
    return statistics.median(ordered), ordered[min(len(ordered) - 1, int(0.99 * len(ordered)))]
