"""The time of a simulated robot: regular steps that follow the wall clock or a /clock of its own."""

import atexit
import threading
import time
import traceback
from dataclasses import dataclass
from typing import Callable, Iterator

import rospy
from rosgraph_msgs.msg import Clock

from roboframenet_ros.parameters import ParameterError, Parameters, parameter
from roboframenet_ros.ros_master import NO_ANSWER, TimedMaster
from roboframenet_ros.ros_publishing import is_shutting_down, publish

#: How long the master may take to answer, seconds.
_MASTER_S = 2.0


@dataclass(frozen=True)
class SteppingSettings(Parameters):
    """Private parameters of the time, checked.

    Attributes:
        rate_hz: steps and odometry
        rate_factor: how much faster than the wall clock
        publish_clock: publish ``/clock`` under ``/use_sim_time``; only one node of the graph may do so

    Raises:
        ParameterError: a value out of its range
    """

    rate_hz: float = parameter(50.0, least=1.0, most=1000.0)
    rate_factor: float = parameter(1.0, least=0.01, most=100.0)
    publish_clock: bool = parameter(True)


class Stepper:
    """Calls a function once per period until the node is shut down.

    The node that publishes /clock makes every step exactly one period long, however busy the machine is. The simulation
    then runs slower, with the same result. With the wall clock, or the /clock of another node, a step is as long as the
    time that has passed.

    Args:
        settings: rate and clock
        step: called with the duration of the step in seconds, and the time to stamp messages with

    Raises:
        ParameterError: there is a rate factor but no clock
    """

    MAX_LAG_S = 0.1

    def __init__(self, settings: SteppingSettings, *, step: Callable[[float, rospy.Time], None]) -> None:
        self._settings = settings
        self._step = step
        self._is_sim_time = bool(rospy.get_param("/use_sim_time", False))
        is_clock = self._is_sim_time and settings.publish_clock
        if settings.rate_factor != 1.0 and not is_clock:
            raise ParameterError(
                f"~rate_factor other than 1 needs /use_sim_time and ~publish_clock, got {settings.rate_factor!r}"
            )
        self._clock = rospy.Publisher("/clock", Clock, queue_size=10) if is_clock else None
        if is_clock:
            _warn_of_other_clocks()

    def start(self) -> None:
        """Step from now until shutdown."""
        if self._clock is not None:
            start_loop(self._run_as_clock)
        elif self._is_sim_time:
            start_loop(self._run_along_clock)
        else:
            start_loop(self._run_along_wall)

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


def _warn_of_other_clocks() -> None:
    """Tell in the log when another node publishes /clock, too."""
    try:
        nodes = TimedMaster(timeout_s=_MASTER_S).system_state().publishers.get("/clock", frozenset())
    except NO_ANSWER:
        return
    others = sorted(nodes - {rospy.get_name()})
    if others:
        rospy.logerr(
            "%s publishes /clock, too: time jumps between the two. Set ~publish_clock to false.", ", ".join(others)
        )


def start_loop(loop: Callable[[], None]) -> None:
    """Run a loop in its own thread until the node is shut down.

    Signal handlers run in the main thread, and rospy closes the topics there. This must not happen during a publish.

    Args:
        loop: returns soon after shutdown; if it raises, the node is shut down
    """

    def run() -> None:
        try:
            loop()
        except Exception as error:  # boundary: if the thread died silently, the robot would stop working without a sign
            if not is_shutting_down():
                rospy.logfatal("%s", traceback.format_exc())
                rospy.signal_shutdown(f"{type(error).__name__}: {error}")

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    # Not on_shutdown(): while its hooks run, rospy does not tell loops yet that the node shuts down.
    atexit.register(thread.join, 2.0)
