"""Trajectories and limits of the arms."""

import math
from pathlib import Path

import pytest
import yaml

from pr2_props.props import JOINTS, Arm, Pose, PropError, check, joint_names, read_limits, read_props

CONFIG = Path(__file__).resolve().parents[2] / "config"
LIMITS = read_limits(yaml.safe_load((CONFIG / "joint_limits.yaml").read_text(encoding="utf-8")))
PROPS = read_props(yaml.safe_load((CONFIG / "props.yaml").read_text(encoding="utf-8")), LIMITS)
SAFE = PROPS.safe_rad[Arm.RIGHT]


def moved(joint: str, position: float) -> Pose:
    return Pose(at_s=10.0, positions_rad=tuple(position if name == joint else safe for name, safe in zip(JOINTS, SAFE)))


def test_every_joint_of_both_arms_has_a_limit() -> None:
    assert set(LIMITS) == {name for arm in Arm for name in joint_names(arm)}


@pytest.mark.parametrize(
    "name", ["high_fiving", "low_fiving", "pounding", "hugging", "extending_arm", "retracting_arm", "waving"]
)
def test_prop_ends_in_the_safe_pose(name: str) -> None:
    for arm, poses in PROPS.trajectories[name].items():
        assert poses[-1].positions_rad == PROPS.safe_rad[arm]


@pytest.mark.parametrize(
    "pose, message",
    [
        (moved("elbow_flex_joint", 0.0), "r_elbow_flex_joint"),
        (moved("shoulder_lift_joint", 1.5), "r_shoulder_lift_joint"),
        (moved("forearm_roll_joint", math.nan), "r_forearm_roll_joint"),
        (Pose(at_s=0.01, positions_rad=moved("elbow_flex_joint", -0.2).positions_rad), "rad/s"),
        (Pose(at_s=0.0, positions_rad=SAFE), "time must advance"),
    ],
)
def test_check_refuses_what_a_joint_may_not_do(pose: Pose, message: str) -> None:
    with pytest.raises(PropError, match=message):
        check("test", Arm.RIGHT, SAFE, [pose], LIMITS)


def test_a_joint_that_turns_for_ever_has_no_end() -> None:
    check("test", Arm.RIGHT, SAFE, [moved("wrist_roll_joint", 7.0)], LIMITS)


def test_props_with_a_missing_number_are_refused() -> None:
    with pytest.raises(PropError, match="expected 7"):
        read_props({"safe": {"right": [0.0], "left": [0.0]}}, LIMITS)


@pytest.mark.parametrize("entry", [{}, {"speed": 0.0}, {"speed": -1.0}, {"speed": 1.0, "lower": 1.0, "upper": 0.0}])
def test_limits_that_leave_no_room_are_refused(entry: dict) -> None:
    with pytest.raises(PropError):
        read_limits({"joint": entry})
