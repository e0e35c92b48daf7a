"""What is left of a plan that was stopped: what was done is not done again."""

import threading
import time
from dataclasses import dataclass, replace
from typing import Callable, Dict, List, Optional, Tuple, Union, cast

from arbitrator.node_runs import ABORTED, SUCCEEDED, NodeEvent
from arbitrator.plan import (
    Do,
    Fallback,
    If,
    InAnyOrder,
    InParallel,
    InSequence,
    Limit,
    Part,
    Plan,
    Repeat,
    Until,
    Wait,
    While,
    parts_of,
    walk,
)
from roboframenet_ros.spoken_text import join_with_and

#: What had less time left than this is over, seconds: nobody could tell the difference.
_LEAST_S = 0.1
#: A limit that was nearly reached leaves this much time, seconds.
_LEAST_LIMIT_S = 1.0


@dataclass
class _State:
    """What became of a node since the node around it began the last time."""

    begun_s: Optional[float] = None
    ended_s: Optional[float] = None
    outcome: str = ""
    done: int = 0


@dataclass(frozen=True)
class Rest:
    """What is left.

    Attributes:
        plan: what was not done
        said: its clauses, in the words of the person; a clause that was interrupted and has an amount is done again as
            a whole, and these words say so
    """

    plan: Plan
    said: str


class Progress:
    """How far a plan has come; any thread may call."""

    def __init__(self, plan: Plan, *, now: Callable[[], float] = time.monotonic) -> None:
        """
        Args:
            plan: what is carried out
            now: clock by which the plan runs, seconds
        """
        self._now = now
        self._lock = threading.Lock()
        self._parts: Tuple[Part, ...] = tuple(walk(plan))
        self._states = [_State() for _ in self._parts]

    def hear(self, event: NodeEvent) -> None:
        """A node has begun or ended."""
        with self._lock:
            state = self._states[event.number]
            if event.outcome:
                state.outcome, state.ended_s = event.outcome, self._now()
                state.done += event.outcome == SUCCEEDED
                return
            state.begun_s, state.ended_s, state.outcome = self._now(), None, ""
            size = sum(1 for _ in walk(self._parts[event.number]))
            for number in range(event.number + 1, event.number + size):
                self._states[number] = _State()

    def rest(self) -> Optional[Rest]:
        """Return what is left to do; None for nothing."""
        with self._lock:
            left = self._left(0)
            if left is None:
                return None
            words = said(left)
            for number, part in enumerate(self._parts):
                if self._is_interrupted(number) and _has_amount(part):
                    words = words.replace(said(part), f"{said(part)} from its beginning", 1)
            return Rest(left, words)

    def _is_interrupted(self, number: int) -> bool:
        state = self._states[number]
        return isinstance(self._parts[number], Do) and state.begun_s is not None and state.outcome != SUCCEEDED

    def _children(self, number: int) -> Dict[int, Part]:
        found: Dict[int, Part] = {}
        number += 1
        for child in parts_of(self._parts[number - 1]):
            found[number] = child
            number += sum(1 for _ in walk(child))
        return found

    def _left(self, number: int) -> Optional[Plan]:
        """Return what is left of a node that has not succeeded."""
        part, state = self._parts[number], self._states[number]
        if state.begun_s is None:
            return cast(Plan, part)  # Nobody asks for what is left of a condition.
        if state.outcome == SUCCEEDED:
            return None
        left = self._rest_of(part, number)
        limit = cast(Plan, part).limit
        if left is None or not limit.seconds:
            return left
        limit = Limit(max(limit.seconds - self._took_s(number), _LEAST_LIMIT_S), limit.is_said)
        return replace(left, limit=limit) if type(left) is type(part) else InSequence(part.label, (left,), limit)

    def _took_s(self, number: int) -> float:
        state = self._states[number]
        ended_s = self._now() if state.ended_s is None else state.ended_s
        return ended_s - (ended_s if state.begun_s is None else state.begun_s)

    def _rest_of(self, part: Part, number: int) -> Optional[Plan]:
        numbers = list(self._children(number))
        if isinstance(part, (InSequence, InAnyOrder)):
            order = part.order() if isinstance(part, InAnyOrder) else range(len(numbers))
            children = [self._left(numbers[place]) for place in order]
            return _joined(part, [child for child in children if child is not None])
        if isinstance(part, Fallback):
            open_ones = [one for one in numbers if self._states[one].outcome != ABORTED]
            return _joined(part, [child for child in map(self._left, open_ones) if child is not None])
        if isinstance(part, InParallel):
            left = [child for child in map(self._left, numbers) if child is not None]
            count = part.count and max(1, part.count - (len(numbers) - len(left)))
            return replace(part, children=tuple(left), count=count) if left else None
        if isinstance(part, If):
            chosen = next((one for one in numbers[1:] if self._states[one].begun_s is not None), None)
            return part if chosen is None else self._left(chosen)
        if isinstance(part, (Until, While)):
            return self._rest_of_work(part, number, numbers[-1])
        if isinstance(part, Repeat):
            return self._rest_of_rounds(part, numbers[0])
        if isinstance(part, Wait) and part.condition is None:
            left_s = part.duration_s - self._took_s(number)
            return replace(part, duration_s=left_s) if left_s > _LEAST_S else None
        return cast(Plan, part)

    def _rest_of_work(self, part: Union[Until, While], number: int, child_number: int) -> Optional[Plan]:
        child = self._left(child_number)
        if child is None:
            return None
        if isinstance(part, Until) and part.condition is None:
            left_s = part.duration_s - self._took_s(number)
            return replace(part, child=child, duration_s=left_s) if left_s > _LEAST_S else None
        return replace(part, child=child)

    def _rest_of_rounds(self, part: Repeat, child_number: int) -> Optional[Plan]:
        state, child = self._states[child_number], None
        # Between two rounds the one before has succeeded, and the next one is whole.
        is_within = state.begun_s is not None and state.outcome != SUCCEEDED
        if is_within:
            child = self._left(child_number)
        left = part.times - state.done - is_within
        following: Optional[Plan] = part
        if part.times:
            following = _rounds(part, left) if left > 0 else None
        if child is None:
            return following
        if following is None:
            return child
        if child == part.child:
            return _rounds(part, left + 1)
        return InSequence(part.label, (child, following))


def _joined(part: Union[InSequence, InAnyOrder, Fallback], children: List[Plan]) -> Optional[Plan]:
    """Return what is left of one thing after the other."""
    if not children:
        return None
    if len(children) == 1 and not part.limit.seconds:
        return children[0]
    kind = Fallback if isinstance(part, Fallback) else InSequence
    return kind(part.label, tuple(children), part.limit)


def _rounds(part: Repeat, left: int) -> Repeat:
    """Return a repetition with some rounds left."""
    return replace(part, count=left, most=left) if part.times else part


def _has_amount(part: Part) -> bool:
    return isinstance(part, Do) and any(
        argument.measure is not None
        for candidate in part.candidates
        for frame in candidate.frames
        for argument in frame.arguments
    )


def said(plan: Part) -> str:
    """Return the clauses of a plan as they were said: '"say hello" and "turn left" 2 times'."""
    if isinstance(plan, (Do, Wait, If, Until, While)):
        return f'"{plan.label.strip(" .!?,")}"'
    if isinstance(plan, Repeat):
        return f"{said(plan.child)} {plan.times} times" if plan.times > 1 else said(plan.child)
    words = list(dict.fromkeys(said(child) for child in parts_of(plan)))
    if isinstance(plan, Fallback):
        return " or else ".join(words)
    return join_with_and(words)
