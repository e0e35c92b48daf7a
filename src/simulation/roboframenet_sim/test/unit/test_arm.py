"""An arm with limits."""

import math

import pytest

from roboframenet_sim.arm import Arm, JointLimit, Trajectory, TrajectoryPoint, arm_limits, tucked_positions

LIMITS = {"a": JointLimit(-1.0, 1.0, 1.0), "b": JointLimit(-math.inf, math.inf, 2.0)}


def arm():
    return Arm(LIMITS, positions_rad={"a": 0.0, "b": 0.0})


def trajectory(*points, names=("a", "b")):
    return Trajectory(
        joint_names=tuple(names),
        points=tuple(TrajectoryPoint(positions_rad=tuple(positions), time_s=time_s) for positions, time_s in points),
    )


def run(moved, seconds, step_s=0.01):
    fastest = 0.0
    for _ in range(round(seconds / step_s)):
        moved.step(step_s)
        fastest = max(fastest, *map(abs, moved.velocities_rad_per_s.values()))
    return fastest


def test_arm_goes_through_the_points_and_ends():
    moved = arm()
    moved.follow(trajectory(((0.5, 1.0), 1.0), ((-0.5, 7.0), 4.0)))
    run(moved, 1.0)
    assert moved.positions_rad["a"] == pytest.approx(0.5) and moved.is_moving
    run(moved, 1.5)
    assert moved.positions_rad["a"] == pytest.approx(0.0, abs=1e-6)
    run(moved, 1.6)
    assert moved.positions_rad == {"a": pytest.approx(-0.5), "b": pytest.approx(7.0)} and not moved.is_moving


def test_joints_may_come_in_another_order():
    moved = arm()
    moved.follow(trajectory(((1.0, 0.5), 1.0), names=("b", "a")))
    run(moved, 1.1)
    assert moved.positions_rad == {"a": pytest.approx(0.5), "b": pytest.approx(1.0)}


def test_hold_stops_where_the_arm_is():
    moved = arm()
    moved.follow(trajectory(((1.0, 0.0), 1.0)))
    run(moved, 0.5)
    moved.hold()
    run(moved, 1.0)
    assert moved.positions_rad["a"] == pytest.approx(0.5) and moved.velocities_rad_per_s["a"] == 0.0


def test_new_trajectory_starts_where_the_arm_is():
    moved = arm()
    moved.follow(trajectory(((1.0, 0.0), 1.0)))
    run(moved, 0.5)
    moved.follow(trajectory(((0.0, 0.0), 1.0)))
    assert run(moved, 1.1) <= LIMITS["a"].speed_rad_per_s * 1.02
    assert moved.positions_rad["a"] == pytest.approx(0.0)


@pytest.mark.parametrize(
    "wrong,words",
    [
        (trajectory(), "no points"),
        (trajectory(((0.0,), 1.0)), "1 positions for 2"),
        (trajectory(((1.5, 0.0), 3.0)), "outside of -1.000 to 1.000"),
        (trajectory(((1.0, 0.0), 0.5)), "faster"),
        (trajectory(((0.5, 0.0), 1.0), ((-0.9, 0.0), 1.5)), "point 1: a would have to be faster"),
        (trajectory(((0.5, 0.0), 1.0), ((0.5, 0.0), 1.0)), "not later"),
        (trajectory(((0.5, 0.0), -1.0)), "not later"),
        (trajectory(((math.nan, 0.0), 1.0)), "finite"),
        (trajectory(((0.5, 0.0), math.inf)), "finite"),
        (trajectory(((0.1,), 1.0), names=("a",)), "joints must be a, b"),
        (trajectory(((0.0, 0.5), 0.0)), "faster"),
    ],
)
def test_trajectory_that_cannot_be_followed(wrong, words):
    moved = arm()
    assert words in moved.check(wrong)
    with pytest.raises(ValueError):
        moved.follow(wrong)


@pytest.mark.parametrize("prefix", ["r", "l"])
def test_pr2_arms_start_within_their_limits(prefix):
    limits, positions = arm_limits(prefix), tucked_positions(prefix)
    assert len(limits) == 7
    assert all(limits[name].lower_rad <= position <= limits[name].upper_rad for name, position in positions.items())


def test_left_arm_mirrors_the_right():
    assert arm_limits("l")["l_shoulder_pan_joint"].upper_rad == -arm_limits("r")["r_shoulder_pan_joint"].lower_rad
    assert arm_limits("l")["l_elbow_flex_joint"] == arm_limits("r")["r_elbow_flex_joint"]
