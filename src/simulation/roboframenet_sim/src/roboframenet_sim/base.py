"""A differential base: takes velocity commands, returns poses.

The caller counts the time in seconds; the same commands at the same times give the same poses.
"""

import math
import random
from dataclasses import dataclass
from typing import Callable, Optional


@dataclass(frozen=True)
class Pose:
    """A pose on the floor. The yaw is continuous: it counts whole turns (left is positive, REP 103)."""

    x_m: float = 0.0
    y_m: float = 0.0
    yaw_rad: float = 0.0


@dataclass(frozen=True)
class Velocity:
    """Speed along the heading of the robot, and turn rate; forward and left are positive."""

    linear_m_per_s: float = 0.0
    angular_rad_per_s: float = 0.0

    def is_finite(self) -> bool:
        """Whether both numbers are finite."""
        return math.isfinite(self.linear_m_per_s) and math.isfinite(self.angular_rad_per_s)


STANDING = Velocity()


@dataclass(frozen=True)
class BaseLimits:
    """Limits of the base. The speeds are the rated speeds of the base of the Turtlebot 2.

    Raises:
        ValueError: a limit is not a positive number, or the noise is negative
    """

    max_linear_m_per_s: float = 0.65
    max_angular_rad_per_s: float = math.pi
    linear_acceleration_m_per_s2: float = 1.5
    angular_acceleration_rad_per_s2: float = 6.0
    command_timeout_s: float = 0.5
    velocity_noise: float = 0.0
    """Standard deviation of the executed velocity, as a share of the commanded one; odometry measures the former.
    """

    def __post_init__(self) -> None:
        for name in (
            "max_linear_m_per_s",
            "max_angular_rad_per_s",
            "linear_acceleration_m_per_s2",
            "angular_acceleration_rad_per_s2",
            "command_timeout_s",
        ):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0.0):
                raise ValueError(f"{name} must be a positive number, got {value!r}")
        if not 0.0 <= self.velocity_noise <= 1.0:
            raise ValueError(f"velocity_noise must be 0 to 1, got {self.velocity_noise!r}")


def clamp(value: float, *, limit: float) -> float:
    """Return the value, limited to -limit .. limit."""
    return max(-limit, min(limit, value))


def approach(value: float, *, target: float, step: float) -> float:
    """Return the value, moved towards the target by at most the step."""
    return value + clamp(target - value, limit=step)


def integrate(pose: Pose, *, velocity: Velocity, duration_s: float) -> Pose:
    """Drive an arc with constant velocity, in closed form.

    Turning by d while driving l along the arc moves the base by the chord l sin(d/2)/(d/2), in the mean direction.
    """
    turned = velocity.angular_rad_per_s * duration_s
    half = turned / 2.0
    shortening = 1.0 - half * half / 6.0 if abs(half) < 1e-4 else math.sin(half) / half
    chord = velocity.linear_m_per_s * duration_s * shortening
    return Pose(
        x_m=pose.x_m + chord * math.cos(pose.yaw_rad + half),
        y_m=pose.y_m + chord * math.sin(pose.yaw_rad + half),
        yaw_rad=pose.yaw_rad + turned,
    )


class DifferentialBase:
    """A base that follows velocity commands within its limits, and stops by itself when commands cease.

    Args:
        limits: limits of the base
        pose: first pose
        seed: seed of the velocity noise
        is_free: says whether the centre of the base may be at (x_m, y_m); without it the floor is empty. A base at an
            obstacle can turn but not advance, and its odometry shows that.
    """

    MAX_STEP_S = 0.02

    def __init__(
        self,
        limits: BaseLimits = BaseLimits(),
        *,
        pose: Pose = Pose(),
        seed: int = 0,
        is_free: Optional[Callable[[float, float], bool]] = None,
    ) -> None:
        self.limits = limits
        self.pose = pose
        self.velocity = STANDING
        self._wanted = STANDING
        self._age_s = math.inf
        self._random = random.Random(seed)
        self._is_free = is_free

    def command(self, velocity: Velocity) -> bool:
        """Take a command. It holds until the next one or until the command timeout.

        Returns:
            False if the numbers are not finite; the base then stops
        """
        is_finite = velocity.is_finite()
        self._wanted = velocity if is_finite else STANDING
        self._age_s = 0.0
        return is_finite

    def step(self, duration_s: float) -> None:
        """Advance the time.

        Args:
            duration_s: finite and not negative; long steps are divided so that the command timeout is exact
        """
        if not (math.isfinite(duration_s) and duration_s >= 0.0):
            raise ValueError(f"duration_s must be a finite number and not negative, got {duration_s!r}")
        pieces = max(1, math.ceil(duration_s / self.MAX_STEP_S - 1e-9))
        for done in range(1, pieces + 1):
            self._step(duration_s / pieces)
            if self._stays:
                # A clock that jumps by an hour must not keep the odometry silent for seconds.
                self._age_s += duration_s * (pieces - done) / pieces
                break

    @property
    def _stays(self) -> bool:
        """Whether the base stands, and no command moves it."""
        is_commanded = self._age_s < self.limits.command_timeout_s and self._wanted != STANDING
        return self.velocity == STANDING and not is_commanded

    def _step(self, duration_s: float) -> None:
        limits = self.limits
        wanted = self._wanted if self._age_s < limits.command_timeout_s else STANDING
        self._age_s += duration_s
        before = self.velocity
        after = Velocity(
            linear_m_per_s=approach(
                before.linear_m_per_s,
                target=clamp(wanted.linear_m_per_s, limit=limits.max_linear_m_per_s),
                step=limits.linear_acceleration_m_per_s2 * duration_s,
            ),
            angular_rad_per_s=approach(
                before.angular_rad_per_s,
                target=clamp(wanted.angular_rad_per_s, limit=limits.max_angular_rad_per_s),
                step=limits.angular_acceleration_rad_per_s2 * duration_s,
            ),
        )
        mean = Velocity(
            linear_m_per_s=self._noisy((before.linear_m_per_s + after.linear_m_per_s) / 2.0),
            angular_rad_per_s=self._noisy((before.angular_rad_per_s + after.angular_rad_per_s) / 2.0),
        )
        pose = integrate(self.pose, velocity=mean, duration_s=duration_s)
        if self._is_blocked(pose):
            after = Velocity(angular_rad_per_s=after.angular_rad_per_s)
            pose = integrate(
                self.pose, velocity=Velocity(angular_rad_per_s=mean.angular_rad_per_s), duration_s=duration_s
            )
        self.velocity = after
        self.pose = pose

    def _noisy(self, speed: float) -> float:
        if self.limits.velocity_noise == 0.0:
            return speed
        return speed * (1.0 + self._random.gauss(0.0, self.limits.velocity_noise))

    def _is_blocked(self, pose: Pose) -> bool:
        if self._is_free is None or self._is_free(pose.x_m, pose.y_m):
            return False
        # A base that starts on an obstacle can still drive off.
        return self._is_free(self.pose.x_m, self.pose.y_m)
