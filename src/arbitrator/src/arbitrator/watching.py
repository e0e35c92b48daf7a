"""Conditions while they are watched: what their sources said, and whether they count."""

import threading
from dataclasses import dataclass
from typing import Callable, Iterator, List, Optional

from arbitrator.plan import AllOf, AnyCondition, Condition, Trigger


@dataclass(frozen=True)
class Observation:
    """What the source of a condition says.

    Attributes:
        holds: whether the condition holds; negation is not its business
        fault: why nobody can tell any more; empty while somebody can
    """

    holds: bool = False
    fault: str = ""


#: Starts to watch a condition; the function that it returns ends that. Each observation is told, from any thread.
Watch = Callable[[Condition, Callable[[Observation], None]], Callable[[], None]]


def watch_nothing(condition: Condition, on_observation: Callable[[Observation], None]) -> Callable[[], None]:
    """Watch for those who have no sources: nobody can tell."""
    on_observation(Observation(fault="nobody watches that"))
    return lambda: None


class Watching:
    """One condition, or several together, from `open` to `close`.

    A condition that held for a moment counts, also when nobody looked at that moment.
    """

    def __init__(self, condition: AnyCondition, watch: Watch, *, on_change: Callable[[], None]) -> None:
        """
        Args:
            condition: what is watched
            watch: starts to watch one condition
            on_change: called after each observation, from any thread
        """
        self.condition = condition
        self._watch = watch
        self._on_change = on_change
        self._lock = threading.Lock()
        self._leaves = list(_leaves(condition))
        self._forget()

    def _forget(self) -> None:
        self._closers: List[Callable[[], None]] = []
        self._values: List[Optional[bool]] = [None] * len(self._leaves)
        self._was_false = self._was_true = self._has_begun = False
        self._fault = ""
        self._round: object = object()

    def open(self) -> None:
        """Begin to watch, maybe anew."""
        with self._lock:
            self._forget()
            this_round = self._round
        for place, leaf in enumerate(self._leaves):
            self._closers.append(self._watch(leaf, self._hearer(place, this_round)))

    def close(self) -> None:
        """End."""
        with self._lock:
            self._round = None
            closers, self._closers = self._closers, []
        for closer in closers:
            closer()

    @property
    def fault(self) -> str:
        """Why nobody can tell any more; empty while somebody can."""
        return self._fault

    @property
    def is_known(self) -> bool:
        """Whether the first answer has come."""
        return self._was_true or self._was_false

    @property
    def holds(self) -> Optional[bool]:
        """Whether it holds now; None while nobody has said so."""
        with self._lock:
            return _truth(self.condition, iter(self._values))

    @property
    def has_triggered(self) -> bool:
        """Whether it counts, as its trigger says."""
        return self._was_true if self.condition.trigger is Trigger.HOLDS else self._has_begun

    @property
    def has_ended(self) -> bool:
        """Whether it has been observed not to hold."""
        return self._was_false

    def _hearer(self, place: int, of_round: object) -> Callable[[Observation], None]:
        return lambda observation: self._hear(place, observation, of_round)

    def _hear(self, place: int, observation: Observation, of_round: object) -> None:
        with self._lock:
            if of_round is not self._round or self._fault:
                return
            if observation.fault:
                self._fault = observation.fault
            else:
                self._values[place] = observation.holds
                holds = _truth(self.condition, iter(self._values))
                self._has_begun |= holds is True and self._was_false
                self._was_true |= holds is True
                self._was_false |= holds is False
        self._on_change()


def _leaves(condition: AnyCondition) -> List[Condition]:
    if isinstance(condition, Condition):
        return [condition]
    return [leaf for child in condition.children for leaf in _leaves(child)]


def _truth(condition: AnyCondition, values: Iterator[Optional[bool]]) -> Optional[bool]:
    """Return whether a condition holds; None when that depends on what nobody has said.

    Args:
        condition: one or several
        values: an iterator over the values of its leaves, in their order; consumed
    """
    if isinstance(condition, Condition):
        holds = next(values)
    else:
        of_children = [_truth(child, values) for child in condition.children]
        decisive = not isinstance(condition, AllOf)
        if decisive in of_children:
            holds = decisive
        else:
            holds = None if None in of_children else not decisive
    return None if holds is None else holds is not condition.is_negated
