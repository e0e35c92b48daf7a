"""The differential base against hand calculation."""

import math

import pytest

from roboframenet_sim import base as base_module
from roboframenet_sim.base import BaseLimits, DifferentialBase, Pose, Velocity, integrate


def drive(base, velocity, seconds, step_s=0.02):
    for _ in range(round(seconds / step_s)):
        base.command(velocity)
        base.step(step_s)


def test_integrate_half_circle_ends_one_diameter_to_the_left():
    pose = integrate(
        Pose(), velocity=Velocity(linear_m_per_s=math.pi / 2, angular_rad_per_s=math.pi / 2), duration_s=2.0
    )
    assert pose.x_m == pytest.approx(0.0, abs=1e-12)
    assert pose.y_m == pytest.approx(2.0)
    assert pose.yaw_rad == pytest.approx(math.pi)


def test_integrate_straight_is_the_limit_of_the_arc():
    straight = integrate(Pose(yaw_rad=0.5), velocity=Velocity(linear_m_per_s=1.0), duration_s=1.0)
    nearly = integrate(Pose(yaw_rad=0.5), velocity=Velocity(linear_m_per_s=1.0, angular_rad_per_s=1e-7), duration_s=1.0)
    assert straight.x_m == pytest.approx(math.cos(0.5)) and straight.y_m == pytest.approx(math.sin(0.5))
    assert nearly.x_m == pytest.approx(straight.x_m, abs=1e-6)


def test_base_speeds_up_with_its_acceleration():
    base = DifferentialBase(BaseLimits(linear_acceleration_m_per_s2=0.5))
    drive(base, Velocity(linear_m_per_s=0.4), seconds=0.4)
    assert base.velocity.linear_m_per_s == pytest.approx(0.2)
    assert base.pose.x_m == pytest.approx(0.5 * 0.5 * 0.4**2)


def test_base_keeps_its_top_speed():
    base = DifferentialBase()
    drive(base, Velocity(linear_m_per_s=9.0, angular_rad_per_s=-9.0), seconds=2.0)
    assert base.velocity == Velocity(linear_m_per_s=0.65, angular_rad_per_s=-math.pi)


@pytest.mark.parametrize("step_s", [0.02, 0.05, 3.0])
def test_base_stops_by_itself_when_commands_cease(step_s):
    base = DifferentialBase(BaseLimits(linear_acceleration_m_per_s2=1.0))
    drive(base, Velocity(linear_m_per_s=0.5), seconds=1.0)
    start_m = base.pose.x_m
    for _ in range(math.ceil(3.0 / step_s)):
        base.step(step_s)
    assert base.velocity.linear_m_per_s == 0.0
    # Half a second on at full speed (less the step that already passed), then 0.5 s of braking.
    assert base.pose.x_m - start_m == pytest.approx(0.5 * 0.48 + 0.125, abs=0.02)


def test_base_that_was_never_commanded_stands():
    base = DifferentialBase(pose=Pose(1.0, 2.0, 3.0))
    base.step(5.0)
    assert base.pose == Pose(1.0, 2.0, 3.0)


def test_base_that_stands_is_not_moved_through_an_hour(monkeypatch):
    # The odometry is silent for as long as a step takes.
    moved = []
    monkeypatch.setattr(base_module, "integrate", lambda pose, **way: moved.append(way) or integrate(pose, **way))
    base = DifferentialBase()
    drive(base, Velocity(linear_m_per_s=0.4), seconds=0.4)
    stopped, hour = DifferentialBase(pose=base.pose), DifferentialBase(pose=base.pose)
    for one, duration_s in ((stopped, 10.0), (hour, 3600.0)):
        one.command(Velocity(linear_m_per_s=0.4))
        moved.clear()
        one.step(duration_s)
        assert len(moved) < 200
    assert hour.pose == stopped.pose
    drive(hour, Velocity(linear_m_per_s=0.4), seconds=0.4)
    assert hour.velocity.linear_m_per_s == pytest.approx(0.4)


@pytest.mark.parametrize("number", [math.nan, math.inf, -math.inf])
def test_command_that_is_not_finite_stops_the_base(number):
    base = DifferentialBase()
    drive(base, Velocity(linear_m_per_s=0.5), seconds=1.0)
    assert not base.command(Velocity(linear_m_per_s=number))
    base.step(2.0)
    assert base.velocity == Velocity()
    assert math.isfinite(base.pose.x_m)


def test_yaw_counts_whole_turns():
    base = DifferentialBase()
    drive(base, Velocity(angular_rad_per_s=2.0), seconds=10.0)
    assert base.pose.yaw_rad > 2 * math.pi


def test_noise_follows_the_seed():
    def end(seed, noise=0.1):
        base = DifferentialBase(BaseLimits(velocity_noise=noise), seed=seed)
        drive(base, Velocity(linear_m_per_s=0.5, angular_rad_per_s=0.3), seconds=2.0)
        return base.pose

    assert end(1) == end(1)
    assert end(1) != end(2)
    assert end(1, noise=0.0) == end(2, noise=0.0)


def test_base_stands_before_a_wall_and_can_turn_away():
    base = DifferentialBase(is_free=lambda x_m, y_m: x_m < 1.0)
    drive(base, Velocity(linear_m_per_s=0.5), seconds=4.0)
    assert 0.97 < base.pose.x_m < 1.0
    assert base.velocity.linear_m_per_s == 0.0
    drive(base, Velocity(linear_m_per_s=-0.5), seconds=1.0)
    assert base.pose.x_m < 0.8


@pytest.mark.parametrize(
    "wrong",
    [
        {"command_timeout_s": 0.0},
        {"max_linear_m_per_s": math.nan},
        {"velocity_noise": -0.1},
        {"linear_acceleration_m_per_s2": -1.0},
    ],
)
def test_limits_that_make_no_sense_are_refused(wrong):
    with pytest.raises(ValueError) as caught:
        BaseLimits(**wrong)
    assert next(iter(wrong)) in str(caught.value)


@pytest.mark.parametrize("duration_s", [-1.0, math.nan, math.inf])
def test_time_that_cannot_pass_is_refused(duration_s):
    with pytest.raises(ValueError):
        DifferentialBase().step(duration_s)
