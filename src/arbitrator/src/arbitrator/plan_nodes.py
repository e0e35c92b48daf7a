"""Plans as they are sent: a list of nodes that name their children by position. Other graphs than trees are refused."""

import enum
from dataclasses import dataclass
from typing import Dict, List, Sequence, Tuple

from arbitrator.plan import Candidate, Do, InSequence, Plan

#: The most nodes of one plan; a sentence has a handful of clauses.
MOST_NODES = 1000
#: The most frames in all candidates of one plan; each becomes a state of its machine.
MOST_FRAMES = 50_000
#: The most levels of one plan. Each level is a machine inside another one at run time.
MOST_LEVELS = 32


class Kind(enum.IntEnum):
    """Kinds of nodes; the numbers are those of the PlanNode message, which says what each means."""

    DO = 1
    SEQUENCE = 2
    PARALLEL = 3
    ANY_ORDER = 4
    FALLBACK = 5
    IF = 6
    UNTIL = 7
    WHILE = 8
    REPEAT = 9
    WAIT = 10
    AT = 11
    WHENEVER = 12
    CONDITION = 13
    ALL = 14
    ANY = 15


#: Kinds that can be carried out. A plan with another kind is refused as a whole: a part of it would be another command.
CARRIED_OUT = (Kind.DO, Kind.SEQUENCE)


@dataclass(frozen=True)
class Node:
    """A node as it is sent.

    Attributes:
        kind: a number of `Kind`, or an unknown number
        label: words of the clause
        children: positions of the children in the list of nodes
        candidates: candidates of a clause
    """

    kind: int
    label: str
    children: Tuple[int, ...] = ()
    candidates: Tuple[Candidate, ...] = ()


def to_nodes(plan: Plan) -> Tuple[Node, ...]:
    """Return the nodes of a plan, the root first."""
    nodes: List[Node] = []

    def add(part: Plan) -> int:
        position = len(nodes)
        if isinstance(part, Do):
            nodes.append(Node(kind=Kind.DO, label=part.label, candidates=part.candidates))
            return position
        nodes.append(Node(kind=Kind.SEQUENCE, label=part.label))
        children = tuple(add(child) for child in part.children)
        nodes[position] = Node(kind=Kind.SEQUENCE, label=part.label, children=children)
        return position

    add(plan)
    return tuple(nodes)


def from_nodes(nodes: Sequence[Node]) -> Plan:
    """Return the plan of a list of nodes.

    Raises:
        ValueError: the nodes are not a plan; the text says which node is wrong, and why
    """
    levels = _levels(nodes)
    plans: Dict[int, Plan] = {}
    # Deepest first: children are built before their parent.
    for position in sorted(levels, key=lambda position: -levels[position]):
        node = nodes[position]
        try:
            if node.kind == Kind.DO:
                plans[position] = Do(label=node.label, candidates=node.candidates)
            else:
                plans[position] = InSequence(label=node.label, children=tuple(plans[child] for child in node.children))
        except ValueError as error:
            raise ValueError(f"node {position} of the plan is wrong: {error}") from error
    return plans[0]


def _levels(nodes: Sequence[Node]) -> Dict[int, int]:
    """Return the level of each node, 0 for the root.

    Raises:
        ValueError: the nodes are not a tree, too many or too deep, or a node has fields that its kind does not allow
    """
    if not nodes:
        raise ValueError("the plan has no nodes")
    if len(nodes) > MOST_NODES:
        raise ValueError(f"the plan has {len(nodes)} nodes, and may have {MOST_NODES}")
    frames = sum(len(candidate.frames) for node in nodes for candidate in node.candidates)
    if frames > MOST_FRAMES:
        raise ValueError(f"the candidates of the plan have {frames} frames, and may have {MOST_FRAMES}")
    parents: Dict[int, int] = {}
    for position, node in enumerate(nodes):
        _check_kind(position, node)
        for child in node.children:
            if not 0 <= child < len(nodes):
                raise ValueError(f"node {position} of the plan has the child {child}, but there is no such node")
            if child == 0:
                raise ValueError(f"node {position} of the plan has the root for a child")
            if child in parents:
                raise ValueError(f"node {child} of the plan has two parents: {parents[child]} and {position}")
            parents[child] = position
    # Each node has at most one parent, and the root has none: the nodes below the root form a tree.
    levels: Dict[int, int] = {}
    below = [0]
    for level in range(MOST_LEVELS):
        levels.update(dict.fromkeys(below, level))
        below = [child for position in below for child in nodes[position].children]
    if below:
        raise ValueError(f"the plan has more than {MOST_LEVELS} levels")
    lost = [str(position) for position in range(len(nodes)) if position not in levels]
    if lost:
        raise ValueError(
            f"nodes {', '.join(lost[:10])} of the plan are not reached from its root: no parent, or a cycle"
        )
    return levels


def _check_kind(position: int, node: Node) -> None:
    if node.kind not in CARRIED_OUT:
        kind = f"{node.kind} ({Kind(node.kind).name})" if node.kind in list(Kind) else f"{node.kind}"
        known = ", ".join(f"{kind.value} ({kind.name})" for kind in CARRIED_OUT)
        raise ValueError(
            f"node {position} of the plan is of the kind {kind}; nothing carries out other kinds than {known}"
        )
    if node.kind == Kind.DO and node.children:
        raise ValueError(f"node {position} of the plan carries out a clause, and cannot have children")
    if node.kind != Kind.DO and node.candidates:
        raise ValueError(f"node {position} of the plan joins clauses, and cannot have candidates")
