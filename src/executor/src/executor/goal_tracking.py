"""One goal of an action server, from sending to its end, as a state machine of values.

Each function takes an event and the time, and returns the next value. Nothing here waits: the caller calls `tick`
again at `next_deadline_s`.
"""

import enum
from dataclasses import dataclass, fields, replace
from typing import Dict, Optional, Sequence


class GoalStatusCode(enum.IntEnum):
    """Status of a goal as actionlib numbers it."""

    PENDING = 0
    ACTIVE = 1
    PREEMPTED = 2
    SUCCEEDED = 3
    ABORTED = 4
    REJECTED = 5
    PREEMPTING = 6
    RECALLING = 7
    RECALLED = 8
    LOST = 9


TERMINAL_STATUSES = frozenset(
    {
        GoalStatusCode.PREEMPTED,
        GoalStatusCode.SUCCEEDED,
        GoalStatusCode.ABORTED,
        GoalStatusCode.REJECTED,
        GoalStatusCode.RECALLED,
        GoalStatusCode.LOST,
    }
)

#: A sentence gives this many reasons of failures, and counts the others.
MOST_NAMED = 6


class Phase(enum.Enum):
    """Phase of a goal."""

    SENT = "sent"  # not accepted yet; a pending goal waits in the server
    ACCEPTED = "accepted"  # the server carries it out
    CANCELLING = "cancelling"  # cancels go out until the server ends it
    CONCLUDING = "concluding"  # the status is terminal, the result is missing
    ENDED = "ended"


class Outcome(enum.Enum):
    """How the goal ended."""

    SUCCEEDED = "succeeded"
    FAILED = "failed"
    PREEMPTED = "preempted"  # at our request
    TAKEN_AWAY = "taken_away"  # another client cancelled it


# SUCCEEDED counts only with a result that says success; PREEMPTED and RECALLED only when we requested it.
OUTCOME_OF_STATUS: Dict[GoalStatusCode, Outcome] = {
    GoalStatusCode.SUCCEEDED: Outcome.SUCCEEDED,
    GoalStatusCode.PREEMPTED: Outcome.PREEMPTED,
    GoalStatusCode.RECALLED: Outcome.PREEMPTED,
    GoalStatusCode.ABORTED: Outcome.FAILED,
    GoalStatusCode.REJECTED: Outcome.FAILED,
    GoalStatusCode.LOST: Outcome.FAILED,
}


@dataclass(frozen=True)
class GoalDeadlines:
    """How long each part of a goal may take.

    Attributes:
        acceptance_s: from sending until the server accepts it
        silence_s: between two messages of the server: status, feedback, result
        preempt_s: from the first cancel to the end of the goal
        cancel_period_s: between two cancels
        result_s: from a terminal status to its result
        suspicion_s: after this silence its process is asked, each time again, whether it still lives
        execution_s: from the acceptance to the end of the goal

    Raises:
        ValueError: a value that is not positive
    """

    acceptance_s: float = 5.0
    silence_s: float = 5.0
    preempt_s: float = 5.0
    cancel_period_s: float = 0.5
    result_s: float = 2.0
    suspicion_s: float = 1.0
    execution_s: float = 3600.0

    def __post_init__(self) -> None:
        for field in fields(self):
            if not 0.0 < getattr(self, field.name) < float("inf"):
                raise ValueError(f"{field.name} must be positive and finite, got {getattr(self, field.name)}")


@dataclass(frozen=True)
class Goal:
    """A goal that was sent.

    Attributes:
        server: name of the action server
        deadlines: of this goal
        phase: current phase
        since_s: when the phase began, monotonic seconds
        heard_s: when the server last sent a message
        cancelled_s: when the last cancel went out, None before the first
        asked_s: when its process was last asked whether it lives, None before
        is_preempt_asked: the cancel was requested; it does not follow from a fault
        fault: why the goal counts as failed although the server has not ended it; empty for none
        status: last status of the server
        outcome: only when ended
        reason: why it did not succeed, a clause that follows the name of the server; empty for success
        answer: what the server told when it succeeded; empty for nothing
        told: what the server said at its end, however it ended; empty for nothing
        is_succeeding: what its last feedback said; None before the first
        is_orphaned: the goal ended here but the server never said that it stopped
        is_withheld: the executor did not try the server: it is out of use, or the command has no time left
    """

    server: str
    deadlines: GoalDeadlines
    phase: Phase
    since_s: float
    heard_s: float
    cancelled_s: Optional[float] = None
    asked_s: Optional[float] = None
    is_preempt_asked: bool = False
    fault: str = ""
    status: GoalStatusCode = GoalStatusCode.PENDING
    outcome: Optional[Outcome] = None
    reason: str = ""
    answer: str = ""
    told: str = ""
    is_succeeding: Optional[bool] = None
    is_orphaned: bool = False
    is_withheld: bool = False

    @property
    def is_ended(self) -> bool:
        """Whether nothing more is expected."""
        return self.phase is Phase.ENDED


def send(server: str, deadlines: GoalDeadlines, *, now_s: float) -> Goal:
    """Return a goal that is being sent now."""
    return Goal(server=server, deadlines=deadlines, phase=Phase.SENT, since_s=now_s, heard_s=now_s)


def postpone(goal: Goal, by_s: float) -> Goal:
    """Move all deadlines: messages from the time in which this process did not run are still unread.

    Args:
        goal: the goal
        by_s: how long the process did not run
    """
    return replace(
        goal,
        since_s=goal.since_s + by_s,
        heard_s=goal.heard_s + by_s,
        asked_s=None if goal.asked_s is None else goal.asked_s + by_s,
    )


def hear_sign(goal: Goal, *, now_s: float) -> Goal:
    """The server published its status or feedback, about this goal or another one."""
    return replace(goal, heard_s=now_s)


def hear_feedback(goal: Goal, *, is_succeeding: bool, now_s: float) -> Goal:
    """The server said whether this goal is on its way."""
    return replace(goal, heard_s=now_s, is_succeeding=is_succeeding)


def hear_status(goal: Goal, status: int, *, now_s: float) -> Goal:
    """The server reported the status of this goal."""
    goal = replace(goal, heard_s=now_s)
    if goal.is_ended:
        return goal
    try:
        code = GoalStatusCode(status)
    except ValueError:
        return _end(goal, Outcome.FAILED, f"reported the unknown status {status}")
    if goal.phase is Phase.CONCLUDING and code not in TERMINAL_STATUSES:
        # A terminal status is final; this one was delayed.
        return goal
    goal = replace(goal, status=code)
    if code in TERMINAL_STATUSES:
        return goal if goal.phase is Phase.CONCLUDING else replace(goal, phase=Phase.CONCLUDING, since_s=now_s)
    if goal.phase is Phase.SENT and code is not GoalStatusCode.PENDING:
        return replace(goal, phase=Phase.ACCEPTED, since_s=now_s)
    return goal


def hear_result(goal: Goal, status: int, *, success: Optional[bool], text: str, now_s: float) -> Goal:
    """The goal is over for the server.

    Args:
        goal: the goal
        status: its terminal status
        success: the field of the result; None when there is no result, as for a lost goal
        text: of the server, empty for none
        now_s: monotonic seconds
    """
    if goal.is_ended:
        return goal
    goal = replace(goal, heard_s=now_s, told=text.strip())
    try:
        code = GoalStatusCode(status)
        outcome = OUTCOME_OF_STATUS[code]
    except (ValueError, KeyError):
        return _end(goal, Outcome.FAILED, f"ended with status {status}, which is not terminal")
    goal = replace(goal, status=code)
    remark = f": {text.strip().rstrip('.')}" if text.strip() else ""
    if outcome is Outcome.SUCCEEDED and not success:
        missing = "sent no result" if success is None else "its result says that it did not succeed"
        return _end(goal, Outcome.FAILED, f"said {code.name} but {missing}{remark}")
    if outcome is Outcome.SUCCEEDED:
        return replace(_end(goal, Outcome.SUCCEEDED, ""), answer=text.strip())
    return _end(goal, outcome, f"{_VERBS[code]}{remark}")


def hear_death(goal: Goal, *, now_s: float) -> Goal:
    """The process of the server has ended: nothing more comes, and nothing needs to be cancelled."""
    if goal.is_ended:
        return goal
    goal = replace(goal, heard_s=now_s)
    if goal.phase is Phase.CONCLUDING:
        return _conclude_without_result(goal)
    return _end(goal, Outcome.PREEMPTED if goal.is_preempt_asked else Outcome.FAILED, "has died")


_VERBS: Dict[GoalStatusCode, str] = {
    GoalStatusCode.PREEMPTED: "was preempted",
    GoalStatusCode.RECALLED: "was cancelled before it began",
    GoalStatusCode.ABORTED: "aborted",
    GoalStatusCode.REJECTED: "rejected the goal",
    GoalStatusCode.LOST: "lost the goal",
}


def ask_preempt(goal: Goal, *, now_s: float) -> Goal:
    """Request that the goal ends; `tick` says when cancels are sent."""
    if goal.is_ended or goal.is_preempt_asked:
        return goal
    goal = replace(goal, is_preempt_asked=True)
    if goal.phase in (Phase.SENT, Phase.ACCEPTED):
        return replace(goal, phase=Phase.CANCELLING, since_s=now_s)
    return goal


@dataclass(frozen=True)
class Tick:
    """Result of `tick`: the goal, whether a cancel must be sent now, and whether to ask if the process lives."""

    goal: Goal
    is_cancel_due: bool = False
    is_question_due: bool = False


def tick(goal: Goal, *, now_s: float) -> Tick:
    """Apply the deadlines at the time `now_s`."""
    if goal.is_ended:
        return Tick(goal)
    deadlines = goal.deadlines
    if goal.phase is Phase.SENT and now_s - goal.since_s >= deadlines.acceptance_s:
        goal = _give_up(goal, f"did not accept the goal within {deadlines.acceptance_s:g} s", now_s=now_s)
    elif goal.phase is Phase.ACCEPTED and now_s - goal.heard_s >= deadlines.silence_s:
        goal = _give_up(goal, f"was silent for {deadlines.silence_s:g} s", now_s=now_s)
    elif goal.phase is Phase.ACCEPTED and now_s - goal.since_s >= deadlines.execution_s:
        goal = _give_up(goal, f"did not end within {deadlines.execution_s:g} s", now_s=now_s)
    elif goal.phase is Phase.CONCLUDING and now_s - goal.since_s >= deadlines.result_s:
        return Tick(_conclude_without_result(goal))
    is_cancel_due = False
    if goal.phase is Phase.CANCELLING:
        if now_s - goal.since_s >= deadlines.preempt_s:
            unfinished = f"did not end on cancel within {deadlines.preempt_s:g} s"
            reason = f"{goal.fault} and {unfinished}" if goal.fault else unfinished
            outcome = Outcome.PREEMPTED if goal.is_preempt_asked else Outcome.FAILED
            return Tick(_end(replace(goal, is_orphaned=True), outcome, reason))
        is_cancel_due = goal.cancelled_s is None or now_s - goal.cancelled_s >= deadlines.cancel_period_s
        if is_cancel_due:
            goal = replace(goal, cancelled_s=now_s)
    is_question_due = now_s >= _question_s(goal)
    return Tick(replace(goal, asked_s=now_s) if is_question_due else goal, is_cancel_due, is_question_due)


def _question_s(goal: Goal) -> float:
    """When to ask whether its process lives: when it is silent, and again as long as it is."""
    return max(goal.heard_s, goal.asked_s or float("-inf")) + goal.deadlines.suspicion_s


def next_deadline_s(goal: Goal) -> float:
    """When `tick` must be called next, monotonic seconds; infinite when ended."""
    deadlines = goal.deadlines
    if goal.phase is Phase.SENT:
        phase_s = goal.since_s + deadlines.acceptance_s
    elif goal.phase is Phase.ACCEPTED:
        phase_s = min(goal.heard_s + deadlines.silence_s, goal.since_s + deadlines.execution_s)
    elif goal.phase is Phase.CONCLUDING:
        phase_s = goal.since_s + deadlines.result_s
    elif goal.phase is Phase.CANCELLING:
        next_cancel_s = goal.since_s if goal.cancelled_s is None else goal.cancelled_s + deadlines.cancel_period_s
        phase_s = min(next_cancel_s, goal.since_s + deadlines.preempt_s)
    else:
        return float("inf")
    return min(phase_s, _question_s(goal))


def fail_unsent(server: str, deadlines: GoalDeadlines, reason: str, *, now_s: float) -> Goal:
    """Return a goal that could not be sent."""
    return _end(send(server, deadlines, now_s=now_s), Outcome.FAILED, reason)


def withhold(server: str, deadlines: GoalDeadlines, reason: str, *, now_s: float) -> Goal:
    """Return a goal that is not to be sent: the server is out of use, or the command has no time left."""
    return replace(fail_unsent(server, deadlines, reason, now_s=now_s), is_withheld=True)


def preempt_unsent(server: str, deadlines: GoalDeadlines, *, now_s: float) -> Goal:
    """Return a goal that was cancelled before it was sent."""
    goal = replace(send(server, deadlines, now_s=now_s), is_preempt_asked=True)
    return _end(goal, Outcome.PREEMPTED, "was cancelled before it began")


def _give_up(goal: Goal, fault: str, *, now_s: float) -> Goal:
    # The server may recover: what it does then must end too.
    return replace(goal, phase=Phase.CANCELLING, since_s=now_s, fault=fault)


def _conclude_without_result(goal: Goal) -> Goal:
    code = goal.status
    outcome = OUTCOME_OF_STATUS[code]
    if outcome is Outcome.SUCCEEDED:
        return _end(goal, Outcome.FAILED, f"said {code.name} but sent no result")
    return _end(goal, outcome, _VERBS[code])


def _end(goal: Goal, outcome: Outcome, reason: str) -> Goal:
    if outcome is Outcome.SUCCEEDED:
        # It succeeded although a cancel was requested meanwhile: no other server may do it again.
        pass
    elif goal.fault and not goal.is_orphaned:
        # It ended only because it was cancelled for its fault.
        outcome = Outcome.PREEMPTED if goal.is_preempt_asked else Outcome.FAILED
        reason = goal.fault
    elif outcome is Outcome.PREEMPTED and not goal.is_preempt_asked:
        outcome = Outcome.TAKEN_AWAY
    elif outcome is Outcome.FAILED and goal.is_preempt_asked:
        # Servers without preemption abort on a cancel; the request is fulfilled.
        outcome = Outcome.PREEMPTED
    return replace(goal, phase=Phase.ENDED, outcome=outcome, reason=reason)


def describe_failures(goals: Sequence[Goal]) -> str:
    """Return why servers failed, for a person; empty when none failed.

    What a server told is its own sentence. Of one that told nothing, what it did is said. Names of servers are in the
    stage events and in the log.
    """
    reasons = list(dict.fromkeys(reason_for_person(goal) for goal in goals if goal.outcome is Outcome.FAILED))
    more = len(reasons) - MOST_NAMED
    told = reasons[:MOST_NAMED] + ([f"and {more} more"] if more > 0 else [])
    return as_sentence("; ".join(told)) if told else ""


def reason_for_person(goal: Goal) -> str:
    """Return why a goal failed, without the full stop and without a name that only engineers know."""
    return own_words(goal) or unnamed(goal.reason)


def own_words(goal: Goal) -> str:
    """Return what a server told as it gave up, without the full stop; empty for none."""
    gave_up = not goal.fault and goal.status in (GoalStatusCode.ABORTED, GoalStatusCode.REJECTED)
    return goal.told.rstrip(".") if gave_up else ""


def unnamed(reason: str) -> str:
    """Return a clause that follows the name of a server as a sentence for a person, who does not know that name."""
    return f"the program for it {reason}"


def as_sentence(words: str) -> str:
    """Add a full stop to words that do not end with a sentence mark."""
    return words if words.endswith((".", "!", "?")) else f"{words}."
