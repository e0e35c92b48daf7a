"""Defines plans as values: a plan is a tree of clauses, each with its candidates, and of ways to join them."""

import enum
import math
from dataclasses import dataclass, fields, replace
from typing import Any, Callable, Dict, Iterator, Optional, Tuple, Type, Union

from typed_arguments import FilledFrame


@dataclass(frozen=True)
class Candidate:
    """One way to carry out a clause.

    Attributes:
        frames: to be carried out in this order, each by its server
        coverage: share of the content words of the clause that it accounts for, 0 to 1
        preference: tier: every candidate of 0, the likeliest reading of the clause, is tried before those of 1

    Raises:
        ValueError: no frame at all, which would succeed by doing nothing; a frame without a name or a server; coverage
            is not finite or not from 0 to 1; preference is negative
    """

    frames: Tuple[FilledFrame, ...]
    coverage: float = 1.0
    preference: int = 0

    def __post_init__(self) -> None:
        if not self.frames:
            raise ValueError("a candidate has no frames")
        for frame in self.frames:
            if not frame.name:
                raise ValueError("a frame has no name")
            if not frame.server:
                raise ValueError(f"frame {frame.name!r} names no action server")
        if not (math.isfinite(self.coverage) and 0.0 <= self.coverage <= 1.0):
            raise ValueError(f"coverage must be 0 to 1, got {self.coverage}")
        if self.preference < 0:
            raise ValueError(f"preference must be 0 or more, got {self.preference}")


@dataclass(frozen=True)
class Limit:
    """How long a part of a plan may take; it fails when it takes longer.

    Attributes:
        seconds: 0 for the limit of the executor
        is_said: whether the speaker said it: "for at most an hour"

    Raises:
        ValueError: negative or not finite
    """

    seconds: float = 0.0
    is_said: bool = False

    def __post_init__(self) -> None:
        if not 0.0 <= self.seconds < math.inf:
            raise ValueError(f"a limit must be finite and 0 s or more, got {self.seconds:g} s")


NO_LIMIT = Limit()


class Trigger(enum.IntEnum):
    """When a condition counts; the numbers are those of the PlanNode message."""

    HOLDS = 0  # it holds now, or begins to
    BEGINS = 1  # it does not hold, and then it does


@dataclass(frozen=True)
class Do:
    """Carry out one clause: the candidates, one after the other, until one succeeds.

    Attributes:
        label: the words of the clause
        candidates: at least one
        limit: of its time

    Raises:
        ValueError: no candidate at all
    """

    label: str
    candidates: Tuple[Candidate, ...]
    limit: Limit = NO_LIMIT

    def __post_init__(self) -> None:
        if not self.candidates:
            raise ValueError("a clause has no candidates")


@dataclass(frozen=True)
class _Joining:
    label: str
    children: Tuple["Plan", ...]

    def __post_init__(self) -> None:
        if not self.children:
            raise ValueError(f"{_NAMES[type(self)]} has no children")
        for child in self.children:
            _must_act(self, child)


@dataclass(frozen=True)
class InSequence(_Joining):
    """Carry out the children in this order, until one fails.

    Attributes:
        label: the words of all clauses
        children: at least one
        limit: of its time

    Raises:
        ValueError: no children at all, or one is a condition
    """

    limit: Limit = NO_LIMIT


@dataclass(frozen=True)
class Fallback(_Joining):
    """Carry out the children in this order, until one succeeds: "or else"."""

    limit: Limit = NO_LIMIT


@dataclass(frozen=True)
class InParallel(_Joining):
    """Carry out the children at the same time, until `count` of them have succeeded (0: all) or one has failed.

    The others are cancelled then.

    Raises:
        ValueError: no children at all, or one is a condition; `count` is not from 0 to their number
    """

    count: int = 0
    limit: Limit = NO_LIMIT

    def __post_init__(self) -> None:
        super().__post_init__()
        if not 0 <= self.count <= len(self.children):
            raise ValueError(f"{self.count} of {len(self.children)} children cannot succeed")


@dataclass(frozen=True)
class InAnyOrder(_Joining):
    """Carry out all children, each after those that it names, until one fails.

    Attributes:
        label: the words of all clauses
        children: at least one
        after: for each child, the positions of those that come before it; empty for none at all
        limit: of its time

    Raises:
        ValueError: no children at all, or one is a condition; no order fits `after`
    """

    after: Tuple[Tuple[int, ...], ...] = ()
    limit: Limit = NO_LIMIT

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.after and len(self.after) != len(self.children):
            raise ValueError(f"{len(self.after)} orders for {len(self.children)} children")
        self.order()

    def order(self) -> Tuple[int, ...]:
        """Return the positions of the children in the order in which they are carried out: as said, where that fits."""
        done: Dict[int, None] = {}
        while len(done) < len(self.children):
            ready = [
                position
                for position in range(len(self.children))
                if position not in done and (not self.after or all(before in done for before in self.after[position]))
            ]
            if not ready:
                raise ValueError("no order fits: each of some children is to come after another one of them")
            done[ready[0]] = None
        return tuple(done)


@dataclass(frozen=True)
class If:
    """Carry out a child if a condition holds now, and another one, if there is one, if it does not."""

    label: str
    condition: "AnyCondition"
    child: "Plan"
    otherwise: Optional["Plan"] = None
    limit: Limit = NO_LIMIT

    def __post_init__(self) -> None:
        _must_watch(self, self.condition, may_begin=False)
        _must_act(self, self.child)
        if self.otherwise is not None:
            _must_act(self, self.otherwise)


@dataclass(frozen=True)
class Until:
    """Carry out a child until a condition holds or a time is over, which is success: the child is cancelled.

    A child that ends before ends the node, with its own outcome.

    Attributes:
        label: the words of all clauses
        child: what is carried out
        condition: None for a time
        duration_s: None for a condition
        limit: of its time
    """

    label: str
    child: "Plan"
    condition: Optional["AnyCondition"] = None
    duration_s: float = 0.0
    limit: Limit = NO_LIMIT

    def __post_init__(self) -> None:
        _must_act(self, self.child)
        _one_end(self, self.condition, self.duration_s)


@dataclass(frozen=True)
class While:
    """Carry out a child as long as a condition holds. It is cancelled when the condition ends, which is success.

    A child that ends before ends the node, with its own outcome. If the condition does not hold, nothing is done.
    """

    label: str
    condition: "AnyCondition"
    child: "Plan"
    limit: Limit = NO_LIMIT

    def __post_init__(self) -> None:
        _must_watch(self, self.condition, may_begin=False)
        _must_act(self, self.child)


@dataclass(frozen=True)
class Repeat:
    """Carry out a child several times, until it fails.

    Attributes:
        label: the words of all clauses
        child: what is repeated
        count: least number of times
        most: largest number of times, 0 for no bound; the child is carried out `count` times, or `most` times if
            `count` is 0, or without an end if both are 0
        period_s: from one beginning to the next; 0: at once
        limit: of its time

    Raises:
        ValueError: the child is a condition; a negative number; `most` is less than `count`
    """

    label: str
    child: "Plan"
    count: int = 0
    most: int = 0
    period_s: float = 0.0
    limit: Limit = NO_LIMIT

    def __post_init__(self) -> None:
        _must_act(self, self.child)
        if self.count < 0 or self.most < 0 or (self.most and self.most < self.count):
            raise ValueError(f"{self.count} to {self.most} is no number of times")
        _duration(self.period_s)

    @property
    def times(self) -> int:
        """How often the child is carried out; 0 for no end."""
        return self.count or self.most


@dataclass(frozen=True)
class Wait:
    """Wait until a condition holds, or for a time."""

    label: str
    condition: Optional["AnyCondition"] = None
    duration_s: float = 0.0
    limit: Limit = NO_LIMIT

    def __post_init__(self) -> None:
        _one_end(self, self.condition, self.duration_s)


@dataclass(frozen=True)
class Condition:
    """A clause that says how things are.

    Attributes:
        label: the words of the clause
        candidates: at least one, of one frame each, whose server watches; the next one watches when one cannot
        trigger: when it counts
        is_negated: whether the opposite is meant

    Raises:
        ValueError: no candidate at all, or one with several frames
    """

    label: str
    candidates: Tuple[Candidate, ...]
    trigger: Trigger = Trigger.HOLDS
    is_negated: bool = False

    def __post_init__(self) -> None:
        if not self.candidates:
            raise ValueError("a condition has no candidates")
        if any(len(candidate.frames) != 1 for candidate in self.candidates):
            raise ValueError("a condition is one frame, and a candidate of it has several")


@dataclass(frozen=True)
class _Conditions:
    label: str
    children: Tuple["AnyCondition", ...]
    trigger: Trigger = Trigger.HOLDS
    is_negated: bool = False

    def __post_init__(self) -> None:
        if not self.children:
            raise ValueError(f"{_NAMES[type(self)]} has no children")
        for child in self.children:
            _must_watch(self, child, may_begin=False)


@dataclass(frozen=True)
class AllOf(_Conditions):
    """All these conditions hold."""


@dataclass(frozen=True)
class AnyOf(_Conditions):
    """At least one of these conditions holds."""


Plan = Union[Do, InSequence, Fallback, InParallel, InAnyOrder, If, Until, While, Repeat, Wait]
AnyCondition = Union[Condition, AllOf, AnyOf]
Part = Union[Plan, AnyCondition]

#: What is watched, and not done.
CONDITIONS = (Condition, AllOf, AnyOf)
_NAMES: Dict[Type[object], str] = {
    Do: "a clause",
    InSequence: "a sequence",
    Fallback: "a fallback",
    InParallel: "a parallel",
    InAnyOrder: "a set in any order",
    If: "an if",
    Until: "an until",
    While: "a while",
    Repeat: "a repetition",
    Wait: "a wait",
    Condition: "a condition",
    AllOf: "an all",
    AnyOf: "an any",
}


def _must_act(parent: object, child: object) -> None:
    if isinstance(child, CONDITIONS):
        raise ValueError(f"{_NAMES[type(parent)]} has the condition {child.label!r} in the place of something to do")


def _must_watch(parent: object, child: object, *, may_begin: bool) -> None:
    if not isinstance(child, CONDITIONS):
        raise ValueError(f"{_NAMES[type(parent)]} has {_NAMES[type(child)]} in the place of a condition")
    if child.trigger is Trigger.BEGINS and not may_begin:
        raise ValueError(f"{_NAMES[type(parent)]} asks whether {child.label!r} holds, and not when it begins to")


def _duration(seconds: float) -> None:
    if not 0.0 <= seconds < math.inf:
        raise ValueError(f"a time must be finite and 0 s or more, got {seconds:g} s")


def _one_end(parent: object, condition: object, duration_s: float) -> None:
    _duration(duration_s)
    if condition is not None:
        _must_watch(parent, condition, may_begin=True)
    if (condition is None) == (duration_s == 0.0):
        raise ValueError(f"{_NAMES[type(parent)]} ends with a condition or after a time: it needs one of both")


def parts_of(part: Part) -> Tuple[Part, ...]:
    """Return what a part of a plan is made of, conditions first."""
    if isinstance(part, (_Joining, _Conditions)):
        return part.children
    named = (getattr(part, name, None) for name in ("condition", "child", "otherwise"))
    return tuple(one for one in named if one is not None)


def walk(part: Part) -> Iterator[Part]:
    """Yield a plan and all its parts; each comes before its own parts."""
    yield part
    for child in parts_of(part):
        yield from walk(child)


def with_candidates(part: Any, change: Callable[[Tuple[Candidate, ...]], Tuple[Candidate, ...]]) -> Any:
    """Return a plan, or a part of it, with the candidates of each clause and condition changed by a function."""
    changed: Dict[str, object] = {}
    for field in fields(part):
        value = getattr(part, field.name)
        if field.name == "candidates":
            changed[field.name] = change(value)
        elif field.name == "children":
            changed[field.name] = tuple(with_candidates(child, change) for child in value)
        elif field.name in ("condition", "child", "otherwise") and value is not None:
            changed[field.name] = with_candidates(value, change)
    return replace(part, **changed)


def clauses(plan: Plan) -> Tuple[Do, ...]:
    """Return the clauses of a plan in the order in which they were said."""
    return tuple(part for part in walk(plan) if isinstance(part, Do))
