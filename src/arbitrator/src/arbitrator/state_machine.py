"""Builds the SMACH state machine of a plan."""

import re
from typing import Any, Callable, Iterable, List, Optional, Tuple, TypeVar, Union

import smach
from arbitrator.node_runs import (
    ABORTED,
    OUTCOMES,
    PREEMPTED,
    SUCCEEDED,
    Branches,
    NodeRun,
    Observe,
)
from arbitrator.plan import (
    AnyCondition,
    Candidate,
    Do,
    Fallback,
    If,
    InAnyOrder,
    InParallel,
    InSequence,
    Part,
    Plan,
    Repeat,
    Until,
    Wait,
    While,
    walk,
)
from arbitrator.scopes import Cause, Clock, Scope
from arbitrator.waiting_states import AskState, MonitorState, NextRoundState, TimerState, WaitState
from arbitrator.watching import Watch, Watching, watch_nothing
from typed_arguments import FilledFrame

#: Characters of a label. Slashes would read as levels of the machine in the paths that SMACH publishes; smach_viewer
#: puts labels between quotation marks.
_NO_LABEL = re.compile(r"[^\w .,:;!?'()+-]+")
_LONGEST_LABEL = 60
#: A wait for a condition that says no limit gives up after this time, seconds.
LONGEST_WAIT_S = 3600.0
#: Labels of the states of an UNTIL and a WHILE: the work beside its monitor; of a REPEAT: the count.
TOGETHER, MONITOR, NEXT_ROUND = "together", "monitor", "next round"

_AnyMachine = TypeVar("_AnyMachine", bound=smach.StateMachine)
MakeStep = Callable[[FilledFrame, int, Scope], smach.State]


def plan_label(plan: Part) -> str:
    """Label of a plan, or of a part of it: its words."""
    words = " ".join(_NO_LABEL.sub(" ", plan.label).split())
    if len(words) > _LONGEST_LABEL:
        words = words[:_LONGEST_LABEL].rsplit(" ", 1)[0] + " ..."
    return words or "plan"


def child_label(index: int, child: Part) -> str:
    """Label of a part of a plan in the machine that it is in; `index` counts from 0. Words may be said twice."""
    return f"{index + 1} {plan_label(child)}"


def candidate_label(index: int) -> str:
    """Label of a candidate in the machine of its clause; `index` counts from 0."""
    return f"candidate_{index + 1}"


def step_label(index: int, frame: FilledFrame) -> str:
    """Label of a frame in the machine of its candidate; `index` counts from 0."""
    return f"{index + 1}_{frame.name}_by_{frame.server.strip('/').replace('/', '.')}"


class _Root(smach.Container):
    """Ends the whole plan when it is asked to; only the machine of the root is asked from outside."""

    #: Around the whole plan; None for a machine that is not the root.
    plan_scope: Optional[Scope] = None

    def request_preempt(self) -> None:
        """Ask everything that runs to end; returns at once."""
        if self.plan_scope is not None:
            self.plan_scope.cancel(Cause.PREEMPTED)
        super().request_preempt()


class _Machine(_Root, smach.StateMachine):
    """The machine of a node; one state after the other."""

    def __init__(self, run: Optional[NodeRun]) -> None:
        """
        Args:
            run: the node; None for a machine around the only state of a plan
        """
        super().__init__(outcomes=list(OUTCOMES))
        self.node_run = run

    def execute(self, *parent_ud: Any) -> Optional[str]:
        """Run the node."""
        if self.node_run is None:
            return super().execute(*parent_ud)
        return self.node_run.run(lambda: super(_Machine, self).execute(*parent_ud))


class _Concurrence(_Root, smach.Concurrence):
    """The branches of a node at the same time."""

    def __init__(self, branches: Branches, run: Optional[NodeRun]) -> None:
        """
        Args:
            branches: of the node
            run: the node; None for a state of its machine
        """
        super().__init__(
            outcomes=list(OUTCOMES), default_outcome=ABORTED, outcome_cb=lambda outcomes: branches.outcome or None
        )
        self._branches, self.node_run = branches, run

    def execute(self, *parent_ud: Any) -> Optional[str]:
        """Run all branches."""
        if self.node_run is None:
            return self._run_branches(*parent_ud)
        return self.node_run.run(lambda: self._run_branches(*parent_ud))

    def _run_branches(self, *parent_ud: Any) -> Optional[str]:
        return super().execute(*parent_ud) if self._branches.start() else PREEMPTED


def build_state_machine(
    plan: Plan,
    make_step: MakeStep,
    *,
    watch: Watch = watch_nothing,
    observe: Observe = lambda event: None,
    clock: Optional[Clock] = None,
    longest_wait_s: float = LONGEST_WAIT_S,
) -> smach.Container:
    """Build the machine of a plan: a sub-machine for each node, and for each candidate of a clause.

    A frame that fails ends its candidate; the next candidate of the clause starts from its first frame. The first
    candidate whose frames all succeed ends the clause. `arbitrator.plan` says how the nodes join clauses.

    Whatever is preempted ends, and nothing more begins. A node whose condition nobody can tell any more is aborted, and
    what it carried out is cancelled.

    Args:
        plan: what to carry out
        make_step: makes the state of one frame, with the outcomes succeeded, aborted and preempted. Its second argument
            is the number of the clause in `arbitrator.plan.walk`; its third is the scope that the state runs in: it has
            to end when that is cancelled
        watch: watches conditions
        observe: called, while the machine runs, when a node has begun or ended, from the thread of that node
        clock: by which the nodes wait
        longest_wait_s: after which a wait for a condition fails, if it does not say a limit

    Returns:
        a machine with the outcomes succeeded, aborted and preempted; it runs once

    SMACH keeps a stack of open machines for its class: build in one thread at a time.
    """
    scope = Scope(clock or Clock())
    # Make the states before opening the machine: SMACH would add every machine made while it is open.
    root = _Builder(plan, make_step, watch, observe, longest_wait_s).build(plan, scope)
    machine = root if isinstance(root, _Root) else _fill(_Machine(None), [(plan_label(plan), root)], goes_on=SUCCEEDED)
    machine.plan_scope = scope
    return machine


class _Builder:
    def __init__(self, plan: Plan, make_step: MakeStep, watch: Watch, observe: Observe, longest_wait_s: float) -> None:
        self._make_step = make_step
        self._watch = watch
        self._observe = observe
        self._longest_wait_s = longest_wait_s
        # By identity: the same words may be said twice. `walk` yields parts in the order in which they are built.
        self._numbers = iter(range(sum(1 for _ in walk(plan))))

    def build(self, plan: Plan, parent: Scope) -> Any:
        limit_s = plan.limit.seconds
        if isinstance(plan, Wait) and plan.condition is not None:
            limit_s = limit_s or self._longest_wait_s
        run = NodeRun(next(self._numbers), Scope(parent.clock, parent, limit_s=limit_s), self._observe)
        if isinstance(plan, Do):
            return self._do(plan, run)
        if isinstance(plan, InSequence):
            return self._chain(run, plan.children, goes_on=SUCCEEDED)
        if isinstance(plan, Fallback):
            return self._chain(run, plan.children, goes_on=ABORTED)
        if isinstance(plan, InAnyOrder):
            return self._chain(run, plan.children, goes_on=SUCCEEDED, order=plan.order())
        if isinstance(plan, InParallel):
            return self._parallel(plan, run)
        if isinstance(plan, If):
            return self._if(plan, run)
        if isinstance(plan, Wait):
            watching = None if plan.condition is None else self._watching(plan.condition, run)[0]
            return WaitState(plan, run, watching)
        if isinstance(plan, Repeat):
            return self._repeat(plan, run)
        return self._beside_monitor(plan, run)

    def _watching(self, condition: AnyCondition, run: NodeRun) -> Tuple[Watching, int]:
        number = next(self._numbers)
        for _ in list(walk(condition))[1:]:
            next(self._numbers)
        watching = Watching(condition, self._watch, on_change=run.scope.clock.wake)
        run.on_end(watching.close)
        return watching, number

    def _do(self, plan: Do, run: NodeRun) -> smach.State:
        candidates = [
            (candidate_label(index), self._candidate(candidate, run)) for index, candidate in enumerate(plan.candidates)
        ]
        return _fill(_Machine(run), candidates, goes_on=ABORTED)

    def _candidate(self, candidate: Candidate, run: NodeRun) -> smach.State:
        steps = [
            (step_label(index, frame), self._make_step(frame, run.number, run.scope))
            for index, frame in enumerate(candidate.frames)
        ]
        return _fill(smach.StateMachine(outcomes=list(OUTCOMES)), steps, goes_on=SUCCEEDED)

    def _chain(
        self, run: NodeRun, children: Tuple[Plan, ...], *, goes_on: str, order: Tuple[int, ...] = ()
    ) -> smach.State:
        made = [(child_label(index, child), self.build(child, run.scope)) for index, child in enumerate(children)]
        return _fill(_Machine(run), [made[place] for place in order or range(len(made))], goes_on=goes_on)

    def _parallel(self, plan: InParallel, run: NodeRun) -> smach.State:
        wanted = plan.count or len(plan.children)
        succeeded: List[int] = []

        def decide(place: int, outcome: str) -> str:
            if outcome != SUCCEEDED:
                return outcome
            succeeded.append(place)
            return SUCCEEDED if len(succeeded) == wanted else ""

        run.on_end(succeeded.clear)
        # The numbers of the children are known before they are built, and each is built in the scope of its branch.
        sizes = [sum(1 for _ in walk(child)) for child in plan.children]
        ranks = [run.number + 1 + sum(sizes[:place]) for place in range(len(sizes))]
        branches = Branches(run.scope, ranks, decide)
        made = []
        for place, child in enumerate(plan.children):
            state = self.build(child, branches.scopes[place])
            state.node_run.branch = branches, place
            made.append((child_label(place, child), state))
        return _fill_concurrence(_Concurrence(branches, run), made)

    def _if(self, plan: If, run: NodeRun) -> smach.State:
        watching, number = self._watching(plan.condition, run)
        ends_on = "no" if plan.otherwise is None else ""
        ask = AskState(run, watching, number, lambda: watching.holds is True, ends_on=ends_on)
        yes = child_label(1, plan.child), self.build(plan.child, run.scope)
        no = None if plan.otherwise is None else (child_label(2, plan.otherwise), self.build(plan.otherwise, run.scope))
        machine = _Machine(run)
        with machine:
            smach.StateMachine.add(
                child_label(0, plan.condition),
                ask,
                transitions={"yes": yes[0], "no": SUCCEEDED if no is None else no[0]},
            )
            smach.StateMachine.add(*yes)
            if no is not None:
                smach.StateMachine.add(*no)
        return machine

    def _repeat(self, plan: Repeat, run: NodeRun) -> smach.State:
        rounds = NextRoundState(run, times=plan.times, period_s=plan.period_s)
        label = child_label(0, plan.child)
        child = self.build(plan.child, run.scope)
        machine = _Machine(run)
        machine.register_start_cb(lambda userdata, states: rounds.restart())
        with machine:
            smach.StateMachine.add(label, child, transitions={SUCCEEDED: NEXT_ROUND})
            smach.StateMachine.add(NEXT_ROUND, rounds, transitions={"again": label, "done": SUCCEEDED})
        return machine

    def _beside_monitor(self, plan: Union[Until, While], run: NodeRun) -> smach.State:
        """An UNTIL or a WHILE: the child runs beside a state that ends it."""
        if plan.condition is None:
            # Nothing has to be asked first. The timer takes the number of the node, which itself does not wait.
            branches = Branches(run.scope, [run.number, run.number + 1], _decide_beside_monitor)
            timer = TimerState(run, branches, run.number, plan.duration_s)
            return _fill_concurrence(_Concurrence(branches, run), [(MONITOR, timer), self._beside(plan, branches)])
        watching, number = self._watching(plan.condition, run)
        if isinstance(plan, Until):
            ask = AskState(run, watching, number, lambda: watching.has_triggered, ends_on="yes")
            transitions = {"yes": SUCCEEDED, "no": TOGETHER}
        else:
            ask = AskState(run, watching, number, lambda: not watching.has_ended, ends_on="no")
            transitions = {"yes": TOGETHER, "no": SUCCEEDED}
        child_number = number + sum(1 for _ in walk(plan.condition))
        branches = Branches(run.scope, [number, child_number], _decide_beside_monitor)
        monitor = MonitorState(
            run,
            branches,
            watching,
            number,
            (lambda: watching.has_triggered) if isinstance(plan, Until) else (lambda: watching.has_ended),
        )
        both = [(MONITOR, monitor), self._beside(plan, branches)]
        together = _fill_concurrence(_Concurrence(branches, None), both)
        machine = _Machine(run)
        with machine:
            smach.StateMachine.add(child_label(0, plan.condition), ask, transitions=transitions)
            smach.StateMachine.add(TOGETHER, together)
        return machine

    def _beside(self, plan: Union[Until, While], branches: Branches) -> Tuple[str, smach.State]:
        state = self.build(plan.child, branches.scopes[1])
        state.node_run.branch = branches, 1
        return child_label(1, plan.child), state


def _decide_beside_monitor(place: int, outcome: str) -> str:
    """The monitor says whether the work ends; one that was cancelled itself says nothing."""
    return "" if place == 0 and outcome == PREEMPTED else outcome


def _fill(machine: _AnyMachine, states: Iterable[Tuple[str, smach.State]], *, goes_on: str) -> _AnyMachine:
    """Run states one after the other while they end with `goes_on`; another outcome ends the machine with it."""
    # Make the states before opening the machine: SMACH would add every machine made while it is open.
    made = list(states)
    followers = [label for label, _ in made[1:]] + [goes_on]
    with machine:
        for (label, state), follower in zip(made, followers):
            smach.StateMachine.add(
                label, state, transitions={**{outcome: outcome for outcome in OUTCOMES}, goes_on: follower}
            )
    return machine


def _fill_concurrence(machine: smach.Concurrence, states: Iterable[Tuple[str, smach.State]]) -> smach.State:
    with machine:
        for label, state in states:
            smach.Concurrence.add(label, state)
    return machine
