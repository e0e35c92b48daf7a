"""Plans as they are sent: a list of nodes that name their children by position. Other graphs than trees are refused."""

import enum
from dataclasses import dataclass, fields, replace
from typing import Any, Callable, Dict, FrozenSet, List, Optional, Sequence, Tuple, Union

from arbitrator.plan import (
    CONDITIONS,
    AllOf,
    AnyOf,
    Candidate,
    Condition,
    Do,
    Fallback,
    If,
    InAnyOrder,
    InParallel,
    InSequence,
    Limit,
    Part,
    Plan,
    Repeat,
    Trigger,
    Until,
    Wait,
    While,
    parts_of,
)
from arbitrator.standing import STANDING, AnyOrder, At, Whenever
from typed_arguments import TimeExpression

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


@dataclass(frozen=True)
class Node:
    """A node as it is sent.

    Attributes:
        kind: a number of `Kind`, or an unknown number
        label: words of the clause
        children: positions of the children in the list of nodes
        candidates: candidates of a clause
        after, count, most, duration_s, period_s, limit_s, is_limit_said, trigger, is_negated: as in the message; times
            in seconds
        when: time of a standing order
    """

    kind: int
    label: str
    children: Tuple[int, ...] = ()
    candidates: Tuple[Candidate, ...] = ()
    after: Tuple[int, ...] = ()
    count: int = 0
    most: int = 0
    duration_s: float = 0.0
    period_s: float = 0.0
    limit_s: float = 0.0
    is_limit_said: bool = False
    trigger: int = Trigger.HOLDS
    is_negated: bool = False
    when: Optional[TimeExpression] = None

    @property
    def limit(self) -> Limit:
        """The limit of its time."""
        return Limit(self.limit_s, self.is_limit_said)


_Children = Tuple[Any, ...]


@dataclass(frozen=True)
class _Reader:
    """How the nodes of one kind become a value.

    Attributes:
        make: makes the value of a node and of the values of its children; raises ValueError
        least, most: number of children
        uses: the fields that the kind has a use for, besides label, children and candidates
    """

    make: Callable[[Node, _Children], Any]
    least: int
    most: int
    uses: FrozenSet[str]


_LIMIT = frozenset({"limit_s", "is_limit_said"})
_TRUTH = frozenset({"trigger", "is_negated"})


def _if(node: Node, children: _Children) -> If:
    otherwise = children[2] if len(children) == 3 else None
    return If(node.label, children[0], children[1], otherwise, node.limit)


def _until(node: Node, children: _Children) -> Until:
    condition = children[0] if len(children) == 2 else None
    return Until(node.label, children[-1], condition, node.duration_s, node.limit)


def _at(node: Node, children: _Children) -> Any:
    if node.when is None:
        raise ValueError("an AT has no time")
    return At(node.label, children[0], node.when)


def _condition(kind: Callable[..., Part]) -> Callable[[Node, _Children], Part]:
    return lambda node, children: kind(node.label, children, Trigger(node.trigger), node.is_negated)


_READERS: Dict[Kind, _Reader] = {
    Kind.DO: _Reader(lambda node, _: Do(node.label, node.candidates, node.limit), 0, 0, _LIMIT),
    Kind.SEQUENCE: _Reader(lambda node, children: InSequence(node.label, children, node.limit), 0, MOST_NODES, _LIMIT),
    Kind.PARALLEL: _Reader(
        lambda node, children: InParallel(node.label, children, node.count, node.limit),
        0,
        MOST_NODES,
        _LIMIT | {"count"},
    ),
    # `after` belongs to the children, which see `_order_of`.
    Kind.ANY_ORDER: _Reader(
        lambda node, children: InAnyOrder(node.label, children, limit=node.limit), 0, MOST_NODES, _LIMIT
    ),
    Kind.FALLBACK: _Reader(lambda node, children: Fallback(node.label, children, node.limit), 0, MOST_NODES, _LIMIT),
    Kind.IF: _Reader(_if, 2, 3, _LIMIT),
    Kind.UNTIL: _Reader(_until, 1, 2, _LIMIT | {"duration_s"}),
    Kind.WHILE: _Reader(lambda node, children: While(node.label, children[0], children[1], node.limit), 2, 2, _LIMIT),
    Kind.REPEAT: _Reader(
        lambda node, children: Repeat(node.label, children[0], node.count, node.most, node.period_s, node.limit),
        1,
        1,
        _LIMIT | {"count", "most", "period_s"},
    ),
    Kind.WAIT: _Reader(
        lambda node, children: Wait(node.label, children[0] if children else None, node.duration_s, node.limit),
        0,
        1,
        _LIMIT | {"duration_s"},
    ),
    Kind.AT: _Reader(_at, 1, 1, frozenset({"when"})),
    Kind.WHENEVER: _Reader(lambda node, children: Whenever(node.label, children[0], children[1]), 2, 2, frozenset()),
    Kind.CONDITION: _Reader(
        lambda node, _: Condition(node.label, node.candidates, Trigger(node.trigger), node.is_negated), 0, 0, _TRUTH
    ),
    Kind.ALL: _Reader(_condition(AllOf), 0, MOST_NODES, _TRUTH),
    Kind.ANY: _Reader(_condition(AnyOf), 0, MOST_NODES, _TRUTH),
}
#: Kinds that are understood. A plan with another kind is refused as a whole: a part of it would be another command.
CARRIED_OUT = tuple(_READERS)

_KIND_OF: Dict[type, Kind] = {
    Do: Kind.DO,
    InSequence: Kind.SEQUENCE,
    InParallel: Kind.PARALLEL,
    InAnyOrder: Kind.ANY_ORDER,
    Fallback: Kind.FALLBACK,
    If: Kind.IF,
    Until: Kind.UNTIL,
    While: Kind.WHILE,
    Repeat: Kind.REPEAT,
    Wait: Kind.WAIT,
    At: Kind.AT,
    Whenever: Kind.WHENEVER,
    Condition: Kind.CONDITION,
    AllOf: Kind.ALL,
    AnyOf: Kind.ANY,
}
_WITH_CANDIDATES = (Kind.DO, Kind.CONDITION)


def kind_of(part: Union[Part, AnyOrder]) -> Kind:
    """Return the kind of node that a part of a plan is sent as."""
    return _KIND_OF[type(part)]


def to_nodes(plan: Union[Plan, AnyOrder]) -> Tuple[Node, ...]:
    """Return the nodes of a plan or a standing order, the root first."""
    nodes: List[Node] = []

    def add(part: Any) -> int:
        position = len(nodes)
        nodes.append(_node_without_children(part))
        children = tuple(add(child) for child in parts_of(part))
        nodes[position] = replace(nodes[position], children=children)
        if isinstance(part, InAnyOrder):
            for child, after in zip(children, part.after):
                nodes[child] = replace(nodes[child], after=tuple(children[before] for before in after))
        return position

    add(plan)
    return tuple(nodes)


def _node_without_children(part: Any) -> Node:
    values = {field.name: getattr(part, field.name) for field in fields(part)}
    limit = values.pop("limit", Limit())
    known = {field.name for field in fields(Node)} - {"children", "after"}
    given = {name: value for name, value in values.items() if name in known}
    return Node(kind=kind_of(part), limit_s=limit.seconds, is_limit_said=limit.is_said, **given)


def from_nodes(nodes: Sequence[Node]) -> Plan:
    """Return the plan of a list of nodes.

    Raises:
        ValueError: the nodes are not a plan that can be carried out now; the text says which node is wrong, and why
    """
    plan = any_from_nodes(nodes)
    if isinstance(plan, STANDING):
        raise ValueError(f"node 0 of the plan is a standing order ({kind_of(plan).name}): nothing is to be done now")
    return plan


def any_from_nodes(nodes: Sequence[Node]) -> Union[Plan, AnyOrder]:
    """Return the plan or the standing order of a list of nodes.

    Raises:
        ValueError: the nodes are neither; the text says which node is wrong, and why
    """
    levels = _levels(nodes)
    parts: Dict[int, Any] = {}
    # Deepest first: children are built before their parent.
    for position in sorted(levels, key=lambda position: -levels[position]):
        node = nodes[position]
        try:
            part = _READERS[Kind(node.kind)].make(node, tuple(parts[child] for child in node.children))
            if isinstance(part, InAnyOrder):
                part = replace(part, after=_orders(nodes, node.children))
        except ValueError as error:
            raise ValueError(f"node {position} of the plan is wrong: {error}") from error
        parts[position] = part
    if isinstance(parts[0], CONDITIONS):
        raise ValueError("node 0 of the plan is a condition, and nothing is to be done")
    plan: Union[Plan, AnyOrder] = parts[0]
    return plan


def _orders(nodes: Sequence[Node], children: Sequence[int]) -> Tuple[Tuple[int, ...], ...]:
    """Return for each child which of its siblings come before it, by their place among them."""
    places = {child: place for place, child in enumerate(children)}
    for child in children:
        strangers = [before for before in nodes[child].after if before not in places or before == child]
        if strangers:
            raise ValueError(f"node {child} is to come after node {strangers[0]}, which is none of its siblings")
    orders = tuple(tuple(places[before] for before in nodes[child].after) for child in children)
    return orders if any(orders) else ()


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
    level, below = 0, [0]
    while below:
        if level == MOST_LEVELS:
            raise ValueError(f"the plan has more than {MOST_LEVELS} levels")
        levels.update(dict.fromkeys(below, level))
        level, below = level + 1, [child for position in below for child in nodes[position].children]
    lost = [str(position) for position in range(len(nodes)) if position not in levels]
    if lost:
        raise ValueError(
            f"nodes {', '.join(lost[:10])} of the plan are not reached from its root: no parent, or a cycle"
        )
    for position, node in enumerate(nodes):
        if position and node.kind in (Kind.AT, Kind.WHENEVER):
            raise ValueError(
                f"node {position} of the plan is of the kind {Kind(node.kind).name}; "
                "a standing order is no part of a plan"
            )
        if node.after and (position == 0 or nodes[parents[position]].kind != Kind.ANY_ORDER):
            raise ValueError(f"node {position} of the plan sets after; only a child of an ANY_ORDER has a use for it")
    return levels


def _check_kind(position: int, node: Node) -> None:
    if node.kind not in CARRIED_OUT:
        said = f"{node.kind} ({Kind(node.kind).name})" if node.kind in list(Kind) else f"{node.kind}"
        known = ", ".join(f"{one.value} ({one.name})" for one in CARRIED_OUT)
        raise ValueError(
            f"node {position} of the plan is of the kind {said}; nothing carries out other kinds than {known}"
        )
    kind = Kind(node.kind)
    reader = _READERS[kind]
    if kind in _WITH_CANDIDATES and node.children:
        raise ValueError(f"node {position} of the plan carries out a clause, and cannot have children")
    if kind not in _WITH_CANDIDATES and node.candidates:
        raise ValueError(f"node {position} of the plan joins clauses, and cannot have candidates")
    if not reader.least <= len(node.children) <= reader.most:
        raise ValueError(
            f"node {position} of the plan has {len(node.children)} children; a {kind.name} has {reader.least} to "
            f"{reader.most}"
        )
    unused = [name for name in _CHOSEN if name not in reader.uses and getattr(node, name) != getattr(_PLAIN, name)]
    if unused:
        names = ", ".join(name.replace("_s", "") if name.endswith("_s") else name for name in unused)
        raise ValueError(f"node {position} of the plan sets {names}; a {kind.name} has no use for it")


_PLAIN = Node(kind=Kind.DO, label="")
#: Fields that only some kinds have a use for.
_CHOSEN = tuple(
    field.name for field in fields(Node) if field.name not in ("kind", "label", "children", "candidates", "after")
)
