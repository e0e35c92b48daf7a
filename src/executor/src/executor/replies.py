"""Replies of the executor: how a command ended, for the person."""

import enum
from dataclasses import dataclass
from typing import Iterable, List, Optional, Sequence, Tuple, Union

from arbitrator.node_runs import ABORTED, PREEMPTED, SUCCEEDED, EndedBy
from arbitrator.plan import CONDITIONS, AnyCondition, Do, If, Part, Plan, Repeat, Until, Wait, While, parts_of, walk
from executor.command_queue import Cause
from executor.goal_tracking import Goal, Outcome, as_sentence, describe_failures
from executor.run_record import NodeRecord
from roboframenet_ros.spoken_text import join_with_and, with_capital
from robot_stop.emergency import CODE as EMERGENCY_STOP


class ReplyOutcome(enum.IntEnum):
    """Outcomes that the executor gives; the numbers are those of the Reply message."""

    DONE = 0
    FAILED = 1
    REFUSED = 2
    SUPERSEDED = 4


@dataclass(frozen=True)
class Ending:
    """How a command ended: the fields of a reply."""

    outcome: ReplyOutcome
    code: str
    sentence: str


_NO_MASTER = "The ROS master is gone"
_SENTENCE_OF = {
    Cause.NEW_COMMAND: "A newer command took its place.",
    Cause.STOPPED: "Stopped.",
    Cause.NOT_FREE: "It did not begin, because something else ran.",
    Cause.NOT_BEGUN: "I did not start, because the step before failed.",
    Cause.TOO_MANY: "I did not begin, because too many commands wait or run already.",
}
#: Nothing took the place of these: the robot could not do what was said.
_FAILED = (Cause.NOT_BESIDE, Cause.NOT_BEGUN, Cause.TOO_MANY)


def ending_of_unstarted(cause: Cause, *, blocking: str = "") -> Ending:
    """Return the ending of a command that was never started.

    Args:
        cause: why
        blocking: what runs, in the words of the person, if that is the reason
    """
    sentence = _SENTENCE_OF.get(cause) or f'I cannot do that beside "{blocking.strip(" .!")}": both need the same part.'
    outcome = ReplyOutcome.FAILED if cause in _FAILED else ReplyOutcome.SUPERSEDED
    return Ending(outcome, cause.value, sentence)


def ending_of_malformed(error: str) -> Ending:
    """Return the ending of a command whose plan cannot be read."""
    return Ending(ReplyOutcome.FAILED, "STAGE_ERROR", f"The plan cannot be carried out: {error}.")


def ending_without_master() -> Ending:
    """Return the ending of a command that does not start because the master is gone."""
    return Ending(ReplyOutcome.FAILED, "MASTER_LOST", f"{_NO_MASTER}, so I begin nothing.")


def ending_of_held(sentence: str) -> Ending:
    """Return the ending of a command that does not start while the emergency stop holds, which a sentence says."""
    return Ending(ReplyOutcome.REFUSED, EMERGENCY_STOP, sentence)


def ending_of_run(
    outcome: str,
    plan: Plan,
    records: Sequence[NodeRecord],
    *,
    cause: Optional[Cause],
    error: str,
    is_without_master: bool = False,
) -> Ending:
    """Return the ending of a command that was started.

    Args:
        outcome: of the machine: succeeded, aborted or preempted; empty when it broke
        plan: what was carried out
        records: what became of each of its nodes
        cause: why it was preempted, None if it was not
        error: why the machine broke, empty if it did not
        is_without_master: whether the master is gone, and nothing began since
    """
    story = _Story(plan, records)
    failures = describe_failures(story.goals)
    if error:
        return Ending(
            ReplyOutcome.FAILED,
            "STAGE_ERROR",
            _text(f"The state machine broke: {error}.", failures, story.done_before()),
        )
    if outcome == SUCCEEDED:
        # Also when a preemption was requested: it succeeded first.
        if story.is_time_lost:
            return Ending(ReplyOutcome.FAILED, "LIMIT_REACHED", _text(*story.turns(), story.done_besides(), failures))
        done = f"Done, though another way failed first: {failures}" if failures else "Done."
        return Ending(ReplyOutcome.DONE, "DONE", _text(done, *story.answers(), *story.turns()))
    # A server that ignored the cancel may still move the robot; the person must know which one.
    orphans = " ".join(
        f"{goal.server} {goal.reason}."
        for goal in story.goals
        if goal.is_orphaned and goal.outcome is Outcome.PREEMPTED
    )
    if cause is not None:
        return Ending(ReplyOutcome.SUPERSEDED, cause.value, _text(_SENTENCE_OF[cause], orphans, story.done_before()))
    if is_without_master and outcome == PREEMPTED:
        return Ending(ReplyOutcome.FAILED, "MASTER_LOST", _text(f"{_NO_MASTER}.", orphans, *story.what_was_done()))
    if outcome == PREEMPTED:
        taken = " ".join(f"{goal.server} {goal.reason}." for goal in story.goals if goal.outcome is Outcome.TAKEN_AWAY)
        return Ending(
            ReplyOutcome.SUPERSEDED, "STOPPED", _text(f"Another client cancelled it: {taken}", story.done_before())
        )
    return Ending(ReplyOutcome.FAILED, *story.failure())


class _Story:
    """What happened, in words."""

    def __init__(self, plan: Plan, records: Sequence[NodeRecord]) -> None:
        # By number: the same clause may stand in a plan twice.
        self._parts = list(zip(walk(plan), records))
        self._clauses = [(part, record) for part, record in self._parts if isinstance(part, Do)]
        self.goals: List[Goal] = [goal for _, record in self._clauses for goal in record.goals]

    def turns(self) -> List[str]:
        """Return a sentence for each node that went another way than doing everything that was said, once."""
        return [sentence for number in range(len(self._parts)) for sentence in [self._turn(number)] if sentence]

    def answers(self) -> List[str]:
        """Return what the servers told, each sentence once: "There are four."."""
        told = (goal.answer for goal in self.goals if goal.outcome is Outcome.SUCCEEDED)
        return [as_sentence(with_capital(answer)) for answer in dict.fromkeys(told) if answer]

    @property
    def is_time_lost(self) -> bool:
        """Whether the time of something was over while its server said that it does not succeed."""
        return any(
            goal.is_succeeding is False for number in range(len(self._parts)) for goal in self._ended_by_time(number)
        )

    def _ended_by_time(self, number: int) -> List[Goal]:
        """Return the goals that a node ended because their time was over."""
        part, record = self._parts[number]
        is_over = isinstance(part, Until) and part.condition is None and record.ended_by is EndedBy.TIME
        if not is_over or record.outcome != SUCCEEDED:
            return []
        inside = self._parts[number : number + sum(1 for _ in walk(part))]
        last = (child.goals[-1] for one, child in inside if isinstance(one, Do) and child.goals)
        return [goal for goal in last if goal.outcome is Outcome.PREEMPTED]

    def _children(self, number: int) -> List[NodeRecord]:
        """What became of the children of a node that are no conditions."""
        place, found = number + 1, []
        for child in parts_of(self._parts[number][0]):
            if not isinstance(child, CONDITIONS):
                found.append(self._parts[place][1])
            place += sum(1 for _ in walk(child))
        return found

    def _turn(self, number: int) -> str:
        part, record = self._parts[number]
        if record.outcome != SUCCEEDED:
            return ""
        children = self._children(number)
        if isinstance(part, If) and record.ended_by is EndedBy.CONDITION:
            return f'I did not do "{part.child.label}", because {_says(part.condition, holds=False)}.'
        if isinstance(part, If) and part.otherwise is not None and children[1].begun:
            what = f'"{part.otherwise.label}", and not "{part.child.label}"'
            return f"I did {what}, because {_says(part.condition, holds=False)}."
        if isinstance(part, Until) and part.condition is None:
            return self._end_of_time(number)
        if isinstance(part, (Until, While)):
            return _end_of_work(part, record, children[0])
        if isinstance(part, Repeat) and record.begun == 1 and children[0].done > 1:
            return f'I did "{part.child.label}" {children[0].done} times.'
        return ""

    def _end_of_time(self, number: int) -> str:
        """Say what was ended because its time was over, and how far it came."""
        part, record = self._parts[number]
        if not isinstance(part, Until) or record.ended_by is not EndedBy.TIME:
            return ""
        reached = " ".join(as_sentence(with_capital(goal.told)) for goal in self._ended_by_time(number) if goal.told)
        ended = f'I ended "{part.child.label}" after {_seconds(part.duration_s)}'
        return f"{ended}: {reached}" if reached else f"{ended}."

    def failure(self) -> Tuple[str, str]:
        """Return the code and the sentence for a plan that failed: what was done and what was not, and why.

        Such as 'I did "ping", but I could not do "wave at Alice": ...'.
        """
        failed = [(part, record) for part, record in self._clauses if record.outcome == ABORTED]
        reasons = [reason for reason in (_reason(part, record) for part, record in self._parts) if reason]
        if len(self._parts) == 1 and not reasons:
            ways = sum(goal.outcome is Outcome.FAILED for goal in self.goals)
            what = "Every way I tried failed" if ways > 1 else "I could not do that"
            return "ALL_CANDIDATES_FAILED", f"{what}: {describe_failures(self.goals)}"
        done = self._done()
        left = _labels(part for part, record in self._clauses if not record.begun)
        rest = f"I did not begin {left}." if left else ""
        if not reasons:
            what = " ".join(
                f'could not do "{part.label}": {describe_failures(record.goals)}' for part, record in failed
            )
            return "ALL_CANDIDATES_FAILED", _text(f"I did {done}, but I {what}" if done else f"I {what}", rest)
        ended = _labels(part for part, record in self._clauses if record.outcome and record.outcome != SUCCEEDED)
        code = "CONDITION_UNKNOWN" if any(record.fault for _, record in self._parts) else "LIMIT_REACHED"
        return code, _text(
            *reasons, f"I ended {ended}." if ended else "", f"Before that, I did {done}." if done else "", rest
        )

    def what_was_done(self) -> List[str]:
        """Return sentences that name the clauses that were done, failed, were ended, and did not begin."""
        done = self._done()
        failed = [
            f'I could not do "{part.label}": {describe_failures(record.goals)}'
            for part, record in self._clauses
            if record.outcome == ABORTED and record.goals
        ]
        ended = _labels(
            part
            for part, record in self._clauses
            if record.outcome == PREEMPTED and record.goals and record.goals[-1].outcome is not Outcome.SUCCEEDED
        )
        # A node may have begun without a goal of its own.
        left = _labels(part for part, record in self._clauses if not record.goals)
        again = [
            f'I do not repeat "{part.child.label}".'
            for part, record in self._parts
            if isinstance(part, Repeat) and record.outcome == PREEMPTED
        ]
        return [
            f"I did {done}." if done else "",
            *failed,
            f"I ended {ended}." if ended else "",
            *again,
            f"I did not begin {left}." if left else "",
        ]

    def done_besides(self) -> str:
        """Return a sentence that names the clauses that were done; empty for none."""
        done = self._done()
        return f"I did {done}." if done else ""

    def done_before(self) -> str:
        """Return a sentence that names the clauses that were done; empty for none, or for a single clause."""
        done = self._done() if len(self._parts) > 1 else ""
        return f"Before that, I did {done}." if done else ""

    def _done(self) -> str:
        done = [(part.label, record.done) for part, record in self._clauses if record.done]
        return join_with_and(f'"{label}"' + (f" {times} times" if times > 1 else "") for label, times in done)


def _end_of_work(part: Union[Until, While], record: NodeRecord, child: NodeRecord) -> str:
    label = f'"{part.child.label}"'
    if part.condition is None:
        return ""
    if record.ended_by is EndedBy.CONDITION:
        did = "ended" if child.begun else "did not begin"
        return f"I {did} {label}, because {_says(part.condition, holds=isinstance(part, Until))}."
    return f"{label} was over before {_says(part.condition, holds=True)}." if isinstance(part, Until) else ""


def _reason(part: Part, record: NodeRecord) -> str:
    """Why a node failed, if it was not for its clauses."""
    condition: Optional[AnyCondition] = getattr(part, "condition", None)
    if record.outcome != ABORTED or isinstance(part, CONDITIONS):
        return ""
    if record.ended_by is EndedBy.FAULT and condition is not None:
        return f'I cannot tell whether "{condition.label}": {record.fault}.'
    if record.ended_by is EndedBy.LIMIT:
        within = f"within {_seconds(part.limit.seconds)}" if part.limit.seconds else "in time"
        if isinstance(part, Wait) and condition is not None:
            return f"I waited, but {within} {_says(condition, holds=False)}."
        return f'"{part.label}" was not done {within}.'
    return ""


def _says(condition: AnyCondition, *, holds: bool) -> str:
    """Return words that say that a condition holds, or does not: '"the door is closed" holds'."""
    return f'"{condition.label}" held' if holds is not condition.is_negated else f'"{condition.label}" did not hold'


def _seconds(seconds: float) -> str:
    minutes = seconds / 60.0
    if minutes >= 2.0 and minutes == round(minutes):
        return f"{minutes:g} minutes"
    return "1 second" if seconds == 1.0 else f"{seconds:g} seconds"


def _text(*sentences: str) -> str:
    return " ".join(" ".join(sentences).split())


def _labels(clauses: Iterable[Do]) -> str:
    return join_with_and(f'"{clause.label}"' for clause in clauses)
