"""The log of deeds: what was tried for each clause of a command, what runs, and what is planned."""

from dataclasses import dataclass, replace
from datetime import datetime
from typing import Dict, FrozenSet, List, Optional, Sequence, Tuple

from typed_arguments import FilledFrame

#: Clauses that are remembered.
MOST_CLAUSES = 500


@dataclass(frozen=True)
class TriedOnce:
    """A frame that was given to a server and has ended.

    Attributes:
        frame: with its arguments and the server
        is_done: whether it succeeded
        reason: why it did not succeed; empty for success
        ended: local time
        took_s: seconds
    """

    frame: FilledFrame
    is_done: bool
    reason: str
    ended: datetime
    took_s: float


@dataclass(frozen=True)
class TriedClause:
    """A clause of a command, with the frames that were tried for it, in their order.

    Attributes:
        command_id: of its command
        text: of its command, as it was said
        number: of the clause in the plan
        tried: the frames
    """

    command_id: str
    text: str
    number: int
    tried: Tuple[TriedOnce, ...]

    @property
    def done(self) -> Tuple[TriedOnce, ...]:
        """The frames that succeeded."""
        return tuple(one for one in self.tried if one.is_done)

    @property
    def ended(self) -> datetime:
        """When the last frame ended, local time."""
        return self.tried[-1].ended


@dataclass(frozen=True)
class PlannedNode:
    """A node of a plan.

    Attributes:
        kind: of the node, as ``PlanNode`` has it
        children: positions of its children
        number: of the clause, if it is one: its place in the plan, each node before its children
        label: the words of the clause
        frames: the frames of the candidates of a clause
    """

    kind: int
    children: Tuple[int, ...] = ()
    number: int = 0
    label: str = ""
    frames: Tuple[FilledFrame, ...] = ()


@dataclass(frozen=True)
class PlanKinds:
    """The kinds of nodes that decide what runs now; the numbers are those of ``PlanNode``."""

    clause: int
    condition: int
    parallel: int
    repeat: int
    wait: int


class DeedLog:
    """Remembers what was tried, and the plans of the commands that have no reply yet. It is not safe for threads."""

    def __init__(self, kinds: PlanKinds, most: int = MOST_CLAUSES) -> None:
        """
        Args:
            kinds: of nodes
            most: number of clauses that are remembered
        """
        self._kinds = kinds
        self._most = most
        self._clauses: Dict[Tuple[str, int], TriedClause] = {}
        self._plans: Dict[str, Tuple[PlannedNode, ...]] = {}

    @property
    def clauses(self) -> Tuple[TriedClause, ...]:
        """The clauses that were tried, the last one last."""
        return tuple(self._clauses.values())

    def add_tried(self, command_id: str, text: str, number: int, tried: TriedOnce) -> None:
        """A frame of a clause has ended."""
        key = (command_id, number)
        before = self._clauses.pop(key, TriedClause(command_id, text, number, ()))
        self._clauses[key] = replace(before, tried=(*before.tried, tried))
        while len(self._clauses) > self._most:
            del self._clauses[next(iter(self._clauses))]

    def add_plan(self, command_id: str, nodes: Sequence[PlannedNode]) -> None:
        """A command has a plan."""
        self._plans[command_id] = tuple(nodes)
        while len(self._plans) > self._most:
            del self._plans[next(iter(self._plans))]

    def end(self, command_id: str) -> None:
        """A command has its reply."""
        self._plans.pop(command_id, None)

    def running_and_planned(self) -> Tuple[Tuple[PlannedNode, ...], Tuple[PlannedNode, ...]]:
        """Return the clauses that run now, and those that come later."""
        running: List[PlannedNode] = []
        planned: List[PlannedNode] = []
        for command_id, nodes in self._plans.items():
            ended = frozenset(number for one, number in self._clauses if one == command_id)
            now = _active(nodes, 0, ended, self._kinds) or frozenset()
            for position, node in enumerate(nodes):
                if node.kind == self._kinds.clause and position in now:
                    running.append(node)
                elif node.kind == self._kinds.clause and node.number not in ended:
                    planned.append(node)
        return tuple(running), tuple(planned)


def _active(
    nodes: Sequence[PlannedNode], position: int, ended: FrozenSet[int], kinds: PlanKinds
) -> Optional[FrozenSet[int]]:
    """Return the positions of the clauses below a node that run now; none while it waits; None if it is over."""
    if position >= len(nodes):
        return None
    node = nodes[position]
    if node.kind == kinds.clause:
        return None if node.number in ended else frozenset([position])
    if node.kind == kinds.condition:
        return None
    if node.kind == kinds.wait:
        return frozenset()
    if node.kind == kinds.repeat:
        ended = frozenset()  # it does again what it has done
    found = [_active(nodes, child, ended, kinds) for child in node.children]
    active = [one for one in found if one is not None]
    if not active:
        return None
    return frozenset().union(*active) if node.kind == kinds.parallel else active[0]
