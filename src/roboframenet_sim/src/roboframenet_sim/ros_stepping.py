"""The time of a simulated robot: regular steps that follow the wall clock or a /clock of its own."""

import math
import threading
import time
import traceback
from dataclasses import dataclass
from typing import Callable, Iterator, Optional

import rospy
from rosgraph_msgs.msg import Clock


@dataclass(frozen=True)
class SteppingSettings:
    """Rate and clock of the simulation.

    Raises:
        ValueError: a number is out of range, or there is a rate factor but no clock
    """

    rate_hz: float = 50.0
    rate_factor: float = 1.0
    is_sim_time: bool = False
    is_clock: bool = False
    """This node publishes /clock: only under /use_sim_time, and in one node of the graph."""

    def __post_init__(self) -> None:
        for name, low, high in (("rate_hz", 1.0, 1000.0), ("rate_factor", 0.01, 100.0)):
            value = getattr(self, name)
            if not (isinstance(value, (int, float)) and math.isfinite(value) and low <= value <= high):
                raise ValueError(f"~{name} must be {low:g} to {high:g}, got {value!r}")
        if self.rate_factor != 1.0 and not self.is_clock:
            raise ValueError(
                f"~rate_factor other than 1 needs /use_sim_time and ~publish_clock, got {self.rate_factor!r}"
            )


def read_stepping_settings(*, rate_hz: float) -> SteppingSettings:
    """Read ~rate_hz, ~rate_factor and ~publish_clock.

    Args:
        rate_hz: the default of ~rate_hz
    """
    is_sim_time = bool(rospy.get_param("/use_sim_time", False))
    return SteppingSettings(
        rate_hz=rospy.get_param("~rate_hz", rate_hz),
        rate_factor=rospy.get_param("~rate_factor", SteppingSettings.rate_factor),
        is_sim_time=is_sim_time,
        is_clock=is_sim_time and bool(rospy.get_param("~publish_clock", True)),
    )


class Stepper:
    """Calls a function once per period until the node is shut down.

    The node that publishes /clock makes every step exactly one period long, however busy the machine is. The simulation
    then runs slower, with the same result. With the wall clock, or the /clock of another node, a step is as long as the
    time that has passed.

    Args:
        settings: rate and clock
        step: called with the duration of the step in seconds, and the time to stamp messages with
    """

    MAX_LAG_S = 0.1

    def __init__(self, settings: SteppingSettings, *, step: Callable[[float, rospy.Time], None]) -> None:
        self._settings = settings
        self._step = step
        self._clock = rospy.Publisher("/clock", Clock, queue_size=10) if settings.is_clock else None

    def run(self) -> None:
        """Step until shutdown."""
        if self._clock is not None:
            run_until_shutdown(self._run_as_clock)
        elif self._settings.is_sim_time:
            run_until_shutdown(self._run_along_clock)
        else:
            run_until_shutdown(self._run_along_wall)

    def _run_as_clock(self) -> None:
        period_s = 1.0 / self._settings.rate_hz
        for steps, _ in enumerate(self._periods(period_s / self._settings.rate_factor), start=1):
            stamp = rospy.Time.from_sec(steps * period_s)
            publish(self._clock, Clock(clock=stamp))
            self._step(period_s, stamp)

    def _run_along_wall(self) -> None:
        last_s = time.monotonic()
        for now_s in self._periods(1.0 / self._settings.rate_hz):
            self._step(now_s - last_s, rospy.Time.now())
            last_s = now_s

    def _run_along_clock(self) -> None:
        rate = rospy.Rate(self._settings.rate_hz)
        last_s = rospy.get_time()
        while not rospy.is_shutdown():
            try:
                rate.sleep()
            except rospy.ROSTimeMovedBackwardsException:
                # The clock was restarted: this step takes no time.
                last_s = rospy.get_time()
            except rospy.ROSInterruptException:
                return
            stamp = rospy.Time.now()
            self._step(max(0.0, stamp.to_sec() - last_s), stamp)
            last_s = stamp.to_sec()

    def _periods(self, period_s: float) -> Iterator[float]:
        """Yield the monotonic time once per period, until shutdown. A lag of several periods is not caught up."""
        due_s = time.monotonic()
        while not rospy.is_shutdown():
            now_s = time.monotonic()
            yield now_s
            due_s = max(due_s + period_s, now_s - self.MAX_LAG_S)
            time.sleep(max(0.0, due_s - time.monotonic()))


def run_until_shutdown(loop: Callable[[], None]) -> None:
    """Run a loop in its own thread until the node is shut down.

    Signal handlers run in the main thread, and rospy closes the topics there. This must not happen during a publish.

    Args:
        loop: returns soon after shutdown; if it raises, the node is shut down
    """

    def run() -> None:
        try:
            loop()
        except Exception as error:  # boundary: if the thread died silently, the robot would stop working without a sign
            if not rospy.is_shutdown():
                rospy.logfatal("%s", traceback.format_exc())
                rospy.signal_shutdown(f"{type(error).__name__}: {error}")

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    rospy.spin()
    thread.join(2.0)


def publish(publisher: Optional[rospy.Publisher], message: object) -> None:
    """Publish; a topic that closes because the node shuts down is not an error."""
    try:
        if publisher is not None:
            publisher.publish(message)
    except rospy.ROSException:
        if not rospy.is_shutdown():
            raise
