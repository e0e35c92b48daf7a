"""The nodes of a plan while they run: when each begins, how it ends, and which branch decides."""

import enum
from dataclasses import dataclass
from typing import Callable, List, Optional, Sequence, Tuple

from arbitrator.scopes import Cause, Clock, Scope

SUCCEEDED, ABORTED, PREEMPTED = OUTCOMES = ("succeeded", "aborted", "preempted")


class EndedBy(enum.Enum):
    """What ended a node."""

    WORK = "work"  # its children, or what it does itself
    CONDITION = "condition"
    TIME = "time"
    LIMIT = "limit"
    FAULT = "fault"  # nobody could tell whether its condition holds


@dataclass(frozen=True)
class NodeEvent:
    """A node has begun or ended.

    Attributes:
        number: of the node, as `arbitrator.plan.walk` counts from 0
        outcome: succeeded, aborted or preempted; empty when it has begun
        ended_by: of a node that has ended
        fault: why nobody could tell whether its condition holds
    """

    number: int
    outcome: str = ""
    ended_by: EndedBy = EndedBy.WORK
    fault: str = ""


Observe = Callable[[NodeEvent], None]


class Branches:
    """Parts that run at the same time, each in a scope and a thread of its own. One that decides ends the others."""

    def __init__(self, scope: Scope, ranks: Sequence[int], decide: Callable[[int, str], str]) -> None:
        """
        Args:
            scope: around all
            ranks: number of each part
            decide: gets the place and the outcome of a branch that has ended; returns the outcome of all, empty as long
                as it is open; not called again when it has said one
        """
        self.scopes = [Scope(scope.clock, scope) for _ in ranks]
        self._clock: Clock = scope.clock
        self._ranks = ranks
        self._decide = decide
        self._left = 0
        self.outcome = ""

    def start(self) -> bool:
        """Begin, maybe anew; returns whether the branches may."""
        self.outcome, self._left = "", len(self._ranks)
        begun = [scope.begin() for scope in self.scopes]
        if not all(begun):
            return False
        self._clock.fork(self._ranks)
        return True

    def run(self, place: int, body: Callable[[], Optional[str]]) -> Optional[str]:
        """Run a branch in the calling thread; returns what the body returned."""
        self._clock.begin(self._ranks[place])
        outcome: Optional[str] = None
        try:
            outcome = body()
            return outcome
        finally:
            self._end(place, outcome or ABORTED)

    def _end(self, place: int, outcome: str) -> None:
        ended: List[Scope] = []
        with self._clock.lock:
            self._left -= 1
            is_last = self._left == 0
            if not self.outcome:
                self.outcome = self._decide(place, outcome)
                ended = self.scopes if self.outcome else []
        for scope in ended:
            scope.cancel(Cause.ENOUGH)
        self._clock.end(is_last=is_last)


class NodeRun:
    """A node while it runs, once or several times."""

    def __init__(self, number: int, scope: Scope, observe: Observe) -> None:
        self.number = number
        self.scope = scope
        self._observe = observe
        self._ended_by, self._fault = EndedBy.WORK, ""
        self._cleanups: List[Callable[[], None]] = []
        #: The branch that the node is, and its place; None if it is none.
        self.branch: Optional[Tuple[Branches, int]] = None

    def on_end(self, cleanup: Callable[[], None]) -> None:
        """Call a function at each end."""
        self._cleanups.append(cleanup)

    def say(self, ended_by: EndedBy, *, fault: str = "") -> None:
        """Note what ends the node."""
        self._ended_by, self._fault = ended_by, fault

    def run(self, body: Callable[[], Optional[str]]) -> Optional[str]:
        """Run the node; returns its outcome.

        Args:
            body: does the work and returns its outcome; None when the program shuts down
        """
        if self.branch is None:
            return self._run(body)
        branches, place = self.branch
        return branches.run(place, lambda: self._run(body))

    def _run(self, body: Callable[[], Optional[str]]) -> Optional[str]:
        if not self.scope.begin():
            return PREEMPTED
        self._ended_by, self._fault = EndedBy.WORK, ""
        self._observe(NodeEvent(self.number))
        try:
            outcome = self._verdict(body())
        finally:
            for cleanup in self._cleanups:
                cleanup()
        if outcome is not None:
            self._observe(NodeEvent(self.number, outcome, self._ended_by, self._fault))
        return outcome

    def _verdict(self, outcome: Optional[str]) -> Optional[str]:
        # While a server ends its goal, nobody may have looked at the limits.
        self.scope.tick()
        with self.scope.clock.lock:
            is_late = self.scope.cause is Cause.LATE and not self.scope.is_cancelled_from_outside
        if outcome == PREEMPTED and is_late:
            self.say(EndedBy.LIMIT)
            return ABORTED
        return outcome
