"""How the clauses of a sentence are joined: a tree whose leaves are the clauses."""

from dataclasses import dataclass, replace
from typing import Iterator, List, Mapping, Optional, Sequence, Tuple

from semantic_framer.values.reading import Reading
from semantic_frames.frame import SemanticFrame
from typed_arguments import TimeExpression

CONDITION = "CONDITION"
#: Kinds of nodes that are clauses.
LEAVES = ("DO", CONDITION)


@dataclass(frozen=True)
class PlanPart:
    """A node of the tree; the kinds and fields are those of the PlanNode message.

    Attributes:
        kind: name of the kind
        label: the words of the clause, or of all clauses below
        children: in the order of the kind; none for a clause
        count, most: number of times
        duration_s: how long
        period_s: from one beginning to the next
        limit_s: the longest time that was said; 0 for none
        trigger: HOLDS or BEGINS
        is_negated: whether the opposite of a condition is meant
        clause: position of a clause among the clauses of the sentence
        when: time of an AT
    """

    kind: str
    label: str
    children: Tuple["PlanPart", ...] = ()
    count: int = 0
    most: int = 0
    duration_s: float = 0.0
    period_s: float = 0.0
    limit_s: float = 0.0
    trigger: str = "HOLDS"
    is_negated: bool = False
    clause: int = -1
    when: Optional[TimeExpression] = None

    @property
    def is_endless(self) -> bool:
        """Whether it is done again and again until something else ends it."""
        return self.kind == "REPEAT" and not (self.count or self.most or self.period_s or self.limit_s)

    def __str__(self) -> str:
        """Return the tree in one line: 'IF(the door is closed, open it)'."""
        if self.kind in LEAVES:
            said = f"not {self.label}" if self.is_negated else self.label
            return f"{said} anew" if self.trigger == "BEGINS" else said
        fields = []
        if self.count or self.most:
            fields.append(f"{self.count}" if self.count == self.most else f"{self.count} to {self.most or 'any'}")
        fields += [f"{self.duration_s:g} s"] if self.duration_s else []
        fields += [f"every {self.period_s:g} s"] if self.period_s else []
        fields += [f"at most {self.limit_s:g} s"] if self.limit_s else []
        fields += [self.when.words] if self.when else []
        name = f"not {self.kind}" if self.is_negated else self.kind
        return f"{name}({', '.join(fields + [str(child) for child in self.children])})"


Clauses = Tuple[Tuple[Reading, ...], ...]
_LOOPS = ("UNTIL", "WHILE")


def plan_of(clauses: Sequence[Tuple[Reading, ...]], text: str) -> Optional[PlanPart]:
    """Return how clauses are joined; None if they are only done one after the other.

    Args:
        clauses: the readings of each clause, best first
        text: the sentence
    """
    if not any(readings[0].control.is_said for readings in clauses):
        return None
    parts: List[PlanPart] = [part_of(readings[0], place) for place, readings in enumerate(clauses)]
    return parts[0] if len(parts) == 1 else PlanPart("SEQUENCE", text, tuple(parts))


def part_of(reading: Reading, clause: int) -> PlanPart:
    """Return the node of one clause, with how often and how long it is done.

    Args:
        reading: its best reading
        clause: its position among the clauses
    """
    control, label = reading.control, reading.clause_text
    part = PlanPart("DO", label, clause=clause)
    words = f"{label} {control.phrase}".strip()
    if control.duration_s:
        # What is done before the time is over begins again.
        part = PlanPart("UNTIL", words, (PlanPart("REPEAT", label, (part,)),), duration_s=control.duration_s)
    if control.count > 1:
        part = PlanPart("REPEAT", words, (part,), count=control.count, most=control.count)
    elif control.is_kept_up and part.kind == "DO":
        part = PlanPart("REPEAT", label, (part,))
    return part


def leaves_of(part: PlanPart) -> Iterator[PlanPart]:
    """Yield the clauses of a tree in the order of its nodes."""
    if part.kind in LEAVES:
        yield part
    for child in part.children:
        yield from leaves_of(child)


def in_order(clauses: Clauses, plan: PlanPart) -> Tuple[Clauses, PlanPart]:
    """Return the clauses of a plan in the order of its nodes, and the plan of these."""
    order = [leaf.clause for leaf in leaves_of(plan)]
    return tuple(clauses[place] for place in order), _renumbered(plan, order)


def without_unused(clauses: Clauses, plan: PlanPart) -> Tuple[Clauses, PlanPart]:
    """Return the clauses that a plan uses, in the order in which they were said, and the plan of these."""
    used = sorted(leaf.clause for leaf in leaves_of(plan))
    return tuple(clauses[place] for place in used), _renumbered(plan, used)


def _renumbered(part: PlanPart, used: Sequence[int]) -> PlanPart:
    children = tuple(_renumbered(child, used) for child in part.children)
    return replace(part, children=children, clause=used.index(part.clause) if part.clause >= 0 else -1)


def nodes_of(part: PlanPart) -> List[Tuple[PlanPart, List[int]]]:
    """Return the nodes of a tree, the root first, each with the positions of its children."""
    nodes: List[Tuple[PlanPart, List[int]]] = [(part, [])]
    for child in part.children:
        position = len(nodes)
        nodes[0][1].append(position)
        nodes += [(below, [position + place for place in places]) for below, places in nodes_of(child)]
    return nodes


def answers_in_a_loop(
    part: PlanPart,
    clauses: Sequence[Tuple[Reading, ...]],
    frames: Mapping[str, SemanticFrame],
    *,
    is_loop: bool = False,
) -> bool:
    """Whether something that is answered at once is to go on: "go on until you see a wall" resumes what waits."""
    if part.clause >= 0:
        return is_loop and frames[clauses[part.clause][0].unit.frame_name].is_question
    is_loop = is_loop or part.kind in _LOOPS
    return any(answers_in_a_loop(child, clauses, frames, is_loop=is_loop) for child in part.children)
