"""A standing order, and what is sent when it is due."""

from dataclasses import dataclass
from typing import Optional

from standing_orders.schedule import Schedule


@dataclass(frozen=True)
class StandingOrder:
    """What is to be done at a time, or whenever something happens.

    Attributes:
        order_id: unique
        text: as the person said it
        deed: what is to be done, in the words of the person: "go to the door"
        sentence: what the robot will do, as it said it
        plan: the plan message with its condition or time, serialized
        given_s: seconds since 1970
        schedule: None if it waits for a condition
        next_s: when it is due next, seconds since 1970; None if it waits for a condition
        is_suspended: by a stop
        count: how often it was begun
        begun: id of the command that carries it out; empty while none does
    """

    order_id: str
    text: str
    deed: str
    sentence: str
    plan: bytes
    given_s: float
    schedule: Optional[Schedule] = None
    next_s: Optional[float] = None
    is_suspended: bool = False
    count: int = 0
    begun: str = ""


@dataclass(frozen=True)
class Firing:
    """An order that is due.

    Attributes:
        command_id: of the command that carries it out
        order: as it was when it became due
        not_done: why it is not done, a clause: "I was off"; empty if it is to be done
    """

    command_id: str
    order: StandingOrder
    not_done: str = ""
