"""Follows a person: takes the position of the person, returns velocities."""

import enum
from dataclasses import dataclass
from typing import Optional

from turtlebot_follower.centroid import Centroid


@dataclass(frozen=True)
class FollowingSettings:
    """Parameters of following. goal_z, z_scale and x_scale are those of the Turtlebot's follower.

    Raises:
        ValueError: a number is out of range
    """

    goal_z_m: float = 0.6
    z_scale_per_s: float = 1.0
    x_scale_rad_per_m_s: float = 5.0
    speed_share: float = 1.0
    """Share of the person's own speed that is added; 0 is the law of 2012, which is fast only when the gap is wide."""
    max_linear_m_per_s: float = 0.65
    max_angular_rad_per_s: float = 1.5
    lost_timeout_s: float = 3.0

    def __post_init__(self) -> None:
        for name, low, high in (
            ("goal_z_m", 0.1, 5.0),
            ("z_scale_per_s", 0.0, 10.0),
            ("x_scale_rad_per_m_s", 0.0, 20.0),
            ("speed_share", 0.0, 1.0),
            ("max_linear_m_per_s", 0.01, 2.0),
            ("max_angular_rad_per_s", 0.01, 5.0),
            ("lost_timeout_s", 0.2, 60.0),
        ):
            value = getattr(self, name)
            if not (isinstance(value, (int, float)) and low <= value <= high):
                raise ValueError(f"{name} must be {low:g} to {high:g}, got {value!r}")


class Sight(enum.Enum):
    """Whether the person is there. LOST is final."""

    SEEN = "seen"
    UNSEEN = "unseen"
    LOST = "lost"


@dataclass(frozen=True)
class FollowingStep:
    """The velocity to publish: forward and left are positive (REP 103)."""

    linear_m_per_s: float
    angular_rad_per_s: float
    sight: Sight


class Follower:
    """Follows a person from the start of a goal to its end.

    The law of the Turtlebot's follower turns by ``-x x_scale`` and drives by ``(z - goal_z) z_scale``. With this law
    alone the person gets ahead by speed / z_scale: at half a metre per second that is beyond the box. So the speed of
    the person, which is the change of z plus the speed of the robot, is added.

    Args:
        settings: parameters of following
        now_s: monotonic time now; the person need not be present yet
    """

    FILTER_S = 0.25
    DEAD_M = 0.02
    DEAD_RAD_PER_S = 0.02

    def __init__(self, settings: FollowingSettings, *, now_s: float) -> None:
        self.settings = settings
        self._seen_s = now_s
        self._last: Optional[Centroid] = None
        self._last_stamp_s = 0.0
        self._driven_m_per_s = 0.0
        self._person_m_per_s = 0.0

    def observe(
        self, centroid: Optional[Centroid], *, stamp_s: float, driven_m_per_s: Optional[float], now_s: float
    ) -> FollowingStep:
        """Take a picture, and return the velocity to drive.

        Args:
            centroid: where the person is, or None
            stamp_s: when the picture was taken, on the clock of the robot
            driven_m_per_s: speed of the robot by odometry; None to use the commanded speed instead
            now_s: monotonic time now
        """
        if centroid is None:
            self._last = None
            self._person_m_per_s = 0.0
            self._driven_m_per_s = 0.0
            return self.wait(now_s=now_s)
        settings = self.settings
        self._seen_s = now_s
        passed_s = stamp_s - self._last_stamp_s
        if self._last is not None and 0.0 < passed_s < 1.0:
            robot_m_per_s = self._driven_m_per_s if driven_m_per_s is None else driven_m_per_s
            speed_m_per_s = (centroid.z_m - self._last.z_m) / passed_s + robot_m_per_s
            weight = passed_s / (passed_s + self.FILTER_S)
            self._person_m_per_s += weight * (speed_m_per_s - self._person_m_per_s)
        self._last = centroid
        self._last_stamp_s = stamp_s
        gap_m = centroid.z_m - settings.goal_z_m
        linear = settings.z_scale_per_s * gap_m + settings.speed_share * self._person_m_per_s
        # In front of a standing person the robot stands, without creeping back and forth.
        if abs(gap_m) < self.DEAD_M and abs(linear) < 2.0 * self.DEAD_M:
            linear = 0.0
        angular = -settings.x_scale_rad_per_m_s * centroid.x_m
        if abs(angular) < self.DEAD_RAD_PER_S:
            angular = 0.0
        limit, turn_limit = settings.max_linear_m_per_s, settings.max_angular_rad_per_s
        self._driven_m_per_s = max(-limit, min(limit, linear))
        return FollowingStep(
            linear_m_per_s=self._driven_m_per_s,
            angular_rad_per_s=max(-turn_limit, min(turn_limit, angular)),
            sight=Sight.SEEN,
        )

    def wait(self, *, now_s: float) -> FollowingStep:
        """Return what to do without a picture, or without a person in it: stand, and give up in the end."""
        sight = Sight.LOST if now_s - self._seen_s > self.settings.lost_timeout_s else Sight.UNSEEN
        return FollowingStep(0.0, 0.0, sight)
