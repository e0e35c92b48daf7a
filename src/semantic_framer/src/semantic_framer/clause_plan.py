"""How the clauses of a sentence are joined: a tree whose leaves are the clauses, in their order."""

from dataclasses import dataclass
from typing import List, Optional, Sequence, Tuple

from semantic_framer.reading import Reading


@dataclass(frozen=True)
class PlanPart:
    """A node of the tree; the kinds and fields are those of the PlanNode message.

    Attributes:
        kind: name of the kind
        label: the words of the clause, or of all clauses below
        children: in the order of the kind; none for a clause
        count, most: number of times
        duration_s: how long
    """

    kind: str
    label: str
    children: Tuple["PlanPart", ...] = ()
    count: int = 0
    most: int = 0
    duration_s: float = 0.0


def plan_of(clauses: Sequence[Tuple[Reading, ...]], text: str) -> Optional[PlanPart]:
    """Return how clauses are joined; None if they are only done one after the other.

    Args:
        clauses: the readings of each clause, best first
        text: the sentence
    """
    if not any(readings[0].control.is_said for readings in clauses):
        return None
    parts: List[PlanPart] = [_part(readings[0]) for readings in clauses]
    return parts[0] if len(parts) == 1 else PlanPart("SEQUENCE", text, tuple(parts))


def _part(reading: Reading) -> PlanPart:
    control, label = reading.control, reading.clause_text
    part = PlanPart("DO", label)
    words = f"{label} {control.phrase}".strip()
    if control.duration_s:
        # What is done before the time is over begins again.
        part = PlanPart("UNTIL", words, (PlanPart("REPEAT", label, (part,)),), duration_s=control.duration_s)
    if control.count > 1:
        part = PlanPart("REPEAT", words, (part,), count=control.count, most=control.count)
    return part


def nodes_of(part: PlanPart) -> List[Tuple[PlanPart, List[int]]]:
    """Return the nodes of a tree, the root first, each with the positions of its children."""
    nodes: List[Tuple[PlanPart, List[int]]] = [(part, [])]
    for child in part.children:
        position = len(nodes)
        nodes[0][1].append(position)
        nodes += [(below, [position + place for place in places]) for below, places in nodes_of(child)]
    return nodes
