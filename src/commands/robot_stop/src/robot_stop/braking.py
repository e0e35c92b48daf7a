"""Stops in progress: which nodes and servers do not obey, and for how long zero velocity is repeated.

Nothing here waits or publishes. The caller passes in what it observes and acts on the result.
"""

import time
from dataclasses import dataclass
from typing import Callable, FrozenSet, List, Optional, Tuple

from roboframenet_ros.spoken_text import join_with_and
from robot_stop.servers import Server, shown_names

#: A goal that was stamped so soon after a stop may belong to a command from before it; the executor sends none so soon.
RACE_NS = 50_000_000
#: The clock was set back, as simulators do, if it shows a time that is so much earlier than the stop.
SET_BACK_NS = 200_000_000
#: While an emergency stop holds, a node drives for this long after its last velocity, seconds.
HELD_QUIET_S = 1.0


@dataclass(frozen=True)
class BrakeLimits:
    """Times of a stop, seconds.

    Attributes:
        settle_s: time before the first finding, so that messages sent before the stop have arrived
        wake_settle_s: the same after the process was suspended
        quiet_s: a node that has published no velocity for this long, or for two of its periods, does not drive
        longest_quiet_s: upper bound on those two periods
        confirmation_s: time after which the nodes and servers that do not obey are named
        least_s: shortest time for which zero velocity is repeated
        most_s: longest time, while a node or server does not obey
    """

    settle_s: float = 0.1
    wake_settle_s: float = 0.5
    quiet_s: float = 0.3
    longest_quiet_s: float = 0.9
    confirmation_s: float = 1.0
    least_s: float = 1.0
    most_s: float = 10.0


@dataclass(frozen=True)
class StopOrder:
    """A stop.

    Attributes:
        key: the caller's name for it
        stamp_ns: when it was said, nanoseconds of ROS time
        is_for_frames_only: whether goals of ordinary clients are left alone
        except_server: name of a server whose goals are left alone; empty for none
    """

    key: str
    stamp_ns: int
    is_for_frames_only: bool = False
    except_server: str = ""

    def covers(self, server: Server) -> bool:
        """Whether the stop cancels the goals of this server."""
        return server.name != self.except_server and (server.takes_frames or not self.is_for_frames_only)


@dataclass(frozen=True)
class VelocitySeen:
    """The last velocity that was not zero from one node on one topic.

    Attributes:
        node: the publisher
        topic: name of the topic
        heard_s: when it arrived, monotonic seconds
        period_s: time since the one before, seconds; None for the first
    """

    node: str
    topic: str
    heard_s: float
    period_s: Optional[float] = None


@dataclass(frozen=True)
class LiveGoal:
    """A goal that had not ended in the last status message of its server."""

    server: Server
    goal_id: str
    stamp_ns: int


@dataclass(frozen=True)
class Evidence:
    """What is observed of the robot.

    Attributes:
        velocities: of all nodes except those that brake
        goals: of the connected servers
        is_complete: whether the graph of nodes has been read
    """

    velocities: Tuple[VelocitySeen, ...] = ()
    goals: Tuple[LiveGoal, ...] = ()
    is_complete: bool = True


@dataclass(frozen=True)
class Obedience:
    """The nodes and servers that do not obey a stop.

    Attributes:
        drivers: nodes that publish velocities, each with its topic
        servers: names of the servers whose goals have not ended
        is_known: False when the graph of nodes could not be read
    """

    drivers: Tuple[Tuple[str, str], ...] = ()
    servers: Tuple[str, ...] = ()
    is_known: bool = True

    @property
    def is_complete(self) -> bool:
        """Whether every node and server obeys, and the graph could be read."""
        return self.is_known and not self.drivers and not self.servers

    @property
    def names(self) -> Tuple[str, ...]:
        """The nodes and servers that do not obey."""
        return tuple(sorted({node for node, _ in self.drivers} | set(self.servers)))

    def describe(self) -> str:
        """What each of them does against the stop, as a clause; empty when all obey."""
        clauses = [f"{node} publishes velocities on {topic}" for node, topic in self.drivers]
        if self.servers:
            verb = "has not ended its goal" if len(self.servers) == 1 else "have not ended their goals"
            clauses.append(f"{join_with_and(self.servers)} {verb}")
        if not self.is_known:
            clauses.append("the graph of nodes could not be read")
        return join_with_and(clauses)


@dataclass(frozen=True)
class Finding:
    """What one look found out about a stop.

    Attributes:
        order: the stop
        obedience: the nodes and servers that do not obey
        is_first: whether it answers the stop; later findings report a change
        is_last: whether zero velocity has ended
    """

    order: StopOrder
    obedience: Obedience
    is_first: bool
    is_last: bool


@dataclass
class _Active:
    order: StopOrder
    began_s: float
    settle_s: float
    old_ids: FrozenSet[str]
    told: Optional[Obedience] = None
    is_of_old_clock: bool = False


@dataclass(frozen=True)
class Look:
    """The result of one look: the findings to report, and the newest stop while it has to be repeated."""

    findings: Tuple[Finding, ...] = ()
    repeated: Optional[StopOrder] = None


class Braking:
    """The stops in progress. One thread owns it."""

    def __init__(self, limits: BrakeLimits, *, now: Callable[[], float] = time.monotonic) -> None:
        """Start without a stop.

        Args:
            limits: times of each stop
            now: monotonic clock, seconds
        """
        self._limits = limits
        self._now = now
        self._stops: List[_Active] = []

    @property
    def is_busy(self) -> bool:
        """Whether the caller must call `look` again."""
        return bool(self._stops)

    def begin(self, order: StopOrder, evidence: Evidence, *, is_just_awake: bool = False) -> None:
        """Note that a stop was just carried out for the first time.

        Args:
            order: the stop
            evidence: from before the stop; the goals in it are those that must end
            is_just_awake: whether the process was suspended, so that older messages may still arrive
        """
        self._stops.append(
            _Active(
                order=order,
                began_s=self._now(),
                settle_s=self._limits.wake_settle_s if is_just_awake else self._limits.settle_s,
                old_ids=frozenset(goal.goal_id for goal in evidence.goals),
            )
        )

    def release(self, key: str) -> None:
        """Drop a stop that another node carries out."""
        self._stops = [stop for stop in self._stops if stop.order.key != key]

    def look(self, evidence: Evidence, *, now_ns: int) -> Look:
        """Judge the stops by the present evidence.

        Args:
            evidence: what is observed now
            now_ns: nanoseconds of ROS time
        """
        findings: List[Finding] = []
        kept: List[_Active] = []
        repeated: Optional[StopOrder] = None
        for index, stop in enumerate(self._stops):
            is_newest = index == len(self._stops) - 1
            stop.is_of_old_clock = stop.is_of_old_clock or was_set_back(stop.order, now_ns)
            obedience = self._obedience(stop, evidence)
            is_repeated = is_newest and self._is_to_repeat(stop, obedience, evidence)
            is_first = stop.told is None
            if self._is_to_tell(stop, obedience, is_newest=is_newest, is_over=not is_repeated):
                findings.append(Finding(stop.order, obedience, is_first=is_first, is_last=not is_repeated))
                stop.told = obedience
            if is_repeated:
                repeated = stop.order
            if is_repeated or stop.told is None:
                kept.append(stop)
        self._stops = kept
        return Look(findings=tuple(findings), repeated=repeated)

    def _is_to_tell(self, stop: _Active, obedience: Obedience, *, is_newest: bool, is_over: bool) -> bool:
        age_s = self._now() - stop.began_s
        if stop.told is None:
            return age_s >= self._limits.confirmation_s or (obedience.is_complete and age_s >= stop.settle_s)
        return is_newest and (obedience != stop.told or (is_over and not obedience.is_complete))

    def _is_to_repeat(self, stop: _Active, obedience: Obedience, evidence: Evidence) -> bool:
        age_s = self._now() - stop.began_s
        if any(_is_new(goal, stop) for goal in evidence.goals):
            # A command that was given after the stop moves the robot now.
            return False
        return age_s < self._limits.least_s or (not obedience.is_complete and age_s < self._limits.most_s)

    def _obedience(self, stop: _Active, evidence: Evidence) -> Obedience:
        servers = shown_names(
            goal.server.name
            for goal in evidence.goals
            if stop.order.covers(goal.server)
            and (goal.goal_id in stop.old_ids or (goal.stamp_ns <= stop.order.stamp_ns and not _is_new(goal, stop)))
        )
        drivers = (
            ()
            if any(_is_new(goal, stop) for goal in evidence.goals)
            else tuple(
                sorted((velocity.node, velocity.topic) for velocity in evidence.velocities if self._drives(velocity))
            )
        )
        return Obedience(drivers=drivers, servers=tuple(sorted(servers)), is_known=evidence.is_complete)

    def _drives(self, velocity: VelocitySeen) -> bool:
        quiet_s = self._limits.quiet_s
        if velocity.period_s is not None:
            quiet_s = max(quiet_s, min(2.0 * velocity.period_s, self._limits.longest_quiet_s))
        return self._now() - velocity.heard_s < quiet_s


def _is_new(goal: LiveGoal, stop: _Active) -> bool:
    is_later = goal.stamp_ns > stop.order.stamp_ns + RACE_NS
    is_of_new_clock = stop.is_of_old_clock and goal.stamp_ns < stop.order.stamp_ns - SET_BACK_NS
    return goal.goal_id not in stop.old_ids and (is_later or is_of_new_clock)


def obedience_of_held(evidence: Evidence, *, now_s: float) -> Obedience:
    """Return who acts against an emergency stop: every goal and every velocity does.

    Args:
        evidence: what is observed now
        now_s: monotonic seconds
    """
    seen = {(one.node, one.topic) for one in evidence.velocities if now_s - one.heard_s < HELD_QUIET_S}
    servers = shown_names(goal.server.name for goal in evidence.goals)
    return Obedience(drivers=tuple(sorted(seen)), servers=tuple(sorted(servers)), is_known=evidence.is_complete)


def was_set_back(order: StopOrder, now_ns: int) -> bool:
    """Whether the clock was set back since a stop: what is said now has an earlier stamp, and is no older."""
    return now_ns < order.stamp_ns - SET_BACK_NS
