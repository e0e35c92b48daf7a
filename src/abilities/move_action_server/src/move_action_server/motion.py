"""Moves or turns by an amount: takes odometry, returns velocities.

Forward and left are positive (REP 103). The module neither waits nor reads a clock: the caller passes the time.
"""

import enum
import math
from dataclasses import dataclass, replace
from typing import Optional


class MotionKind(enum.Enum):
    """Along the heading of the base, or about the vertical axis."""

    STRAIGHT = "straight"
    TURN = "turn"


class Pace(enum.Enum):
    """How fast to go, compared with the usual speed."""

    SLOW = "slow"
    USUAL = "usual"
    QUICK = "quick"


@dataclass(frozen=True)
class MotionGoal:
    """How far to go: metres for STRAIGHT, radians for TURN; forward and left are positive. And how fast."""

    kind: MotionKind
    amount: float
    pace: Pace = Pace.USUAL


@dataclass(frozen=True)
class MotionCommand:
    """A velocity for the base."""

    linear_m_per_s: float = 0.0
    angular_rad_per_s: float = 0.0


STANDING = MotionCommand()


@dataclass(frozen=True)
class OdometrySample:
    """Where odometry says that the base is.

    ``stamp_s`` is the time of the measurement on the clock of the robot, which may be a simulated one.
    """

    stamp_s: float
    x_m: float
    y_m: float
    yaw_rad: float

    def is_finite(self) -> bool:
        """Whether all numbers are finite."""
        return all(math.isfinite(value) for value in (self.stamp_s, self.x_m, self.y_m, self.yaw_rad))


@dataclass(frozen=True)
class MotionProfile:
    """Speeds and accuracy of one kind of motion; metres for STRAIGHT, radians for TURN.

    Raises:
        ValueError: a number that is not positive, or a creeping speed above the top speed
    """

    max_amount: float
    speed_per_s: float
    acceleration_per_s2: float
    creep_per_s: float
    """Slowest speed that still moves the base; used for the last part of a motion."""
    tolerance: float
    """Smallest tolerance, for short motions: a share of their amount would be below the resolution of odometry."""

    def __post_init__(self) -> None:
        for name in ("max_amount", "speed_per_s", "acceleration_per_s2", "creep_per_s", "tolerance"):
            value = getattr(self, name)
            if not (isinstance(value, (int, float)) and math.isfinite(value) and value > 0.0):
                raise ValueError(f"{name} must be a positive number, got {value!r}")
        if self.creep_per_s > self.speed_per_s:
            raise ValueError(f"creep_per_s {self.creep_per_s:g} is above speed_per_s {self.speed_per_s:g}")


@dataclass(frozen=True)
class MotionSettings:
    """Speeds, tolerances and time limits of motions.

    Raises:
        ValueError: a time or share is out of range, or turns cannot be counted at the turn rate
    """

    straight: MotionProfile = MotionProfile(
        max_amount=20.0, speed_per_s=0.3, acceleration_per_s2=0.5, creep_per_s=0.02, tolerance=0.002
    )
    turn: MotionProfile = MotionProfile(
        max_amount=20.0 * math.pi, speed_per_s=1.0, acceleration_per_s2=1.5, creep_per_s=0.06, tolerance=0.003
    )
    aim_share: float = 0.005
    """The base stops when it is within this share of the amount."""
    accept_share: float = 0.02
    """A motion that ends farther from the goal than this share of the amount has failed."""
    odometry_timeout_s: float = 1.0
    stall_timeout_s: float = 3.0
    slow_share: float = 0.5
    """Share of the usual speed of a slow motion."""
    quick_share: float = 1.5
    """Share of the usual speed of a quick motion."""

    def __post_init__(self) -> None:
        if not 0.0 < self.aim_share <= self.accept_share < 1.0:
            raise ValueError(
                f"shares must be 0 < aim_share <= accept_share < 1, got {self.aim_share!r} and {self.accept_share!r}"
            )
        for name in ("odometry_timeout_s", "stall_timeout_s"):
            value = getattr(self, name)
            if not (isinstance(value, (int, float)) and math.isfinite(value) and 0.1 <= value <= 60.0):
                raise ValueError(f"{name} must be 0.1 to 60 s, got {value!r}")
        if not 0.0 < self.slow_share < 1.0 < self.quick_share < math.inf:
            raise ValueError(
                f"shares must be 0 < slow_share < 1 < quick_share, got {self.slow_share!r} and {self.quick_share!r}"
            )
        # Between two samples the base must turn by less than half a turn; otherwise the direction is ambiguous.
        quickest = self.turn.speed_per_s * self.quick_share
        if quickest * self.odometry_timeout_s >= math.pi:
            raise ValueError(
                f"turning with {quickest:g} rad/s for odometry_timeout_s {self.odometry_timeout_s:g} "
                "is half a turn or more"
            )

    def profile_of(self, kind: MotionKind, pace: Pace = Pace.USUAL) -> MotionProfile:
        """Return the profile of a kind of motion at a pace; no motion is slower than creeping."""
        usual = {MotionKind.STRAIGHT: self.straight, MotionKind.TURN: self.turn}[kind]
        share = {Pace.SLOW: self.slow_share, Pace.USUAL: 1.0, Pace.QUICK: self.quick_share}[pace]
        return replace(usual, speed_per_s=max(usual.creep_per_s, share * usual.speed_per_s))


def describe_amount(goal: MotionGoal) -> str:
    """Return an amount in words, for a person."""
    if goal.kind is MotionKind.STRAIGHT:
        return f"{goal.amount:.4g} m"
    return f"{goal.amount:.4g} rad ({math.degrees(goal.amount):.4g} degrees)"


def describe_progress(kind: MotionKind, progress: float) -> str:
    """Return how far a base has come, in a sentence for a person: "I moved 0.58 m."."""
    if kind is MotionKind.STRAIGHT:
        return f"I moved {'back ' if progress <= -0.005 else ''}{abs(round(progress, 2)):g} m."
    degrees = round(math.degrees(progress))
    side = " to the left" if degrees > 0 else " to the right" if degrees < 0 else ""
    return f"I turned {abs(degrees)} degrees{side}."


def check_goal(goal: MotionGoal, *, settings: MotionSettings) -> Optional[str]:
    """Return why a goal must not be driven; None if it may."""
    if not math.isfinite(goal.amount):
        return "the amount is not a finite number"
    limit = MotionGoal(kind=goal.kind, amount=settings.profile_of(goal.kind).max_amount)
    if abs(goal.amount) > limit.amount:
        return f"{describe_amount(goal)} is more than the limit of {describe_amount(limit)}"
    return None


def wrap(angle_rad: float) -> float:
    """Return the same direction between -pi and pi."""
    return math.remainder(angle_rad, 2.0 * math.pi)


class MotionState(enum.Enum):
    """Progress of a motion. ARRIVED and FAILED are final."""

    MOVING = "moving"
    SETTLING = "settling"
    ARRIVED = "arrived"
    FAILED = "failed"


@dataclass(frozen=True)
class MotionStep:
    """The velocity to publish now; with FAILED also the reason."""

    command: MotionCommand
    state: MotionState
    reason: str = ""


class Motion:
    """A motion, from its first odometry sample until the base stands at the end.

    Call :meth:`observe` for each odometry sample and :meth:`step` at least as often. Publish the velocity that
    :meth:`step` returns.

    Args:
        goal: a goal that :func:`check_goal` accepts
        settings: speeds, tolerances, timeouts
        start: odometry now
        now_s: monotonic time now

    Raises:
        ValueError: a goal that must not be driven
    """

    STAND_WINDOW_S = 0.2
    MAX_CORRECTIONS = 6
    JUMP = 0.3
    """A sample this far (metres, radians) beyond three times the top speed means that odometry was reset."""
    HEADING_GAIN_PER_S = 1.5
    MAX_HEADING_RATE_RAD_PER_S = 0.3
    REACTION_S = 0.06
    """Time from a measurement to the reaction of the base; braking begins this much earlier."""

    def __init__(self, goal: MotionGoal, *, settings: MotionSettings, start: OdometrySample, now_s: float) -> None:
        reason = check_goal(goal, settings=settings)
        if reason:
            raise ValueError(reason)
        self._goal = goal
        self._settings = settings
        self._profile = settings.profile_of(goal.kind, goal.pace)
        self._aim = max(self._profile.tolerance, settings.aim_share * abs(goal.amount))
        self._accept = max(2.0 * self._profile.tolerance, settings.accept_share * abs(goal.amount))
        self._start = start
        self._last = start
        self._turned_rad = 0.0
        self._speed_per_s = 0.0
        self._corrections = 0
        self._state = MotionState.MOVING
        self._reason = ""
        self._is_new = True
        self._sample_s = now_s
        self._elapsed_s = 0.0
        self._stand_begin_s = 0.0
        self._stand_progress = 0.0
        self._stall_begin_s = now_s
        self._stall_progress = 0.0
        # Braking and reaction may double the time that the speed alone needs; a base three times as slow is not moving.
        self._end_s = now_s + 20.0 + 3.0 * abs(goal.amount) / self._profile.speed_per_s
        self._step_elapsed_s = 0.0

    @property
    def progress(self) -> float:
        """Progress in metres or radians, with the sign of :class:`MotionGoal`.

        Straight: the distance along the heading at the start. Turn: the sum of all rotation, including whole turns.
        """
        if self._goal.kind is MotionKind.TURN:
            return self._turned_rad
        return (self._last.x_m - self._start.x_m) * math.cos(self._start.yaw_rad) + (
            self._last.y_m - self._start.y_m
        ) * math.sin(self._start.yaw_rad)

    def is_stuck(self, *, now_s: float) -> bool:
        """Whether the base should move, and odometry, which arrives, says that it has stood for a moment."""
        is_seen = now_s - self._sample_s <= self._settings.odometry_timeout_s / 3.0
        stood_s = now_s - self._stall_begin_s
        return self._state is MotionState.MOVING and is_seen and stood_s > self._settings.stall_timeout_s / 6.0

    def observe(self, sample: OdometrySample, *, now_s: float) -> None:
        """Take an odometry sample. A sample that is not finite is ignored."""
        if not sample.is_finite():
            return
        passed_s = sample.stamp_s - self._last.stamp_s
        if not 0.0 < passed_s <= self._settings.odometry_timeout_s:
            # When the clock stands or jumps (a restarted simulation), use the time of arrival.
            passed_s = max(0.0, now_s - self._sample_s)
        limit_m, limit_rad = (
            self.JUMP + 3.0 * profile.speed_per_s * passed_s
            for profile in (self._settings.straight, self._settings.turn)
        )
        if (
            math.hypot(sample.x_m - self._last.x_m, sample.y_m - self._last.y_m) > limit_m
            or abs(wrap(sample.yaw_rad - self._last.yaw_rad)) > limit_rad
        ):
            self._fail("odometry has jumped, so the distance is unknown")
            return
        self._elapsed_s += passed_s
        self._turned_rad += wrap(sample.yaw_rad - self._last.yaw_rad)
        self._last = sample
        self._sample_s = now_s
        self._is_new = True

    def step(self, *, now_s: float) -> MotionStep:
        """Return what the base must do now."""
        if self._state in (MotionState.MOVING, MotionState.SETTLING):
            self._check(now_s)
        if self._state is MotionState.MOVING:
            self._move()
        elif self._state is MotionState.SETTLING:
            self._settle()
        if self._state is not MotionState.MOVING:
            self._speed_per_s = 0.0
            return MotionStep(command=STANDING, state=self._state, reason=self._reason)
        if now_s - self._sample_s > self._settings.odometry_timeout_s / 3.0:
            # Without odometry the base waits; after the whole timeout the motion fails.
            self._speed_per_s = 0.0
            return MotionStep(command=STANDING, state=self._state)
        return MotionStep(command=self._command(), state=self._state)

    def _fail(self, reason: str) -> None:
        self._state = MotionState.FAILED
        self._reason = reason

    def _check(self, now_s: float) -> None:
        if now_s - self._sample_s > self._settings.odometry_timeout_s:
            self._fail("odometry is lost: no sample for %.1f s" % (now_s - self._sample_s))
            return
        if now_s > self._end_s:
            self._fail(f"out of time after {self._describe(self.progress)} of {describe_amount(self._goal)}")
            return
        progress = self.progress
        if abs(progress - self._stall_progress) >= self._profile.tolerance or self._state is MotionState.SETTLING:
            self._stall_begin_s, self._stall_progress = now_s, progress
        elif now_s - self._stall_begin_s > self._settings.stall_timeout_s:
            self._fail(
                f"the base does not move: odometry stands at {self._describe(progress)} "
                f"of {describe_amount(self._goal)}"
            )
            return
        # Twice the distance to the first braking is more than any start can slip back.
        slip = 2.0 * self._profile.speed_per_s**2 / self._profile.acceleration_per_s2
        if math.copysign(1.0, self._goal.amount) * progress < -slip:
            self._fail("the base moves the wrong way: odometry and velocity disagree about the sign")

    def _describe(self, amount: float) -> str:
        return describe_amount(MotionGoal(kind=self._goal.kind, amount=amount))

    def _move(self) -> None:
        error = self._goal.amount - self.progress
        if abs(error) <= self._aim:
            self._begin_to_settle()
            return
        if not self._is_new:
            return
        self._is_new = False
        passed_s = self._elapsed_s - self._step_elapsed_s
        self._step_elapsed_s = self._elapsed_s
        profile = self._profile
        # Each correction is slower than the one before, so corrections converge even if odometry is late.
        gentleness = 0.5**self._corrections
        to_brake = max(0.0, abs(error) - abs(self._speed_per_s) * self.REACTION_S)
        fastest = gentleness * min(profile.speed_per_s, math.sqrt(2.0 * profile.acceleration_per_s2 * to_brake))
        wanted = math.copysign(max(profile.creep_per_s, fastest), error)
        if self._speed_per_s * wanted < 0.0:
            # Overshot: stand first, then come back.
            self._begin_to_settle()
            return
        faster = abs(self._speed_per_s) + profile.acceleration_per_s2 * passed_s
        self._speed_per_s = math.copysign(min(abs(wanted), max(profile.creep_per_s, faster)), error)

    def _begin_to_settle(self) -> None:
        self._state = MotionState.SETTLING
        self._stand_begin_s = self._elapsed_s
        self._stand_progress = self.progress

    def _settle(self) -> None:
        if self._elapsed_s - self._stand_begin_s < self.STAND_WINDOW_S:
            return
        if abs(self.progress - self._stand_progress) > self._profile.tolerance / 4.0:
            self._begin_to_settle()
            return
        error = self._goal.amount - self.progress
        if abs(error) <= self._aim:
            self._state = MotionState.ARRIVED
        elif self._corrections < self.MAX_CORRECTIONS:
            self._corrections += 1
            self._state = MotionState.MOVING
            self._is_new = True
            self._step_elapsed_s = self._elapsed_s
        elif abs(error) <= self._accept:
            self._state = MotionState.ARRIVED
        else:
            self._fail(f"the base gets no nearer than {self._describe(abs(error))} to {describe_amount(self._goal)}")

    def _command(self) -> MotionCommand:
        if self._goal.kind is MotionKind.TURN:
            return MotionCommand(angular_rad_per_s=self._speed_per_s)
        # Keep the path straight even if the wheels slip.
        rate = -self.HEADING_GAIN_PER_S * self._turned_rad
        limit = self.MAX_HEADING_RATE_RAD_PER_S
        return MotionCommand(linear_m_per_s=self._speed_per_s, angular_rad_per_s=max(-limit, min(limit, rate)))
