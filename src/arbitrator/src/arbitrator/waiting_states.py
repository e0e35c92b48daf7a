"""SMACH states that wait: for the answer to a question, for a condition, for a time."""

from typing import Any, Callable, Optional

import smach
from arbitrator.node_runs import ABORTED, OUTCOMES, PREEMPTED, SUCCEEDED, Branches, EndedBy, NodeRun
from arbitrator.plan import Wait
from arbitrator.watching import Watching

#: A repetition without end begins at most this often, seconds: a server that is done at once must not keep it busy.
SHORTEST_ROUND_S = 0.1


class AskState(smach.State):
    """Opens the watch of a condition, and waits for the first answer."""

    def __init__(
        self, run: NodeRun, watching: Watching, rank: int, is_yes: Callable[[], bool], *, ends_on: str = ""
    ) -> None:
        """
        Args:
            run: of the node that asks
            watching: the condition
            rank: its number
            is_yes: whether the answer is yes
            ends_on: the answer that ends the node; empty for none
        """
        super().__init__(outcomes=["yes", "no", ABORTED, PREEMPTED])
        self._run, self._watching, self._rank, self._is_yes, self._ends_on = run, watching, rank, is_yes, ends_on

    def execute(self, userdata: Any) -> str:
        """Return yes or no."""
        watching, scope = self._watching, self._run.scope
        watching.open()
        scope.wait(self._rank, lambda: watching.is_known or bool(watching.fault))
        if scope.is_cancelled:
            return _preempted(self)
        if watching.fault:
            self._run.say(EndedBy.FAULT, fault=watching.fault)
            return ABORTED
        answer = "yes" if self._is_yes() else "no"
        if answer == self._ends_on:
            self._run.say(EndedBy.CONDITION)
        return answer


class MonitorState(smach.State):
    """Waits beside the branch that works, until a condition ends that."""

    def __init__(
        self, run: NodeRun, branches: Branches, watching: Watching, rank: int, is_over: Callable[[], bool]
    ) -> None:
        super().__init__(outcomes=list(OUTCOMES))
        self._run, self._branches = run, branches
        self._watching, self._rank, self._is_over = watching, rank, is_over

    def execute(self, userdata: Any) -> Optional[str]:
        """Return succeeded when the condition ends the work, aborted when nobody can tell any more."""
        return self._branches.run(0, self._watch)

    def _watch(self) -> str:
        scope = self._branches.scopes[0]
        scope.wait(self._rank, lambda: self._is_over() or bool(self._watching.fault))
        if scope.is_cancelled:
            return _preempted(self)
        if self._is_over():
            self._run.say(EndedBy.CONDITION)
            return SUCCEEDED
        self._run.say(EndedBy.FAULT, fault=self._watching.fault)
        return ABORTED


class TimerState(smach.State):
    """Waits beside the branch that works, until a time is over."""

    def __init__(self, run: NodeRun, branches: Branches, rank: int, duration_s: float) -> None:
        super().__init__(outcomes=list(OUTCOMES))
        self._run, self._branches, self._rank, self._duration_s = run, branches, rank, duration_s

    def execute(self, userdata: Any) -> Optional[str]:
        """Return succeeded when the time is over."""
        return self._branches.run(0, self._wait)

    def _wait(self) -> str:
        scope = self._branches.scopes[0]
        scope.wait(self._rank, lambda: False, scope.clock.now_s() + self._duration_s)
        if scope.is_cancelled:
            return _preempted(self)
        self._run.say(EndedBy.TIME)
        return SUCCEEDED


class WaitState(smach.State):
    """A node that waits for a condition, or for a time."""

    def __init__(self, node: Wait, run: NodeRun, watching: Optional[Watching]) -> None:
        super().__init__(outcomes=list(OUTCOMES))
        self._node, self.node_run, self._watching = node, run, watching

    def execute(self, userdata: Any) -> Optional[str]:
        """Return succeeded when that has come."""
        return self.node_run.run(self._wait)

    def _wait(self) -> str:
        scope, watching = self.node_run.scope, self._watching
        if watching is None:
            scope.wait(self.node_run.number, lambda: False, scope.clock.now_s() + self._node.duration_s)
        else:
            watching.open()
            scope.wait(self.node_run.number, lambda: watching.has_triggered or bool(watching.fault))
        if scope.is_cancelled:
            return _preempted(self)
        if watching is None:
            self.node_run.say(EndedBy.TIME)
        elif watching.has_triggered:
            self.node_run.say(EndedBy.CONDITION)
        else:
            self.node_run.say(EndedBy.FAULT, fault=watching.fault)
            return ABORTED
        return SUCCEEDED


class NextRoundState(smach.State):
    """Counts the rounds of a repetition, and waits until the next one is due."""

    def __init__(self, run: NodeRun, *, times: int, period_s: float) -> None:
        """
        Args:
            run: of the repetition
            times: number of rounds; 0 for no end
            period_s: from one beginning to the next
        """
        super().__init__(outcomes=["again", "done", PREEMPTED])
        self._run, self._times = run, times
        self._period_s = period_s if times else max(period_s, SHORTEST_ROUND_S)
        self.restart()

    def restart(self) -> None:
        """The first round begins now."""
        self._rounds = 1
        self._began_s = self._run.scope.clock.now_s()

    def execute(self, userdata: Any) -> str:
        """Return again when the next round is due, done when there is none."""
        if self._rounds == self._times:
            return "done"
        scope = self._run.scope
        scope.wait(self._run.number, lambda: False, self._began_s + self._period_s)
        if scope.is_cancelled:
            return _preempted(self)
        self._rounds, self._began_s = self._rounds + 1, max(scope.clock.now_s(), self._began_s + self._period_s)
        return "again"


def _preempted(state: smach.State) -> str:
    if state.preempt_requested():
        state.service_preempt()
    return PREEMPTED
