"""What a robot in a home acts with, and how its actions end."""

import datetime
from typing import List, Optional, Protocol, Sequence, Tuple

from home_servers.memory import Known, Memory
from roboframenet_sim.home_actions import Action, Failure


class CannotDo(Exception):
    """The frame cannot be carried out; the message is a sentence for the person."""


class Interrupted(Exception):
    """The goal was preempted."""


class Body(Protocol):
    """What a robot in a home does and perceives; what it perceives goes to the memory."""

    memory: Memory

    def do(self, action: Action) -> Optional[Failure]:
        """Carry out an action to its end; return why it was not done.

        Raises:
            Interrupted: the goal was preempted
        """

    def say(self, text: str) -> List[Tuple[str, str]]:
        """Say something; return what persons answer: name and text."""

    def tell(self, told: Known) -> None:
        """Let others know what somebody has told the robot: what is not empty counts."""

    def show_doing(self, words: str) -> None:
        """Let persons see what the robot is doing: "going to the kitchen"; empty when it has ended."""

    def now_s(self) -> float:
        """The time, in seconds."""

    def clock(self) -> datetime.datetime:
        """The local time of day, as people tell it."""

    def held(self) -> Sequence[str]:
        """Ids of what the robot holds."""

    def place(self) -> Tuple[float, float]:
        """Where the robot is, in metres."""

    def room(self) -> str:
        """Id of the room where the robot is; empty outside."""
