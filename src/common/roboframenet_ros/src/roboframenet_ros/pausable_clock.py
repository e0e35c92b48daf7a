"""A monotonic clock that stands while a simulation is paused, or while the process does not run."""

import time
from typing import Callable

#: Between two changes of the simulated time, or two looks at the machine's, at most this much passes; a longer time is
#: a pause, seconds.
LONGEST_TICK_S = 0.5
#: A simulated time that stands for longer belongs to a simulator that has died, seconds.
LONGEST_PAUSE_S = 300.0


class PausableClock:
    """Seconds of the monotonic clock without the time in which the ROS time stood still. One thread owns it.

    With the time of the machine, it stands while nobody looks at it: a process that did not run has heard nothing.
    """

    def __init__(
        self, *, ros_time_ns: Callable[[], int], is_simulated: bool, now: Callable[[], float] = time.monotonic
    ) -> None:
        """Start now.

        Args:
            ros_time_ns: ROS time, nanoseconds
            is_simulated: whether the ROS time comes from a simulator, which may pause
            now: monotonic clock, seconds
        """
        self._ros_time_ns = ros_time_ns
        self._is_simulated = is_simulated
        self._now = now
        self._seen_ns = ros_time_ns()
        self._changed_s = now()
        self._paused_s = 0.0

    def now_s(self) -> float:
        """Return the time; call it several times in LONGEST_TICK_S."""
        now_s = self._now()
        stood_s = now_s - self._changed_s
        seen_ns = self._ros_time_ns()
        pause_s = min(max(0.0, stood_s - LONGEST_TICK_S), LONGEST_PAUSE_S)
        if seen_ns != self._seen_ns or not self._is_simulated:
            self._seen_ns, self._changed_s = seen_ns, now_s
            self._paused_s += pause_s
            pause_s = 0.0
        return now_s - self._paused_s - pause_s
