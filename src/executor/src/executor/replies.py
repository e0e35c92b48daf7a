"""What the executor tells the person about the end of a command."""
import enum
from dataclasses import dataclass
from typing import Optional, Sequence

from executor.command_desk import Cause
from executor.goal_tracking import Goal, Outcome, describe_failures


class ReplyOutcome(enum.IntEnum):
    """Outcomes that the executor gives; the numbers are those of the Reply message."""

    DONE = 0
    FAILED = 1
    SUPERSEDED = 4


@dataclass(frozen=True)
class Ending:
    """How a command ended: the fields of a reply."""

    outcome: ReplyOutcome
    code: str
    sentence: str


_SENTENCE_OF = {Cause.NEW_COMMAND: "A newer command took its place.", Cause.STOPPED: "Stopped."}


def ending_of_unstarted(cause: Cause) -> Ending:
    """The end of a command that never began."""
    return Ending(ReplyOutcome.SUPERSEDED, cause.value, _SENTENCE_OF[cause])


def ending_of_malformed(error: str) -> Ending:
    """The end of a command whose procedure cannot be read."""
    return Ending(ReplyOutcome.FAILED, "STAGE_ERROR", f"The procedure cannot be carried out: {error}.")


def ending_of_run(outcome: str, goals: Sequence[Goal], *, cause: Optional[Cause], error: str) -> Ending:
    """The end of a command that began.

    Args:
        outcome: of the machine: succeeded, aborted or preempted; empty when it broke
        goals: every goal that was tried, in order
        cause: why it was asked to end, None if it was not
        error: why the machine broke, empty if it did not
    """
    failures = describe_failures(goals)
    if error:
        return Ending(ReplyOutcome.FAILED, "STAGE_ERROR", f"The state machine broke: {error}. {failures}".strip())
    if outcome == "succeeded":
        # Also when it was asked to end: it was faster.
        return Ending(ReplyOutcome.DONE, "DONE", f"Done; but before, {failures}" if failures else "Done.")
    # A server that ignored the cancel may still move the robot; the person must know which one.
    orphans = " ".join(f"{goal.server} {goal.reason}." for goal in goals
                       if goal.is_orphaned and goal.outcome is Outcome.PREEMPTED)
    if cause is not None:
        return Ending(ReplyOutcome.SUPERSEDED, cause.value, f"{_SENTENCE_OF[cause]} {orphans}".strip())
    if outcome == "preempted":
        taken = " ".join(f"{goal.server} {goal.reason}." for goal in goals if goal.outcome is Outcome.TAKEN_AWAY)
        return Ending(ReplyOutcome.SUPERSEDED, "STOPPED", f"Somebody else cancelled it: {taken}".strip())
    return Ending(ReplyOutcome.FAILED, "ALL_CANDIDATES_FAILED", f"Nothing that could do it succeeded: {failures}")
