"""Plans as observers see them: as the procedure of 2012, and in words."""

import itertools
from typing import Optional, Tuple, Union

from arbitrator.plan import Condition, Do, InSequence, Plan, clauses, walk
from arbitrator.standing import STANDING, AnyOrder
from typed_arguments import FilledFrame

#: Most sequences of the 2012 procedure of a plan with several clauses.
MOST_COMBINATIONS = 64


def as_procedure(plan: Plan) -> Optional[Tuple[Tuple[FilledFrame, ...], ...]]:
    """Return a plan as the procedure of 2012: sequences of frames, tried one after the other.

    A procedure cannot say that a clause is done: each sequence holds the frames of all clauses. Several clauses
    give the combinations of their candidates, up to `MOST_COMBINATIONS`.

    Returns:
        None when the plan joins clauses in another way than one after the other, which a procedure cannot say
    """
    if not all(isinstance(part, (Do, InSequence)) for part in walk(plan)):
        return None
    groups = [[candidate.frames for candidate in clause.candidates] for clause in clauses(plan)]
    if len(groups) == 1:
        return tuple(groups[0])
    combinations = itertools.islice(itertools.product(*groups), MOST_COMBINATIONS)
    return tuple(tuple(itertools.chain.from_iterable(combination)) for combination in combinations)


def describe(plan: Union[Plan, AnyOrder]) -> str:
    """Return a plan as a sentence: "2 candidates, first turning by turn_slowly."."""
    if isinstance(plan, STANDING):
        return f"A standing order: {describe(plan.child)}"
    parts = [part for part in walk(plan) if isinstance(part, (Do, Condition))]
    if len(parts) == 1:
        return f"{_candidates(parts[0])}."
    return "; then ".join(f'"{part.label}": {_candidates(part)}' for part in parts) + "."


def _candidates(clause: Union[Do, Condition]) -> str:
    first = ", then ".join(f"{frame.name} by {frame.server}" for frame in clause.candidates[0].frames)
    count = len(clause.candidates)
    return f"1 candidate, {first}" if count == 1 else f"{count} candidates, first {first}"
