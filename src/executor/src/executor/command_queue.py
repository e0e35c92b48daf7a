"""Which command runs: the newest one wins, and a stop ends what was said before it.

A queue is a value; each function returns the next queue, and the actions to take in order.
"""

import enum
from collections import OrderedDict
from dataclasses import dataclass, replace
from typing import Callable, Generic, Optional, Tuple, TypeVar

Job = TypeVar("Job")

# How many commands that have not arrived yet may be cancelled.
_MOST_CANCELLED = 1000
# A stamp that is further in the future is from before the clock was set back, as simulators do.
_CLOCK_RESET_NS = 1_000_000_000


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
        begins_when_free: whether it begins only if nothing runs or waits; any other command takes its place
    """

    key: CommandKey
    job: Job
    begins_when_free: bool = False


class Cause(enum.Enum):
    """Why a command is not completed."""

    NEW_COMMAND = "NEW_COMMAND"
    STOPPED = "STOPPED"
    NOT_FREE = "NOT_FREE"


@dataclass(frozen=True)
class Start(Generic[Job]):
    """Start this order."""

    order: Order[Job]


@dataclass(frozen=True)
class Preempt(Generic[Job]):
    """Preempt the running order; `finish` must follow."""

    order: Order[Job]
    cause: Cause


@dataclass(frozen=True)
class Supersede(Generic[Job]):
    """Reply to an order that was never started."""

    order: Order[Job]
    cause: Cause


@dataclass(frozen=True)
class CommandQueue(Generic[Job]):
    """The commands of the executor.

    Attributes:
        running: the order that runs, also while it is being preempted
        cause: why it is being preempted, None while it is not
        waiting: the order that starts when the running one has ended
        stop_stamp_ns: commands said at or before it must not run; None before the first stop
        cancelled_ids: commands that were cancelled by name and may still arrive
    """

    running: Optional[Order[Job]] = None
    cause: Optional[Cause] = None
    waiting: Optional[Order[Job]] = None
    stop_stamp_ns: Optional[int] = None
    cancelled_ids: Tuple[str, ...] = ()


#: The next queue, and the actions to take.
Step = Tuple[CommandQueue[Job], Tuple[object, ...]]


def submit(queue: CommandQueue[Job], order: Order[Job], *, now_ns: int) -> Step[Job]:
    """A plan arrived.

    Args:
        queue: as it is
        order: the plan and its command
        now_ns: ROS time; earlier than the last stop means that the clock was set back, as simulators do
    """
    if queue.stop_stamp_ns is not None and now_ns < queue.stop_stamp_ns:
        queue = replace(queue, stop_stamp_ns=None)
    key = order.key
    if key.command_id in queue.cancelled_ids or (
        queue.stop_stamp_ns is not None and key.stamp_ns <= queue.stop_stamp_ns
    ):
        return queue, (Supersede(order, Cause.STOPPED),)
    newest = queue.waiting or queue.running
    if newest is None:
        return replace(queue, running=order, cause=None), (Start(order),)
    if order.begins_when_free:
        return queue, (Supersede(order, Cause.NOT_FREE),)
    is_older = key.stamp_ns < newest.key.stamp_ns and not _is_of_old_clock(newest.key, now_ns)
    if is_older and not newest.begins_when_free:
        return queue, (Supersede(order, Cause.NEW_COMMAND),)
    actions: Tuple[object, ...] = ()
    if queue.waiting is not None:
        actions += (Supersede(queue.waiting, Cause.NEW_COMMAND),)
    if queue.running is not None and queue.cause is None:
        actions += (Preempt(queue.running, Cause.NEW_COMMAND),)
        queue = replace(queue, cause=Cause.NEW_COMMAND)
    return replace(queue, waiting=order), actions


def finish(queue: CommandQueue[Job]) -> Step[Job]:
    """The running order has ended, by itself or because it was preempted."""
    if queue.waiting is None:
        return replace(queue, running=None, cause=None), ()
    return replace(queue, running=queue.waiting, waiting=None, cause=None), (Start(queue.waiting),)


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
    actions: Tuple[object, ...] = ()
    if queue.waiting is not None and is_meant(queue.waiting.key):
        actions += (Supersede(queue.waiting, Cause.STOPPED),)
        queue = replace(queue, waiting=None)
    if queue.running is not None and queue.cause is not Cause.STOPPED and is_meant(queue.running.key):
        # An order that is being preempted for a newer one needs no second request; it ends as stopped now.
        if queue.cause is None:
            actions += (Preempt(queue.running, Cause.STOPPED),)
        queue = replace(queue, cause=Cause.STOPPED)
    return queue, actions
