"""What was stopped and is not done: it begins again when a person says "go on", and then yes."""

import time
from collections import OrderedDict
from dataclasses import dataclass, replace
from typing import Callable, Generic, List, Optional, Tuple, TypeVar

from command_server.open_commands import OWN_STAGE, Ending, Outcome
from command_server.taking_back import asks_to_go_on
from word_classes import agreement

Plan = TypeVar("Plan")

QUESTION = "CONFIRM"
DECLINED = "DECLINED"
#: How long the question waits for its answer, seconds.
_ANSWER_S = 60.0
_MOST_KEPT = 20
_MOST_CANCELLED = 1000


@dataclass(frozen=True)
class Stopped(Generic[Plan]):
    """What is left of a command.

    Attributes:
        command_id: of the command
        stamp_ns: when it was said, nanoseconds of ROS time
        plan: what was not done
        said: its clauses, as they were said
        heard_ns: when it was told, nanoseconds of ROS time
    """

    command_id: str
    stamp_ns: int
    plan: Plan
    said: str
    heard_ns: int


class GoingOn(Generic[Plan]):
    """The plans that a stop has ended, and the question whether to go on. One thread owns it."""

    def __init__(self, *, now: Callable[[], float] = time.monotonic) -> None:
        """
        Args:
            now: monotonic clock, seconds
        """
        self._now = now
        self._stopped: List[Stopped[Plan]] = []
        self._cancelled: OrderedDict[str, None] = OrderedDict()
        self._asked: Tuple[Stopped[Plan], ...] = ()
        self._asked_s = 0.0

    def hear_stopped(self, stopped: Stopped[Plan]) -> None:
        """A plan was ended before it was done. What had been ended before it was said is forgotten."""
        kept = [one for one in self._stopped if one.heard_ns > stopped.stamp_ns]
        self._stopped = sorted([*kept, stopped], key=lambda one: one.stamp_ns)[-_MOST_KEPT:]

    def hear_cancelled(self, command_id: str) -> None:
        """A person has cancelled or forbidden a command: it is no command that a stop has interrupted."""
        self._cancelled[command_id] = None
        while len(self._cancelled) > _MOST_CANCELLED:
            self._cancelled.popitem(last=False)

    def asked(self, ending: Ending, *, stop_stamp_ns: int) -> Ending:
        """Return the ending of a "go on": with the question, if something was stopped.

        Args:
            ending: of any command
            stop_stamp_ns: stamp of the last stop, nanoseconds of ROS time
        """
        if not asks_to_go_on(ending.command.text):
            return ending
        meant = tuple(
            one for one in self._stopped if one.command_id not in self._cancelled and one.stamp_ns <= stop_stamp_ns
        )
        if not meant:
            return ending
        self._asked, self._asked_s = meant, self._now()
        question = f"Shall I go on with {', and then with '.join(one.said for one in meant)}?"
        # Standing orders go on without a question.
        said = f"{ending.sentence} {question}" if ending.outcome is Outcome.DONE else question
        return replace(ending, outcome=Outcome.NEEDS_INFORMATION, stage=OWN_STAGE, code=QUESTION, sentence=said)

    def answered(self, text: str) -> Optional[Tuple[Plan, ...]]:
        """Something was said; it may answer the question, which is over in any case.

        Returns:
            what is to be done now, in this order; nothing at all after a no; None if it is no answer
        """
        asked, self._asked = self._asked, ()
        if not asked or self._now() - self._asked_s > _ANSWER_S:
            return None
        is_yes = agreement(text)
        if is_yes is None:
            return None
        self._stopped = []
        return tuple(one.plan for one in asked) if is_yes else ()
