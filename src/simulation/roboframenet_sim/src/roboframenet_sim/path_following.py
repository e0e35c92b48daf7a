"""Drives along a path: takes the pose, returns velocities."""

import math
from dataclasses import dataclass
from typing import List, Optional, Sequence, Tuple

from roboframenet_sim.base import STANDING, Pose, Velocity, clamp


@dataclass(frozen=True)
class FollowingLimits:
    """Speeds and tolerances of driving.

    Raises:
        ValueError: a number is not positive
    """

    linear_m_per_s: float = 0.5
    angular_rad_per_s: float = 1.2
    deceleration_m_per_s2: float = 0.5
    turn_gain_per_s: float = 2.0
    turn_in_place_rad: float = 0.35
    """If the next corner is farther to the side than this angle, the robot turns before it drives."""
    corner_tolerance_m: float = 0.05
    goal_tolerance_m: float = 0.03
    yaw_tolerance_rad: float = 0.03

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if not (isinstance(value, (int, float)) and math.isfinite(value) and value > 0.0):
                raise ValueError(f"{name} must be a positive number, got {value!r}")


def wrap(angle_rad: float) -> float:
    """Return the same direction between -pi and pi."""
    return math.remainder(angle_rad, 2.0 * math.pi)


class PathFollower:
    """Drives from corner to corner, and turns to the final direction at the end.

    Args:
        corners: of the path, in metres; the last is the goal
        yaw_rad: direction of the robot at the goal
        limits: speeds and tolerances
    """

    CREEP_M_PER_S = 0.05
    CREEP_RAD_PER_S = 0.1

    def __init__(
        self, corners: Sequence[Tuple[float, float]], *, yaw_rad: float, limits: FollowingLimits = FollowingLimits()
    ) -> None:
        self._ahead: List[Tuple[float, float]] = list(corners)
        self._yaw_rad = yaw_rad
        self._limits = limits
        self._is_turning = True

    def command(self, pose: Pose) -> Optional[Velocity]:
        """Return the velocity for a robot at this pose; None when it has arrived."""
        while self._ahead:
            distance_m = math.hypot(self._ahead[0][0] - pose.x_m, self._ahead[0][1] - pose.y_m)
            is_last = len(self._ahead) == 1
            if distance_m > (self._limits.goal_tolerance_m if is_last else self._limits.corner_tolerance_m):
                return self._to_corner(pose, distance_m)
            self._ahead.pop(0)
            self._is_turning = True
        error = wrap(self._yaw_rad - pose.yaw_rad)
        if abs(error) <= self._limits.yaw_tolerance_rad:
            return None
        return Velocity(angular_rad_per_s=self._turn_rate(error))

    @property
    def corners_ahead(self) -> Tuple[Tuple[float, float], ...]:
        """The corners that the robot has not passed, the goal last."""
        return tuple(self._ahead)

    def _turn_rate(self, error_rad: float) -> float:
        rate = clamp(self._limits.turn_gain_per_s * error_rad, limit=self._limits.angular_rad_per_s)
        return rate if abs(rate) >= self.CREEP_RAD_PER_S else math.copysign(self.CREEP_RAD_PER_S, error_rad)

    def _to_corner(self, pose: Pose, distance_m: float) -> Velocity:
        limits = self._limits
        corner = self._ahead[0]
        error = wrap(math.atan2(corner[1] - pose.y_m, corner[0] - pose.x_m) - pose.yaw_rad)
        # Turn until well aligned, and turn again only when far off, to avoid oscillation at the threshold.
        if abs(error) > limits.turn_in_place_rad:
            self._is_turning = True
        elif abs(error) < limits.turn_in_place_rad / 5.0:
            self._is_turning = False
        if self._is_turning:
            return Velocity(angular_rad_per_s=self._turn_rate(error)) if error else STANDING
        speed = max(
            self.CREEP_M_PER_S,
            min(limits.linear_m_per_s, 0.8 * math.sqrt(2.0 * limits.deceleration_m_per_s2 * distance_m)),
        )
        return Velocity(
            linear_m_per_s=speed * math.cos(error),
            angular_rad_per_s=clamp(limits.turn_gain_per_s * error, limit=limits.angular_rad_per_s),
        )
