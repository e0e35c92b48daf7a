"""Which commands run: the newest one wins, unless it follows what runs or runs beside it; a stop ends what was said
before it.

A queue is a value; each function returns the next queue, and the actions to take in order.
"""

import enum
from collections import OrderedDict
from dataclasses import dataclass, replace
from typing import Callable, FrozenSet, Generic, List, Optional, Tuple, TypeVar

Job = TypeVar("Job")

# How many commands that have not arrived yet may be cancelled.
_MOST_CANCELLED = 1000
# A stamp that is further in the future is from before the clock was set back, as simulators do.
_CLOCK_RESET_NS = 1_000_000_000
# Each text has a later stamp than the one before: stamps go ahead of a clock that stands, by a nanosecond for each.
_AHEAD_OF_A_STANDING_CLOCK_NS = 1_000_000
#: How many commands may wait for the end of others, and how many may run at the same time.
MOST_WAITING = 20
MOST_RUNNING = 8


class Beginning(enum.IntEnum):
    """What happens to the command that runs; the numbers are those of the Plan message."""

    REPLACE = 0
    FOLLOW = 1
    BESIDE = 2
    WHEN_FREE = 3


@dataclass(frozen=True)
class CommandKey:
    """Identifies a command: its id, and when it was said in nanoseconds of ROS time."""

    command_id: str
    stamp_ns: int


@dataclass(frozen=True)
class Order(Generic[Job]):
    """A command, and what the node needs to carry it out.

    Attributes:
        key: of the command
        job: what the node needs
        beginning: when it begins
        resources: what its servers may occupy; None for everything
    """

    key: CommandKey
    job: Job
    beginning: Beginning = Beginning.REPLACE
    resources: Optional[FrozenSet[str]] = None

    def shared_with(self, other: "Order[Job]") -> Optional[FrozenSet[str]]:
        """Return what both occupy; None for everything, empty for nothing."""
        if self.resources is not None and other.resources is not None:
            return self.resources & other.resources
        # What occupies everything can still run beside what occupies nothing.
        known = self.resources if self.resources is not None else other.resources
        return frozenset() if known is not None and not known else known


class Cause(enum.Enum):
    """Why a command is not completed."""

    NEW_COMMAND = "NEW_COMMAND"
    STOPPED = "STOPPED"
    NOT_FREE = "NOT_FREE"
    NOT_BESIDE = "NOT_BESIDE"
    NOT_BEGUN = "NOT_BEGUN"
    TOO_MANY = "TOO_MANY"


@dataclass(frozen=True)
class Start(Generic[Job]):
    """Start this order."""

    order: Order[Job]


@dataclass(frozen=True)
class Preempt(Generic[Job]):
    """Preempt a running order; `finish` must follow."""

    order: Order[Job]
    cause: Cause


@dataclass(frozen=True)
class Supersede(Generic[Job]):
    """Reply to an order that was never started.

    Attributes:
        order: the order
        cause: why
        blocking: the order that it would have shared a resource with
    """

    order: Order[Job]
    cause: Cause
    blocking: Optional[Order[Job]] = None


@dataclass(frozen=True)
class Running(Generic[Job]):
    """An order that runs.

    Attributes:
        order: the order
        cause: why it is being preempted, None while it is not
    """

    order: Order[Job]
    cause: Optional[Cause] = None


@dataclass(frozen=True)
class CommandQueue(Generic[Job]):
    """The commands of the executor.

    Attributes:
        running: what runs, also while it is being preempted; what runs beside something stands behind it
        waiting: the orders that start one after the other when everything that runs has ended
        stop_stamp_ns: commands said at or before it must not run; None before the first stop
        cancelled_ids: commands that were cancelled by name and may still arrive
    """

    running: Tuple[Running[Job], ...] = ()
    waiting: Tuple[Order[Job], ...] = ()
    stop_stamp_ns: Optional[int] = None
    cancelled_ids: Tuple[str, ...] = ()

    def cause_of(self, command_id: str) -> Optional[Cause]:
        """Why a command is being preempted; None if it is not."""
        return next((one.cause for one in self.running if one.order.key.command_id == command_id), None)


#: Whoever brakes takes a goal for one from before a stop if it is stamped up to 50 ms later (``robot_stop.braking``).
PAUSE_AFTER_STOP_NS = 60_000_000

#: The next queue, and the actions to take.
Step = Tuple[CommandQueue[Job], Tuple[object, ...]]


@dataclass(frozen=True)
class AfterStop:
    """What a command that begins right after a stop heeds: its goals would be braked with what the stop has ended.

    Attributes:
        pause_s: how long it waits before its first goal, seconds
        stamp_ns: no goal of it is stamped earlier; the clock of a simulator may stand meanwhile
    """

    pause_s: float = 0.0
    stamp_ns: int = 0


def after_stop(queue: CommandQueue[Job], *, now_ns: int) -> AfterStop:
    """Return what a command that begins now heeds.

    Args:
        queue: as it is
        now_ns: ROS time
    """
    if queue.stop_stamp_ns is None:
        return AfterStop()
    earliest_ns = queue.stop_stamp_ns + PAUSE_AFTER_STOP_NS
    left_ns = earliest_ns - now_ns
    is_near = 0 < left_ns <= PAUSE_AFTER_STOP_NS + _AHEAD_OF_A_STANDING_CLOCK_NS
    return AfterStop(left_ns / 1e9, earliest_ns) if is_near else AfterStop()


def submit(queue: CommandQueue[Job], order: Order[Job], *, now_ns: int) -> Step[Job]:
    """A plan arrived.

    Args:
        queue: as it is
        order: the plan and its command
        now_ns: ROS time; earlier than the last stop means that the clock was set back, as simulators do
    """
    if queue.stop_stamp_ns is not None and now_ns < queue.stop_stamp_ns - _AHEAD_OF_A_STANDING_CLOCK_NS:
        queue = replace(queue, stop_stamp_ns=None)
    key = order.key
    if key.command_id in queue.cancelled_ids or (
        queue.stop_stamp_ns is not None and key.stamp_ns <= queue.stop_stamp_ns
    ):
        return queue, (Supersede(order, Cause.STOPPED),)
    known = [one.order for one in queue.running] + list(queue.waiting)
    if not known:
        return replace(queue, running=(Running(order),)), (Start(order),)
    if order.beginning is Beginning.WHEN_FREE:
        return queue, (Supersede(order, Cause.NOT_FREE),)
    # What begins when the robot is free is no command of a person, and gives way to each.
    newest_ns = max(
        (
            one.key.stamp_ns
            for one in known
            if one.beginning is not Beginning.WHEN_FREE and not _is_of_old_clock(one.key, now_ns)
        ),
        default=key.stamp_ns,
    )
    if key.stamp_ns < newest_ns:
        return queue, (Supersede(order, Cause.NEW_COMMAND),)
    if order.beginning is Beginning.FOLLOW:
        if len(queue.waiting) >= MOST_WAITING:
            return queue, (Supersede(order, Cause.TOO_MANY),)
        return replace(queue, waiting=(*queue.waiting, order)), ()
    if order.beginning is Beginning.BESIDE:
        return _beside(queue, order)
    superseded: List[object] = [Supersede(one, Cause.NEW_COMMAND) for one in queue.waiting]
    queue, preempted = _preempt(queue, lambda _: True, Cause.NEW_COMMAND)
    return replace(queue, waiting=(order,)), (*superseded, *preempted)


def _beside(queue: CommandQueue[Job], order: Order[Job]) -> Step[Job]:
    if len(queue.running) >= MOST_RUNNING:
        return queue, (Supersede(order, Cause.TOO_MANY),)
    for other in (*(one.order for one in queue.running), *queue.waiting):
        shared = other.shared_with(order)
        if shared is None or shared:
            return queue, (Supersede(order, Cause.NOT_BESIDE, other),)
    return replace(queue, running=(*queue.running, Running(order))), (Start(order),)


def finish(queue: CommandQueue[Job], command_id: str, *, is_done: bool = True) -> Step[Job]:
    """A running order has ended, by itself or because it was preempted.

    Args:
        queue: as it is
        command_id: of the order
        is_done: whether it succeeded; what was to follow something else does not begin
    """
    ended = [one for one in queue.running if one.order.key.command_id == command_id]
    queue = replace(queue, running=tuple(one for one in queue.running if one not in ended))
    actions: Tuple[object, ...] = ()
    if ended and not is_done and ended[0].cause is None:
        lost = [order for order in queue.waiting if order.beginning is Beginning.FOLLOW]
        actions = tuple(Supersede(order, Cause.NOT_BEGUN) for order in lost)
        queue = replace(queue, waiting=tuple(order for order in queue.waiting if order not in lost))
    if queue.running or not queue.waiting:
        return queue, actions
    following = queue.waiting[0]
    return replace(queue, running=(Running(following),), waiting=queue.waiting[1:]), (*actions, Start(following))


def stop(queue: CommandQueue[Job], stop_stamp_ns: int, *, now_ns: int) -> Step[Job]:
    """A stop was said: everything said at or before it ends, and must not start later.

    Args:
        queue: as it is
        stop_stamp_ns: when it was said, nanoseconds of ROS time
        now_ns: ROS time
    """
    if queue.stop_stamp_ns is None or stop_stamp_ns > queue.stop_stamp_ns:
        queue = replace(queue, stop_stamp_ns=stop_stamp_ns)
    return _end_some(queue, lambda key: key.stamp_ns <= stop_stamp_ns or _is_of_old_clock(key, now_ns))


def cancel(queue: CommandQueue[Job], command_id: str) -> Step[Job]:
    """Cancel one command, whether it runs, waits, or has not arrived yet."""
    # An ordered dict keeps each id once, in order: the oldest is dropped first.
    ids = tuple(OrderedDict.fromkeys(queue.cancelled_ids + (command_id,)))[-_MOST_CANCELLED:]
    return _end_some(replace(queue, cancelled_ids=ids), lambda key: key.command_id == command_id)


def _is_of_old_clock(key: CommandKey, now_ns: int) -> bool:
    """Whether a command was said before the clock was set back; it is older than whatever is said now."""
    return key.stamp_ns > now_ns + _CLOCK_RESET_NS


def _end_some(queue: CommandQueue[Job], is_meant: Callable[[CommandKey], bool]) -> Step[Job]:
    ended = [order for order in queue.waiting if is_meant(order.key)]
    queue = replace(queue, waiting=tuple(order for order in queue.waiting if order not in ended))
    queue, preempted = _preempt(queue, is_meant, Cause.STOPPED)
    return queue, (*(Supersede(order, Cause.STOPPED) for order in ended), *preempted)


def _preempt(queue: CommandQueue[Job], is_meant: Callable[[CommandKey], bool], cause: Cause) -> Step[Job]:
    """Preempt some of what runs. What is being preempted already gets no second request; a stop changes its cause."""
    actions: List[object] = []
    running: List[Running[Job]] = []
    for one in queue.running:
        if is_meant(one.order.key) and one.cause in (None, Cause.NEW_COMMAND) and one.cause is not cause:
            if one.cause is None:
                actions.append(Preempt(one.order, cause))
            one = replace(one, cause=cause)
        running.append(one)
    return replace(queue, running=tuple(running)), tuple(actions)
