"""The motion law, closed over the simulated base."""

import math
import random

import pytest

from move_action_server.motion import (
    STANDING,
    Motion,
    MotionGoal,
    MotionKind,
    MotionProfile,
    MotionSettings,
    MotionState,
    OdometrySample,
    Pace,
    check_goal,
    describe_progress,
)
from roboframenet_ros.pausable_clock import PausableClock
from roboframenet_sim.base import BaseLimits, DifferentialBase, Pose, Velocity

PERIOD_S = 0.02
SETTINGS = MotionSettings()


class Rig:
    """A motion that drives a simulated base; odometry arrives late by a number of periods."""

    def __init__(
        self,
        kind,
        amount,
        *,
        pace=Pace.USUAL,
        settings=SETTINGS,
        limits=BaseLimits(),
        pose=Pose(yaw_rad=3.0),
        lag=1,
        seed=1,
    ):
        self.base = DifferentialBase(limits, pose=pose, seed=seed)
        self.start = pose
        self.now_s = 100.0
        self.queue = [self.sample()] * (lag + 1)
        self.motion = Motion(MotionGoal(kind, amount, pace), settings=settings, start=self.sample(), now_s=self.now_s)
        self.last = None
        self.fastest = 0.0

    def sample(self):
        yaw = math.remainder(self.base.pose.yaw_rad, 2 * math.pi)
        return OdometrySample(stamp_s=self.now_s - 100.0, x_m=self.base.pose.x_m, y_m=self.base.pose.y_m, yaw_rad=yaw)

    def tick(self, is_seen=True):
        self.now_s += PERIOD_S
        self.base.step(PERIOD_S)
        self.queue.append(self.sample())
        sample = self.queue.pop(0)
        if is_seen:
            self.motion.observe(sample, now_s=self.now_s)
        self.last = self.motion.step(now_s=self.now_s)
        command = self.last.command
        self.fastest = max(self.fastest, abs(command.linear_m_per_s), abs(command.angular_rad_per_s))
        self.base.command(Velocity(command.linear_m_per_s, command.angular_rad_per_s))
        return self.last.state

    def run(self, seconds=200.0, **options):
        for _ in range(int(seconds / PERIOD_S)):
            if self.tick(**options) in (MotionState.ARRIVED, MotionState.FAILED):
                break
        return self.last

    def gone_m(self):
        return math.hypot(self.base.pose.x_m - self.start.x_m, self.base.pose.y_m - self.start.y_m)


@pytest.mark.parametrize(
    "amount_rad",
    [math.radians(120), -2.0, math.radians(5), math.radians(180), -math.radians(270), 4 * math.pi, math.radians(540)],
)
def test_turn_ends_within_one_percent(amount_rad):
    rig = Rig(MotionKind.TURN, amount_rad)
    assert rig.run().state is MotionState.ARRIVED
    assert rig.base.pose.yaw_rad - rig.start.yaw_rad == pytest.approx(amount_rad, rel=0.01, abs=0.004)
    assert rig.gone_m() == 0.0
    assert rig.fastest <= SETTINGS.turn.speed_per_s


@pytest.mark.parametrize("amount_m", [0.9144, -1.0, 0.1, 5.0, -0.3048])
def test_straight_ends_within_one_percent_and_in_the_right_direction(amount_m):
    rig = Rig(MotionKind.STRAIGHT, amount_m)
    assert rig.run().state is MotionState.ARRIVED
    along = (rig.base.pose.x_m - rig.start.x_m) * math.cos(3.0) + (rig.base.pose.y_m - rig.start.y_m) * math.sin(3.0)
    assert along == pytest.approx(amount_m, rel=0.01, abs=0.003)
    assert rig.fastest <= SETTINGS.straight.speed_per_s


@pytest.mark.parametrize("kind, amount", [(MotionKind.STRAIGHT, 2.0), (MotionKind.TURN, -2.0)])
def test_slow_motion_is_slower_and_a_quick_one_faster_and_both_arrive(kind, amount):
    rigs = {pace: Rig(kind, amount, pace=pace) for pace in Pace}
    for pace, rig in rigs.items():
        assert rig.run().state is MotionState.ARRIVED
        assert rig.fastest == pytest.approx(SETTINGS.profile_of(kind, pace).speed_per_s)
    assert rigs[Pace.SLOW].fastest < rigs[Pace.USUAL].fastest < rigs[Pace.QUICK].fastest


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("kind,amount", [(MotionKind.STRAIGHT, 2.0), (MotionKind.TURN, -2.0)])
def test_noise_and_late_odometry_cost_no_accuracy(kind, amount, seed):
    rig = Rig(kind, amount, limits=BaseLimits(velocity_noise=0.3), lag=15, seed=seed)
    assert rig.run().state is MotionState.ARRIVED
    assert rig.motion.progress == pytest.approx(amount, rel=0.02)
    pose = rig.base.pose
    gone = rig.gone_m() if kind is MotionKind.STRAIGHT else pose.yaw_rad - rig.start.yaw_rad
    assert gone == pytest.approx(amount, rel=0.02)


def test_base_that_brakes_badly_is_brought_back():
    rig = Rig(MotionKind.STRAIGHT, 0.5, limits=BaseLimits(linear_acceleration_m_per_s2=0.15))
    assert rig.run().state is MotionState.ARRIVED
    assert rig.gone_m() == pytest.approx(0.5, rel=0.02)


def test_jerky_odometry_arrives():
    chance = random.Random(4)
    rig = Rig(MotionKind.TURN, 2.0)
    for _ in range(10000):
        if rig.tick(is_seen=chance.random() < 0.15) is MotionState.ARRIVED:
            break
    assert rig.last.state is MotionState.ARRIVED
    assert rig.base.pose.yaw_rad - rig.start.yaw_rad == pytest.approx(2.0, rel=0.02)


def test_slow_simulated_clock_arrives():
    """Stamps that run ten times faster than the monotonic clock, as under a rate factor."""
    rig = Rig(MotionKind.TURN, 1.0)
    plain = rig.motion.observe
    rig.motion.observe = lambda sample, now_s: plain(
        OdometrySample(sample.stamp_s * 10, sample.x_m, sample.y_m, sample.yaw_rad), now_s=now_s
    )
    assert rig.run().state is MotionState.ARRIVED
    assert rig.motion.progress == pytest.approx(1.0, rel=0.02)


def test_lost_odometry_stops_at_once_and_then_fails():
    rig = Rig(MotionKind.STRAIGHT, 3.0)
    rig.run(seconds=2.0)
    assert rig.last.command.linear_m_per_s > 0.2
    rig.run(seconds=0.5, is_seen=False)
    assert rig.last.command == STANDING and rig.last.state is MotionState.MOVING
    rig.run(seconds=1.0, is_seen=False)
    assert rig.last.state is MotionState.FAILED and rig.last.command == STANDING
    assert "odometry is lost" in rig.last.reason


def test_odometry_that_comes_back_in_time_goes_on():
    rig = Rig(MotionKind.STRAIGHT, 1.0)
    rig.run(seconds=1.0)
    rig.run(seconds=0.7, is_seen=False)
    assert rig.run().state is MotionState.ARRIVED
    assert rig.gone_m() == pytest.approx(1.0, rel=0.02)


def test_stuck_base_fails_with_a_reason():
    rig = Rig(MotionKind.STRAIGHT, 3.0)
    rig.base._is_free = lambda x_m, y_m: math.hypot(x_m, y_m) < 0.5
    assert rig.run().state is MotionState.FAILED
    assert "does not move" in rig.last.reason
    assert rig.last.command == STANDING


def test_odometry_with_the_wrong_sign_fails_before_it_has_gone_far():
    rig = Rig(MotionKind.TURN, 2.0)
    plain = rig.motion.observe
    rig.motion.observe = lambda sample, now_s: plain(
        OdometrySample(sample.stamp_s, sample.x_m, sample.y_m, -sample.yaw_rad), now_s=now_s
    )
    rig.motion._last = OdometrySample(0.0, 0.0, 0.0, -3.0)
    assert rig.run().state is MotionState.FAILED
    assert "wrong way" in rig.last.reason
    assert abs(rig.base.pose.yaw_rad - 3.0) < 3.0


def test_base_that_hardly_turns_runs_out_of_time():
    rig = Rig(MotionKind.TURN, 2.0, limits=BaseLimits(max_angular_rad_per_s=0.01))
    assert rig.run().state is MotionState.FAILED
    assert "out of time" in rig.last.reason


def test_samples_that_are_not_finite_count_as_none():
    rig = Rig(MotionKind.STRAIGHT, 1.0)
    rig.run(seconds=1.0)
    rig.sample = lambda: OdometrySample(1.0, math.nan, 0.0, 0.0)
    assert rig.run().state is MotionState.FAILED
    assert "odometry is lost" in rig.last.reason


@pytest.mark.parametrize("pose", [Pose(5.0, 0.0, 3.0), Pose(0.0, 0.0, 1.0)])
def test_odometry_that_is_reset_fails(pose):
    rig = Rig(MotionKind.STRAIGHT, 3.0)
    rig.run(seconds=2.0)
    rig.base.pose = pose
    assert rig.run().state is MotionState.FAILED
    assert "jumped" in rig.last.reason


def test_final_state_is_kept():
    rig = Rig(MotionKind.TURN, 0.5)
    rig.run()
    before = rig.last
    rig.tick()
    assert rig.last == before


@pytest.mark.parametrize(
    "kind,amount,words",
    [
        (MotionKind.STRAIGHT, 3000.0, "more than the limit of 20 m"),
        (MotionKind.STRAIGHT, -21.0, "-21 m"),
        (MotionKind.TURN, math.inf, "finite"),
        (MotionKind.TURN, math.nan, "finite"),
        (MotionKind.TURN, 63.0, "limit of 62.83 rad (3600 degrees)"),
    ],
)
def test_goals_beyond_the_limits_are_refused(kind, amount, words):
    goal = MotionGoal(kind=kind, amount=amount)
    assert words in check_goal(goal, settings=SETTINGS)
    with pytest.raises(ValueError):
        Motion(goal, settings=SETTINGS, start=OdometrySample(0, 0, 0, 0), now_s=0.0)


@pytest.mark.parametrize("kind,amount", [(MotionKind.STRAIGHT, 20.0), (MotionKind.TURN, math.radians(-3600.0))])
def test_goals_at_the_limits_pass(kind, amount):
    assert check_goal(MotionGoal(kind=kind, amount=amount), settings=SETTINGS) is None


@pytest.mark.parametrize(
    "make",
    [
        lambda: MotionSettings(aim_share=0.1),
        lambda: MotionSettings(odometry_timeout_s=4.0),
        lambda: MotionSettings(stall_timeout_s=math.nan),
        lambda: MotionSettings(quick_share=3.5),
        lambda: MotionSettings(slow_share=1.0),
        lambda: MotionProfile(max_amount=1.0, speed_per_s=0.1, acceleration_per_s2=1.0, creep_per_s=0.2, tolerance=0.1),
        lambda: MotionProfile(
            max_amount=1.0, speed_per_s="0.1", acceleration_per_s2=1.0, creep_per_s=0.2, tolerance=0.1
        ),
    ],
)
def test_settings_that_make_no_sense_are_refused(make):
    with pytest.raises(ValueError):
        make()


@pytest.mark.parametrize(
    "kind, progress, sentence",
    [
        (MotionKind.STRAIGHT, 0.581, "I moved 0.58 m."),
        (MotionKind.STRAIGHT, 0.0001, "I moved 0 m."),
        (MotionKind.STRAIGHT, -0.0001, "I moved 0 m."),
        (MotionKind.STRAIGHT, -1.0, "I moved back 1 m."),
        (MotionKind.TURN, math.pi / 3.0, "I turned 60 degrees to the left."),
        (MotionKind.TURN, -math.pi, "I turned 180 degrees to the right."),
        (MotionKind.TURN, 0.001, "I turned 0 degrees."),
    ],
)
def test_progress_is_told_to_a_person(kind, progress, sentence):
    assert describe_progress(kind, progress) == sentence


@pytest.mark.parametrize("kind", MotionKind)
def test_base_that_is_held_is_stuck_and_one_that_moves_is_not(kind):
    rig = Rig(kind, 3.0)
    for _ in range(100):
        assert rig.tick() is MotionState.MOVING
        assert not rig.motion.is_stuck(now_s=rig.now_s)
    held = Rig(kind, 3.0)
    held.base.step = lambda _passed_s: None
    for _ in range(100):
        held.tick()
    assert held.motion.is_stuck(now_s=held.now_s)
    # Without odometry nobody knows.
    assert not held.motion.is_stuck(now_s=held.now_s + SETTINGS.odometry_timeout_s)


def test_motion_goes_on_after_a_pause_of_the_simulation():
    rig = Rig(MotionKind.STRAIGHT, 1.0)
    wall = {"s": 0.0, "ros_ns": 0}
    clock = PausableClock(ros_time_ns=lambda: wall["ros_ns"], is_simulated=True, now=lambda: wall["s"])

    def pass_time(is_paused):
        wall["s"] += PERIOD_S
        wall["ros_ns"] += 0 if is_paused else int(PERIOD_S * 1e9)
        return clock.now_s()

    for _ in range(50):
        pass_time(is_paused=False)
        assert rig.tick() is MotionState.MOVING
    begun_s = rig.now_s - clock.now_s()
    for _ in range(500):
        step = rig.motion.step(now_s=begun_s + pass_time(is_paused=True))
        assert step.state is MotionState.MOVING
    assert step.command == STANDING
    rig.now_s = begun_s + clock.now_s()
    assert rig.run().state is MotionState.ARRIVED
    assert rig.gone_m() == pytest.approx(1.0, rel=0.02)


def test_motion_goes_on_after_its_process_did_not_run():
    rig, held_up_s = Rig(MotionKind.STRAIGHT, 1.0), 0.0
    rig.run(seconds=1.0)
    clock = PausableClock(ros_time_ns=lambda: 0, is_simulated=False, now=lambda: rig.now_s + held_up_s)
    begin_s = clock.now_s()
    held_up_s = 10.0 * SETTINGS.odometry_timeout_s
    step = rig.motion.step(now_s=clock.now_s())
    assert step.state is MotionState.MOVING and step.command == STANDING
    rig.now_s += clock.now_s() - begin_s
    assert rig.run().state is MotionState.ARRIVED
    assert rig.gone_m() == pytest.approx(1.0, rel=0.02)
