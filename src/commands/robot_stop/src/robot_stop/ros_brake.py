"""Carries stops out: zero velocity and cancels at once, then finds the nodes that do not obey."""

import queue
import threading
import time
from dataclasses import dataclass
from typing import Callable, Tuple, Union

import rospy
from actionlib_msgs.msg import GoalID

from roboframenet_ros.suspension import SuspensionWatch
from robot_stop.braking import (
    BrakeLimits,
    Braking,
    Evidence,
    Finding,
    Obedience,
    StopOrder,
    obedience_of_held,
    was_set_back,
)
from robot_stop.ros_servers import Servers
from robot_stop.ros_velocity import Velocities
from robot_stop.settings import BrakeSettings

_IDLE_WAIT_S = 0.5
# While the robot is held, all goals are cancelled in this period; goals that are known to go on, in each turn.
_HELD_CANCEL_PERIOD_S = 1.0
# A turn of the thread takes a millisecond; a wait as long as this means that the process did not run.
_LONGEST_TURN_S = _IDLE_WAIT_S + 1.0
_JUST_AWAKE_S = 0.5


@dataclass(frozen=True)
class Braked:
    """A stop that was carried out for the first time.

    Attributes:
        order: the stop
        cancelled: names of the servers that the cancel was sent to
        took_s: how long it took, seconds
        is_just_awake: whether this process was suspended shortly before, so that the stop may be an old one
    """

    order: StopOrder
    cancelled: Tuple[str, ...]
    took_s: float
    is_just_awake: bool


@dataclass(frozen=True)
class _Release:
    key: str


@dataclass(frozen=True)
class _Hold:
    is_held: bool


class Brake:
    """One thread that stops the robot.

    Publishes: zero velocity, ``<server>/cancel``. Subscribes: the velocity topics, ``<server>/status``. A separate
    thread asks the master in advance, so that a stop never waits for it. A stop is carried out before it is logged.
    """

    def __init__(
        self, settings: BrakeSettings, *, on_braked: Callable[[Braked], None], on_finding: Callable[[Finding], None]
    ) -> None:
        """Connect.

        Args:
            settings: parameters
            on_braked: called from the thread after each stop; must not block
            on_finding: called from the thread with the nodes and servers that do not obey; must not block
        """
        self._period_s = 1.0 / settings.zero_velocity_rate_hz
        self._on_braked = on_braked
        self._on_finding = on_finding
        self._braking = Braking(
            BrakeLimits(
                confirmation_s=settings.confirmation_timeout_s,
                least_s=settings.zero_velocity_duration_s,
                most_s=max(settings.zero_velocity_limit_s, settings.zero_velocity_duration_s),
            )
        )
        self._suspension = SuspensionWatch(longest_turn_s=_LONGEST_TURN_S)
        self._velocities = Velocities(settings.velocity_topics)
        self.servers = Servers(
            also_cancel=tuple(rospy.resolve_name(name).rstrip("/") for name in settings.also_cancel),
            refresh_period_s=settings.refresh_period_s,
            master_timeout_s=settings.master_timeout_s,
        )
        self._inbox: queue.Queue[Union[StopOrder, _Release, _Hold, None]] = queue.Queue()
        self._thread = threading.Thread(target=self._work, name="brake")
        # Replaced as a whole by the thread, read by any.
        self._held_obedience = Obedience(is_known=False)
        # Owned by the thread.
        self._is_held = False
        self._held_cancel_s = 0.0

    def start(self) -> None:
        """Start the threads."""
        self._thread.start()
        self._velocities.start()
        self.servers.start()

    def close(self, *, timeout_s: float) -> None:
        """End the threads."""
        self._inbox.put(None)
        self._thread.join(timeout_s)
        self.servers.close(timeout_s=timeout_s)

    def stop(self, order: StopOrder) -> None:
        """Ask for a stop; returns at once."""
        self._inbox.put(order)

    def release(self, key: str) -> None:
        """Drop a stop that another node carries out; returns at once."""
        self._inbox.put(_Release(key))

    def hold(self, is_held: bool) -> None:
        """Hold the robot from now on, or no more; returns at once.

        While it is held, zero velocity is repeated, each velocity of another node is answered with zero, and all goals
        are cancelled, whenever they were sent.
        """
        self._inbox.put(_Hold(is_held))

    @property
    def held_obedience(self) -> Obedience:
        """Who would move the robot if it were held no more; any thread may ask."""
        return self._held_obedience

    @property
    def _is_busy(self) -> bool:
        return self._is_held or self._braking.is_busy

    def _work(self) -> None:
        next_look_s = 0.0
        while True:
            wait_s = max(0.0, next_look_s - time.monotonic()) if self._is_busy else _IDLE_WAIT_S
            try:
                heard = self._inbox.get(timeout=wait_s)
            except queue.Empty:
                heard = None
            else:
                if heard is None:
                    return
            self._suspension.turn()
            try:
                if isinstance(heard, StopOrder):
                    if not self._is_busy:
                        next_look_s = time.monotonic() + self._period_s
                    self._begin(heard)
                elif isinstance(heard, _Hold):
                    if heard.is_held is not self._is_held:
                        self._is_held, self._held_cancel_s = heard.is_held, 0.0
                        self._held_obedience = Obedience(is_known=False)
                elif isinstance(heard, _Release):
                    self._braking.release(heard.key)
                if self._is_busy and time.monotonic() >= next_look_s:
                    next_look_s = time.monotonic() + self._period_s
                    self._look()
                elif not self._is_busy:
                    self._velocities.hold(False)
            except Exception as error:  # boundary: an error in one stop must not prevent the next one
                rospy.logerr("the brake failed: %s: %s", type(error).__name__, error)

    def _begin(self, order: StopOrder) -> None:
        began_s = time.monotonic()
        self._velocities.hold(True)
        self._velocities.stop()
        # The empty id cancels every goal, even one whose stamp comes from a clock that is ahead.
        is_for_all = not order.is_for_frames_only and not order.except_server
        cancelled = self.servers.cancel(GoalID() if is_for_all else self._up_to(order), order)
        took_s = time.monotonic() - began_s
        is_just_awake = self._suspension.is_just_awake(within_s=_JUST_AWAKE_S)
        self._braking.begin(order, self._evidence(), is_just_awake=is_just_awake)
        self.servers.refresh_soon()
        self._on_braked(Braked(order=order, cancelled=tuple(cancelled), took_s=took_s, is_just_awake=is_just_awake))

    def _look(self) -> None:
        now_ns = rospy.Time.now().to_nsec()
        evidence = self._evidence()
        look = self._braking.look(evidence, now_ns=now_ns)
        self._velocities.hold(self._is_held or look.repeated is not None)
        if self._is_held:
            self._held_obedience = obedience_of_held(evidence, now_s=time.monotonic())
            self._repeat_held()
        elif look.repeated is not None:
            self._repeat(look.repeated, now_ns)
        for finding in look.findings:
            self._on_finding(finding)

    def _repeat(self, order: StopOrder, now_ns: int) -> None:
        """Repeat the stop for goals and velocities that were on their way when it was heard."""
        self._velocities.stop()
        # A cancel without a stamp would also cancel a command that was given after the stop.
        # So would the stamp of a clock that was set back.
        if order.stamp_ns and not was_set_back(order, now_ns):
            self.servers.cancel(self._up_to(order), order)

    def _repeat_held(self) -> None:
        self._velocities.stop()
        # The empty id cancels every goal, whatever clock its stamp comes from.
        self.servers.cancel_live(GoalID())
        if time.monotonic() >= self._held_cancel_s:
            self._held_cancel_s = time.monotonic() + _HELD_CANCEL_PERIOD_S
            # With a stamp, it also ends goals that are still on their way.
            self.servers.cancel(GoalID(stamp=rospy.Time.now()), StopOrder(key="held", stamp_ns=0))

    def _evidence(self) -> Evidence:
        return Evidence(
            velocities=self._velocities.seen(), goals=self.servers.goals(), is_complete=self.servers.is_complete
        )

    @staticmethod
    def _up_to(order: StopOrder) -> GoalID:
        return GoalID(stamp=rospy.Time(*divmod(order.stamp_ns, 1_000_000_000)))
