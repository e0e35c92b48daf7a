"""Builds the SMACH state machine of a plan."""

import re
from typing import Callable, Iterable, Tuple

import smach
from arbitrator.plan import Candidate, Do, Plan
from typed_arguments import FilledFrame

OUTCOMES = ("succeeded", "aborted", "preempted")

#: Characters of a label. Slashes would read as levels of the machine in the paths that SMACH publishes; smach_viewer
#: puts labels between quotation marks.
_NO_LABEL = re.compile(r"[^\w .,:;!?'()+-]+")
_LONGEST_LABEL = 60

MakeStep = Callable[[FilledFrame, int], smach.State]
OnClauseEnd = Callable[[int, str], None]


def plan_label(plan: Plan) -> str:
    """Label of a plan, or of a part of it: its words."""
    words = " ".join(_NO_LABEL.sub(" ", plan.label).split())
    if len(words) > _LONGEST_LABEL:
        words = words[:_LONGEST_LABEL].rsplit(" ", 1)[0] + " ..."
    return words or "plan"


def child_label(index: int, child: Plan) -> str:
    """Label of a part of a plan in the machine that it is in; `index` counts from 0. Words may be said twice."""
    return f"{index + 1} {plan_label(child)}"


def candidate_label(index: int) -> str:
    """Label of a candidate in the machine of its clause; `index` counts from 0."""
    return f"candidate_{index + 1}"


def step_label(index: int, frame: FilledFrame) -> str:
    """Label of a frame in the machine of its candidate; `index` counts from 0."""
    return f"{index + 1}_{frame.name}_by_{frame.server.strip('/').replace('/', '.')}"


def build_state_machine(
    plan: Plan, make_step: MakeStep, *, on_clause_end: OnClauseEnd = lambda clause, outcome: None
) -> smach.StateMachine:
    """Build the machine of a plan: a sub-machine for each part, each clause, and each candidate of a clause.

    A frame that fails ends its candidate; the next candidate of the clause starts from its first frame. The first
    candidate whose frames all succeed ends the clause, and no clause is carried out again. A clause that has no
    candidate left ends the plan. A preempted frame ends everything.

    Args:
        plan: what to carry out
        make_step: makes the state of one frame, with the outcomes succeeded, aborted and preempted; its second argument
            is the number of the clause, from 0, in the order in which clauses are carried out
        on_clause_end: called, while the machine runs, with the number of each clause that has ended, and its outcome

    Returns:
        a machine with the outcomes succeeded, aborted and preempted

    SMACH keeps a stack of open machines for its class: build in one thread at a time.
    """
    return _Builder(make_step, on_clause_end).build(plan)


class _Builder:
    def __init__(self, make_step: MakeStep, on_clause_end: OnClauseEnd) -> None:
        self._make_step = make_step
        self._on_clause_end = on_clause_end
        self._clauses = 0

    def build(self, plan: Plan) -> smach.StateMachine:
        if isinstance(plan, Do):
            clause, self._clauses = self._clauses, self._clauses + 1
            machine = _chain(
                (
                    (candidate_label(index), self._candidate(candidate, clause))
                    for index, candidate in enumerate(plan.candidates)
                ),
                goes_on="aborted",
            )
            machine.register_termination_cb(lambda userdata, states, outcome: self._on_clause_end(clause, outcome))
            return machine
        return _chain(
            ((child_label(index, child), self.build(child)) for index, child in enumerate(plan.children)),
            goes_on="succeeded",
        )

    def _candidate(self, candidate: Candidate, clause: int) -> smach.StateMachine:
        return _chain(
            (
                (step_label(index, frame), self._make_step(frame, clause))
                for index, frame in enumerate(candidate.frames)
            ),
            goes_on="succeeded",
        )


def _chain(states: Iterable[Tuple[str, smach.State]], *, goes_on: str) -> smach.StateMachine:
    """Run states one after the other while they end with `goes_on`; another outcome ends the machine with it."""
    # Make the states before opening the machine: SMACH would add every machine made while it is open.
    made = list(states)
    machine = smach.StateMachine(outcomes=list(OUTCOMES))
    followers = [label for label, _ in made[1:]] + [goes_on]
    with machine:
        for (label, state), follower in zip(made, followers):
            smach.StateMachine.add(
                label, state, transitions={**{outcome: outcome for outcome in OUTCOMES}, goes_on: follower}
            )
    return machine
