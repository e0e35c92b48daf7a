"""An arm whose joints follow trajectories within their limits."""

import math
from dataclasses import dataclass
from typing import Dict, Optional, Tuple

from roboframenet_sim.base import approach


@dataclass(frozen=True)
class JointLimit:
    """Limits of a joint: radians, and radians per second. A joint without ends is continuous."""

    lower_rad: float
    upper_rad: float
    speed_rad_per_s: float


@dataclass(frozen=True)
class TrajectoryPoint:
    """Positions of the joints, and the time from the start of the trajectory."""

    positions_rad: Tuple[float, ...]
    time_s: float


@dataclass(frozen=True)
class Trajectory:
    """Points in order of time; their positions are in the order of the joint names."""

    joint_names: Tuple[str, ...]
    points: Tuple[TrajectoryPoint, ...]


RIGHT_LIMITS: Dict[str, JointLimit] = {
    "shoulder_pan": JointLimit(-2.135, 0.564, 2.08),
    "shoulder_lift": JointLimit(-0.353, 1.296, 2.08),
    "upper_arm_roll": JointLimit(-3.75, 0.65, 3.27),
    "elbow_flex": JointLimit(-2.121, -0.15, 3.3),
    "forearm_roll": JointLimit(-math.inf, math.inf, 3.6),
    "wrist_flex": JointLimit(-2.0, -0.1, 3.07),
    "wrist_roll": JointLimit(-math.inf, math.inf, 3.6),
}
"""The right arm of a PR2: the ranges in which its controllers move the joints."""

MIRRORED = ("shoulder_pan", "upper_arm_roll")
"""Joints whose range is mirrored in the left arm."""

TUCKED_RAD: Dict[str, float] = {
    "shoulder_pan": 0.0,
    "shoulder_lift": 1.1,
    "upper_arm_roll": 0.0,
    "elbow_flex": -1.9,
    "forearm_roll": 0.0,
    "wrist_flex": -1.0,
    "wrist_roll": 0.0,
}
"""Positions of the joints at the start."""


def arm_limits(prefix: str) -> Dict[str, JointLimit]:
    """Return the limits of the joints of an arm of a PR2, by the full name of the joint.

    Args:
        prefix: "r" or "l"
    """
    limits = {}
    for name, limit in RIGHT_LIMITS.items():
        if prefix == "l" and name in MIRRORED:
            limit = JointLimit(-limit.upper_rad, -limit.lower_rad, limit.speed_rad_per_s)
        limits[f"{prefix}_{name}_joint"] = limit
    return limits


def tucked_positions(prefix: str) -> Dict[str, float]:
    """Return the positions of the joints of a PR2 arm at the start, by the full name of the joint."""
    return {f"{prefix}_{name}_joint": position for name, position in TUCKED_RAD.items()}


class Arm:
    """An arm that follows one trajectory at a time, and holds still without one.

    Args:
        limits: by name of the joint
        positions_rad: positions of the joints
    """

    GOAL_TOLERANCE_RAD = 0.01
    SPEED_TOLERANCE = 1.01

    def __init__(self, limits: Dict[str, JointLimit], *, positions_rad: Dict[str, float]) -> None:
        self.limits = dict(limits)
        self.positions_rad = {name: positions_rad[name] for name in limits}
        self.velocities_rad_per_s = dict.fromkeys(limits, 0.0)
        self._trajectory: Optional[Trajectory] = None
        self._begin: Tuple[float, ...] = ()
        self._elapsed_s = 0.0

    def check(self, trajectory: Trajectory) -> Optional[str]:
        """Return why a trajectory cannot be followed from here; None if it can."""
        if sorted(trajectory.joint_names) != sorted(self.limits):
            return "the joints must be {}, got {}".format(
                ", ".join(self.limits),
                ", ".join(trajectory.joint_names) or "none",
            )
        if not trajectory.points:
            return "the trajectory has no points"
        before = TrajectoryPoint(tuple(self.positions_rad[name] for name in trajectory.joint_names), 0.0)
        for number, point in enumerate(trajectory.points):
            if len(point.positions_rad) != len(trajectory.joint_names):
                positions, joints = len(point.positions_rad), len(trajectory.joint_names)
                return f"point {number} has {positions} positions for {joints} joints"
            if not all(math.isfinite(value) for value in (*point.positions_rad, point.time_s)):
                return f"point {number} has numbers that are not finite"
            if point.time_s < before.time_s or (number and point.time_s == before.time_s):
                return f"point {number} is not later than the one before it"
            for name, old_rad, new_rad in zip(trajectory.joint_names, before.positions_rad, point.positions_rad):
                limit = self.limits[name]
                if not limit.lower_rad <= new_rad <= limit.upper_rad:
                    range_rad = f"{limit.lower_rad:.3f} to {limit.upper_rad:.3f}"
                    return f"point {number}: {name} at {new_rad:.3f} rad is outside of {range_rad}"
                way_rad = abs(new_rad - old_rad)
                reach_rad = limit.speed_rad_per_s * self.SPEED_TOLERANCE * (point.time_s - before.time_s)
                if way_rad > max(reach_rad, self.GOAL_TOLERANCE_RAD):
                    return f"point {number}: {name} would have to be faster than {limit.speed_rad_per_s:.2f} rad/s"
            before = point
        return None

    def follow(self, trajectory: Trajectory) -> None:
        """Follow a trajectory from now on, instead of the one before.

        Raises:
            ValueError: it cannot be followed from here
        """
        reason = self.check(trajectory)
        if reason:
            raise ValueError(reason)
        self._trajectory = trajectory
        self._begin = tuple(self.positions_rad[name] for name in trajectory.joint_names)
        self._elapsed_s = 0.0

    def hold(self) -> None:
        """Hold the present positions."""
        self._trajectory = None

    @property
    def is_moving(self) -> bool:
        """Whether a trajectory is still running."""
        return self._trajectory is not None

    def step(self, duration_s: float) -> None:
        """Advance the time. The trajectory ends when its time is up and the joints have arrived."""
        wanted = dict(self.positions_rad)
        trajectory = self._trajectory
        if trajectory is not None:
            self._elapsed_s += duration_s
            wanted = dict(zip(trajectory.joint_names, self._reference(trajectory)))
        for name, position_rad in self.positions_rad.items():
            reached_rad = approach(
                position_rad,
                target=wanted[name],
                step=self.limits[name].speed_rad_per_s * self.SPEED_TOLERANCE * duration_s,
            )
            if duration_s > 0.0:
                self.velocities_rad_per_s[name] = (reached_rad - position_rad) / duration_s
            self.positions_rad[name] = reached_rad
        if (
            trajectory is not None
            and self._elapsed_s >= trajectory.points[-1].time_s
            and all(abs(wanted[name] - self.positions_rad[name]) <= self.GOAL_TOLERANCE_RAD for name in wanted)
        ):
            self._trajectory = None

    def _reference(self, trajectory: Trajectory) -> Tuple[float, ...]:
        before_s, before = 0.0, self._begin
        for point in trajectory.points:
            if self._elapsed_s < point.time_s:
                share = (self._elapsed_s - before_s) / (point.time_s - before_s)
                return tuple(old + share * (new - old) for old, new in zip(before, point.positions_rad))
            before_s, before = point.time_s, point.positions_rad
        return before
