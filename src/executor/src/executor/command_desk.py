"""Which command runs: the newest one wins, and a stop ends what was said before it.

A desk is a value; each function gives the next desk and what is to be done, in order.
"""

import enum
from collections import OrderedDict
from dataclasses import dataclass, replace
from typing import Callable, Generic, Optional, Tuple, TypeVar

Job = TypeVar("Job")

# Commands that were cancelled before they came.
_MOST_CANCELLED = 1000


@dataclass(frozen=True)
class CommandKey:
    """What the desk must know of a command: its id, and when it was said in nanoseconds of ROS time."""

    command_id: str
    stamp_ns: int


@dataclass(frozen=True)
class Order(Generic[Job]):
    """A command and what the shell needs to carry it out."""

    key: CommandKey
    job: Job


class Cause(enum.Enum):
    """Why a command is not carried out to its end."""

    NEW_COMMAND = "NEW_COMMAND"
    STOPPED = "STOPPED"


@dataclass(frozen=True)
class Start(Generic[Job]):
    """Begin to carry this order out."""

    order: Order[Job]


@dataclass(frozen=True)
class Preempt(Generic[Job]):
    """Ask the running order to end; `command_ended` must follow."""

    order: Order[Job]
    cause: Cause


@dataclass(frozen=True)
class Supersede(Generic[Job]):
    """Answer an order that never began."""

    order: Order[Job]
    cause: Cause


@dataclass(frozen=True)
class Desk(Generic[Job]):
    """The commands that the executor has.

    Attributes:
        running: the order that is carried out, also while it is being preempted
        cause: why it is being preempted, None while it is not
        waiting: the order that begins when the running one has ended
        stop_stamp_ns: commands said at or before it must not act; None before the first stop
        cancelled_ids: of commands that were cancelled one by one and may still come
    """

    running: Optional[Order[Job]] = None
    cause: Optional[Cause] = None
    waiting: Optional[Order[Job]] = None
    stop_stamp_ns: Optional[int] = None
    cancelled_ids: Tuple[str, ...] = ()


#: The next desk, and what is to be done.
Step = Tuple[Desk[Job], Tuple[object, ...]]


def order_arrives(desk: Desk[Job], order: Order[Job], *, now_ns: int) -> Step[Job]:
    """A plan came.

    Args:
        desk: the desk
        order: what came
        now_ns: ROS time; earlier than the last stop means that the clock was set back, as simulators do
    """
    if desk.stop_stamp_ns is not None and now_ns < desk.stop_stamp_ns:
        desk = replace(desk, stop_stamp_ns=None)
    key = order.key
    if key.command_id in desk.cancelled_ids or (desk.stop_stamp_ns is not None and key.stamp_ns <= desk.stop_stamp_ns):
        return desk, (Supersede(order, Cause.STOPPED),)
    newest = desk.waiting or desk.running
    if newest is None:
        return replace(desk, running=order, cause=None), (Start(order),)
    if key.stamp_ns < newest.key.stamp_ns:
        return desk, (Supersede(order, Cause.NEW_COMMAND),)
    actions: Tuple[object, ...] = ()
    if desk.waiting is not None:
        actions += (Supersede(desk.waiting, Cause.NEW_COMMAND),)
    if desk.running is not None and desk.cause is None:
        actions += (Preempt(desk.running, Cause.NEW_COMMAND),)
        desk = replace(desk, cause=Cause.NEW_COMMAND)
    return replace(desk, waiting=order), actions


def command_ended(desk: Desk[Job]) -> Step[Job]:
    """The running order has ended, by itself or because it was preempted."""
    if desk.waiting is None:
        return replace(desk, running=None, cause=None), ()
    return replace(desk, running=desk.waiting, waiting=None, cause=None), (Start(desk.waiting),)


def stop_heard(desk: Desk[Job], stop_stamp_ns: int) -> Step[Job]:
    """Somebody said stop."""
    if desk.stop_stamp_ns is None or stop_stamp_ns > desk.stop_stamp_ns:
        desk = replace(desk, stop_stamp_ns=stop_stamp_ns)
    return _end_some(desk, lambda key: key.stamp_ns <= stop_stamp_ns)


def command_cancelled(desk: Desk[Job], command_id: str) -> Step[Job]:
    """One command must not act any more, whether it runs, waits or is still to come."""
    # An ordered dict keeps the ids single and in their order, so that the oldest is forgotten first.
    ids = tuple(OrderedDict.fromkeys(desk.cancelled_ids + (command_id,)))[-_MOST_CANCELLED:]
    return _end_some(replace(desk, cancelled_ids=ids), lambda key: key.command_id == command_id)


def _end_some(desk: Desk[Job], is_meant: Callable[[CommandKey], bool]) -> Step[Job]:
    actions: Tuple[object, ...] = ()
    if desk.waiting is not None and is_meant(desk.waiting.key):
        actions += (Supersede(desk.waiting, Cause.STOPPED),)
        desk = replace(desk, waiting=None)
    if desk.running is not None and desk.cause is not Cause.STOPPED and is_meant(desk.running.key):
        # An order that is being preempted for a new one is asked already; it ends as stopped now.
        if desk.cause is None:
            actions += (Preempt(desk.running, Cause.STOPPED),)
        desk = replace(desk, cause=Cause.STOPPED)
    return desk, actions
