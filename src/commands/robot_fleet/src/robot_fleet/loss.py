"""What a robot does when it no longer hears the language service."""

import enum
from dataclasses import dataclass, replace
from typing import Tuple


class Policy(enum.Enum):
    """What a robot does that no longer hears the language service."""

    FINISH = "finish"
    STOP = "stop"
    GO_HOME = "go_home"


class Act(enum.Enum):
    """What is to be done now."""

    STOP = "stop"
    GO_HOME = "go home"
    TELL_LOSS = "tell of the loss"
    TELL_RETURN = "tell of the return"


@dataclass(frozen=True)
class Hearing:
    """Whether a robot hears the language service.

    Attributes:
        heard_s: when it was last heard, monotonic seconds; the start before the first time
        has_met: it was heard at all; before that nothing is lost
        is_lost: it has been silent for too long
    """

    heard_s: float
    has_met: bool = False
    is_lost: bool = False

    def hear(self, now_s: float) -> Tuple["Hearing", Tuple[Act, ...]]:
        """The service is heard."""
        return Hearing(now_s, has_met=True), (Act.TELL_RETURN,) if self.is_lost else ()

    def turn(self, now_s: float, *, silence_s: float, policy: Policy) -> Tuple["Hearing", Tuple[Act, ...]]:
        """Time passes.

        Args:
            now_s: monotonic seconds
            silence_s: after this time without the service it is lost
            policy: of the robot
        """
        if not self.has_met or self.is_lost or now_s - self.heard_s <= silence_s:
            return self, ()
        acts = {Policy.FINISH: (), Policy.STOP: (Act.STOP,), Policy.GO_HOME: (Act.STOP, Act.GO_HOME)}[policy]
        return replace(self, is_lost=True), (Act.TELL_LOSS, *acts)
