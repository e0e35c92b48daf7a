"""Defines plans as values: a plan is a tree of clauses, each with its candidates."""

import itertools
import math
from dataclasses import dataclass
from typing import Tuple, Union

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
class Do:
    """Carry out one clause: the candidates, one after the other, until one succeeds.

    Attributes:
        label: the words of the clause
        candidates: at least one

    Raises:
        ValueError: no candidate at all
    """

    label: str
    candidates: Tuple[Candidate, ...]

    def __post_init__(self) -> None:
        if not self.candidates:
            raise ValueError("a clause has no candidates")


@dataclass(frozen=True)
class InSequence:
    """Carry out the children in this order, until one fails.

    Attributes:
        label: the words of all clauses
        children: at least one

    Raises:
        ValueError: no children at all
    """

    label: str
    children: Tuple["Plan", ...]

    def __post_init__(self) -> None:
        if not self.children:
            raise ValueError("a sequence has no children")


Plan = Union[Do, InSequence]

#: Most sequences of the 2012 procedure of a plan with several clauses.
MOST_COMBINATIONS = 64


def clauses(plan: Plan) -> Tuple[Do, ...]:
    """Return the clauses of a plan in the order in which they are carried out."""
    if isinstance(plan, Do):
        return (plan,)
    return tuple(clause for child in plan.children for clause in clauses(child))


def as_procedure(plan: Plan) -> Tuple[Tuple[FilledFrame, ...], ...]:
    """Return a plan as the procedure of 2012: sequences of frames, tried one after the other.

    A procedure cannot say that a clause is done: each sequence holds the frames of all clauses. Several clauses
    give the combinations of their candidates, up to `MOST_COMBINATIONS`.
    """
    groups = [[candidate.frames for candidate in clause.candidates] for clause in clauses(plan)]
    if len(groups) == 1:
        return tuple(groups[0])
    combinations = itertools.islice(itertools.product(*groups), MOST_COMBINATIONS)
    return tuple(tuple(itertools.chain.from_iterable(combination)) for combination in combinations)


def describe(plan: Plan) -> str:
    """Return a plan as a sentence: "2 candidates, first turning by turn_slowly."."""
    parts = clauses(plan)
    if len(parts) == 1:
        return f"{_candidates(parts[0])}."
    return "; then ".join(f'"{part.label}": {_candidates(part)}' for part in parts) + "."


def _candidates(clause: Do) -> str:
    first = ", then ".join(f"{frame.name} by {frame.server}" for frame in clause.candidates[0].frames)
    count = len(clause.candidates)
    return f"1 candidate, {first}" if count == 1 else f"{count} candidates, first {first}"
