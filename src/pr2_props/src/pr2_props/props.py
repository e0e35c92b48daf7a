"""Trajectories of the arms of a PR2 for each prop, checked against the limits of the joints."""

import math
from dataclasses import dataclass
from enum import Enum
from typing import Any, Dict, Mapping, Sequence, Tuple


class Arm(Enum):
    """An arm. The value is its key in the files."""

    RIGHT = "right"
    LEFT = "left"

    @property
    def prefix(self) -> str:
        """First letter of the names of its joints and controllers."""
        return self.value[0]


#: Joints of an arm from the shoulder to the wrist, without the prefix of the arm.
JOINTS = (
    "shoulder_pan_joint",
    "shoulder_lift_joint",
    "upper_arm_roll_joint",
    "elbow_flex_joint",
    "forearm_roll_joint",
    "wrist_flex_joint",
    "wrist_roll_joint",
)
#: Time in which an arm moves to the safe pose, seconds.
RETURN_S = 2.5


class PropError(ValueError):
    """A prop or a limit is wrong; the message names the prop, the arm, the joint, what was found and what is
    allowed."""


@dataclass(frozen=True)
class JointLimit:
    """Limits of a joint.

    Attributes:
        lower_rad: smallest position; minus infinity for a continuous joint
        upper_rad: largest position
        speed_rad_per_s: largest speed in both directions
    """

    lower_rad: float
    upper_rad: float
    speed_rad_per_s: float


@dataclass(frozen=True)
class Pose:
    """Positions of an arm's joints.

    Attributes:
        at_s: when the positions are reached, seconds since the start of the trajectory
        positions_rad: one for each of :data:`JOINTS`
    """

    at_s: float
    positions_rad: Tuple[float, ...]


@dataclass(frozen=True)
class Props:
    """All trajectories of the arms.

    Attributes:
        safe_rad: safe pose of each arm
        trajectories: by frame name, then by arm, for both arms; every trajectory ends in the safe pose
        usual_arms: by frame name, the arms that move if nobody names one
    """

    safe_rad: Mapping[Arm, Tuple[float, ...]]
    trajectories: Mapping[str, Mapping[Arm, Tuple[Pose, ...]]]
    usual_arms: Mapping[str, Tuple[Arm, ...]]


def joint_names(arm: Arm) -> Tuple[str, ...]:
    """Return the names of the joints of an arm."""
    return tuple(f"{arm.prefix}_{joint}" for joint in JOINTS)


def read_limits(document: Mapping[str, Any]) -> Dict[str, JointLimit]:
    """Make limits from the content of a limits file.

    Raises:
        PropError: the speed of a joint is not positive, or its limits leave no room
    """
    limits = {}
    for name, entry in document.items():
        limit = JointLimit(
            lower_rad=float(entry.get("lower", -math.inf)),
            upper_rad=float(entry.get("upper", math.inf)),
            speed_rad_per_s=float(entry.get("speed", 0.0)),
        )
        if not limit.speed_rad_per_s > 0.0 or not limit.lower_rad < limit.upper_rad:
            raise PropError(f"limit of {name}: expected speed > 0 and lower < upper, found {entry}")
        limits[name] = limit
    return limits


def read_props(document: Mapping[str, Any], limits: Mapping[str, JointLimit]) -> Props:
    """Make props from the content of a props file, and check each against the limits.

    An arm that a prop does not list can do what the other one does, mirrored.

    Raises:
        PropError: a position or a speed is out of its limits, or a number is missing
    """
    safe = {arm: _positions("safe", arm, document["safe"][arm.value]) for arm in Arm}
    trajectories: Dict[str, Dict[Arm, Tuple[Pose, ...]]] = {}
    usual: Dict[str, Tuple[Arm, ...]] = {}
    for name, arms in document.items():
        if name == "safe":
            continue
        trajectories[name] = {}
        usual[name] = tuple(arm for arm in Arm if arm.value in arms)
        for arm in Arm:
            listed = arm if arm in usual[name] else usual[name][0]
            poses = []
            at_s = 0.0
            for entry in arms[listed.value]:
                at_s += float(entry["after_s"])
                positions = _positions(name, listed, entry["positions"])
                poses.append(Pose(at_s=at_s, positions_rad=positions if listed is arm else mirrored(positions)))
            poses.append(Pose(at_s=at_s + RETURN_S, positions_rad=safe[arm]))
            check(name, arm, safe[arm], poses, limits)
            trajectories[name][arm] = tuple(poses)
    return Props(safe_rad=safe, trajectories=trajectories, usual_arms=usual)


def mirrored(positions_rad: Sequence[float]) -> Tuple[float, ...]:
    """Return what the other arm does at the other side of the body: joints that pan or roll turn the other way."""
    return tuple(
        -position if "pan" in joint or "roll" in joint else position for joint, position in zip(JOINTS, positions_rad)
    )


def _positions(name: str, arm: Arm, numbers: Sequence[Any]) -> Tuple[float, ...]:
    positions = tuple(float(number) for number in numbers)
    if len(positions) != len(JOINTS):
        raise PropError(f"{name}, {arm.value} arm: expected {len(JOINTS)} positions, found {len(positions)}")
    return positions


def check(
    name: str, arm: Arm, start_rad: Sequence[float], poses: Sequence[Pose], limits: Mapping[str, JointLimit]
) -> None:
    """Check a trajectory before it is sent.

    Args:
        name: of the prop, for the message
        arm: the arm that moves
        start_rad: where the joints are now
        poses: in order of time
        limits: by name of joint
    Raises:
        PropError: a position or a speed is beyond its limit, a number is not finite, or time does not advance
    """
    before_s, before_rad = 0.0, tuple(start_rad)
    for pose in poses:
        if not pose.at_s > before_s or not math.isfinite(pose.at_s):
            raise PropError(f"{name}, {arm.value} arm: time must advance, found {pose.at_s} s after {before_s} s")
        for joint, start, position in zip(joint_names(arm), before_rad, pose.positions_rad):
            limit = limits[joint]
            if not limit.lower_rad <= position <= limit.upper_rad or not math.isfinite(position):
                raise PropError(
                    f"{name}: {joint} at {position:.3f} rad, allowed {limit.lower_rad} to {limit.upper_rad}"
                )
            speed = abs(position - start) / (pose.at_s - before_s)
            if speed > limit.speed_rad_per_s:
                raise PropError(f"{name}: {joint} at {speed:.2f} rad/s, allowed {limit.speed_rad_per_s}")
        before_s, before_rad = pose.at_s, pose.positions_rad
