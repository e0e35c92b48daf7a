"""Replies of the executor: how a command ended, for the person."""

import enum
from dataclasses import dataclass
from typing import Iterable, Optional, Sequence, Tuple

from executor.command_queue import Cause
from executor.goal_tracking import Goal, Outcome, describe_failures


class ReplyOutcome(enum.IntEnum):
    """Outcomes that the executor gives; the numbers are those of the Reply message."""

    DONE = 0
    FAILED = 1
    SUPERSEDED = 4


@dataclass(frozen=True)
class ClauseRun:
    """How a clause ended.

    Attributes:
        label: the words of the clause
        outcome: succeeded, aborted or preempted; empty when it did not start or did not end
        goals: every goal that was tried, in order
    """

    label: str
    outcome: str
    goals: Tuple[Goal, ...] = ()


@dataclass(frozen=True)
class Ending:
    """How a command ended: the fields of a reply."""

    outcome: ReplyOutcome
    code: str
    sentence: str


_SENTENCE_OF = {Cause.NEW_COMMAND: "A newer command took its place.", Cause.STOPPED: "Stopped."}


def ending_of_unstarted(cause: Cause) -> Ending:
    """Return the ending of a command that was never started."""
    return Ending(ReplyOutcome.SUPERSEDED, cause.value, _SENTENCE_OF[cause])


def ending_of_malformed(error: str) -> Ending:
    """Return the ending of a command whose plan cannot be read."""
    return Ending(ReplyOutcome.FAILED, "STAGE_ERROR", f"The plan cannot be carried out: {error}.")


def ending_of_run(outcome: str, clauses: Sequence[ClauseRun], *, cause: Optional[Cause], error: str) -> Ending:
    """Return the ending of a command that was started.

    Args:
        outcome: of the machine: succeeded, aborted or preempted; empty when it broke
        clauses: of the plan, in order
        cause: why it was preempted, None if it was not
        error: why the machine broke, empty if it did not
    """
    goals = [goal for clause in clauses for goal in clause.goals]
    failures = describe_failures(goals)
    if error:
        sentence = f"The state machine broke: {error}. {failures} {_done_before(clauses)}"
        return Ending(ReplyOutcome.FAILED, "STAGE_ERROR", " ".join(sentence.split()))
    if outcome == "succeeded":
        # Also when a preemption was requested: it succeeded first.
        return Ending(ReplyOutcome.DONE, "DONE", f"Done, after {failures}" if failures else "Done.")
    # A server that ignored the cancel may still move the robot; the person must know which one.
    orphans = " ".join(
        f"{goal.server} {goal.reason}." for goal in goals if goal.is_orphaned and goal.outcome is Outcome.PREEMPTED
    )
    if cause is not None:
        sentence = f"{_SENTENCE_OF[cause]} {orphans} {_done_before(clauses)}"
        return Ending(ReplyOutcome.SUPERSEDED, cause.value, " ".join(sentence.split()))
    if outcome == "preempted":
        taken = " ".join(f"{goal.server} {goal.reason}." for goal in goals if goal.outcome is Outcome.TAKEN_AWAY)
        sentence = f"Another client cancelled it: {taken} {_done_before(clauses)}"
        return Ending(ReplyOutcome.SUPERSEDED, "STOPPED", " ".join(sentence.split()))
    return Ending(ReplyOutcome.FAILED, "ALL_CANDIDATES_FAILED", _failure(clauses))


def _failure(clauses: Sequence[ClauseRun]) -> str:
    """Return what was done and what was not: 'I did "ping", but I could not do "wave at Alice": ...'."""
    failed = next((clause for clause in clauses if clause.outcome == "aborted"), None)
    if len(clauses) == 1 or failed is None:
        failures = describe_failures([goal for clause in clauses for goal in clause.goals])
        return f"Every way I tried failed: {failures}"
    done = _labels(clause for clause in clauses if clause.outcome == "succeeded")
    left = _labels(clause for clause in clauses if not clause.outcome)
    subject = f"I did {done}, but I" if done else "I"
    rest = f" I did not begin {left}." if left else ""
    return f'{subject} could not do "{failed.label}": {describe_failures(failed.goals)}{rest}'


def _done_before(clauses: Sequence[ClauseRun]) -> str:
    """Return a sentence that names the clauses that were done; empty for none, or for a single clause."""
    done = _labels(clause for clause in clauses if clause.outcome == "succeeded") if len(clauses) > 1 else ""
    return f"Before that, I did {done}." if done else ""


def _labels(clauses: Iterable[ClauseRun]) -> str:
    quoted = [f'"{clause.label}"' for clause in clauses]
    return ", ".join(quoted[:-1]) + " and " + quoted[-1] if len(quoted) > 1 else "".join(quoted)
