"""What became of each node of a plan that ran."""

import threading
from dataclasses import dataclass, replace
from typing import Dict, List, Tuple

from arbitrator.node_runs import SUCCEEDED, EndedBy, NodeEvent
from arbitrator.plan import Plan, walk
from executor.goal_tracking import Goal


@dataclass(frozen=True)
class NodeRecord:
    """What became of a node.

    Attributes:
        begun: how often it began
        done: how often it succeeded
        outcome: of the last time: succeeded, aborted or preempted; empty when it did not begin or did not end
        ended_by: what ended it the last time
        fault: why nobody could tell whether its condition holds
        goals: every goal that was tried, in order
    """

    begun: int = 0
    done: int = 0
    outcome: str = ""
    ended_by: EndedBy = EndedBy.WORK
    fault: str = ""
    goals: Tuple[Goal, ...] = ()


class RunRecord:
    """Collects the records of one run; any thread may call."""

    def __init__(self, plan: Plan) -> None:
        self._lock = threading.Lock()
        self._records = [NodeRecord() for _ in walk(plan)]
        self._goals: Dict[int, List[Goal]] = {}

    def hear(self, event: NodeEvent) -> None:
        """A node has begun or ended."""
        with self._lock:
            known = self._records[event.number]
            if not event.outcome:
                self._records[event.number] = replace(known, begun=known.begun + 1, outcome="")
                return
            self._records[event.number] = replace(
                known,
                done=known.done + (event.outcome == SUCCEEDED),
                outcome=event.outcome,
                ended_by=event.ended_by,
                fault=event.fault,
            )

    def hear_goal(self, number: int, goal: Goal) -> None:
        """A goal of the clause with this number has ended."""
        with self._lock:
            self._goals.setdefault(number, []).append(goal)

    def records(self) -> Tuple[NodeRecord, ...]:
        """Return what became of each node, as `arbitrator.plan.walk` counts them."""
        with self._lock:
            return tuple(
                replace(record, goals=tuple(self._goals.get(number, ()))) for number, record in enumerate(self._records)
            )
