"""Judges what the robot would do after a sentence by the formula that the sentence was made from."""

from dataclasses import dataclass
from pathlib import Path
from typing import List, Sequence, Tuple

from frame_registrar.search import Candidate
from offline_pipeline.pipeline import Pipeline, Understanding
from semantic_framer.values.clause_plan import PlanPart, plan_of
from typed_arguments import TypedArgument
from visit_orders.ltl import holds
from visit_orders.simulated_robot import ROOMS, Again, InAnyOrder, InOrder, NoWay, Order, Visit, runs_of

FOLDER = Path(__file__).resolve().parent.parent
FIRST, SECOND = "orders_of_visits.tsv", "orders_of_visits_second.tsv"
RIGHT, ASKED, WRONG = "right", "asked or refused", "wrong"
#: Frames of going somewhere, each with the element that says where to, and whether it goes on until something ends it.
_VISITS = {
    "arriving": ("goal", False),
    "navigating_to_location": ("goal", False),
    "inspecting": ("ground", False),
    "patrolling": ("ground", True),
}
#: Elements that change nothing about which rooms are entered.
_BESIDE = frozenset(["theme", "source", "manner", "direction"])
_ARTICLES = ("the ", "")


class NoVisits(ValueError):
    """The plan has something in it that is no order of visits."""


@dataclass(frozen=True)
class Row:
    """A sentence, the formula that it was made from, and the style in which it is written."""

    formula: str
    sentence: str
    style: str


def rows(table: str = FIRST) -> Tuple[Row, ...]:
    """Return the rows of a table."""
    lines = (FOLDER / table).read_text(encoding="utf-8").splitlines()
    return tuple(Row(*line.split("\t")) for line in lines if not line.startswith("#"))


def judged(pipeline: Pipeline, row: Row) -> Tuple[str, str]:
    """Return RIGHT, ASKED or WRONG, and why: the reply, or what was to be done.

    A plan is right when each of its runs satisfies the formula.
    """
    understanding = pipeline.understand(row.sentence)
    if understanding.reply.outcome != "DONE":
        return ASKED, f"{understanding.reply.code}: {understanding.reply.sentence}"
    try:
        order = order_of(understanding)
        is_right = all(holds(row.formula, run) for run in runs_of(order))
    except (NoVisits, NoWay) as reason:
        return WRONG, str(reason)
    return RIGHT if is_right else WRONG, f"{order}"


def order_of(understanding: Understanding) -> Order:
    """Return the visits that a sentence means.

    Raises:
        NoVisits: something else is to be done
    """
    candidates = understanding.candidates
    clauses = [(reading,) for reading in understanding.readings]
    plan = understanding.plan or plan_of(clauses, understanding.text)
    if plan is None:
        return InOrder(tuple(_deed(found) for found in candidates))
    return _part(plan, candidates)


def _part(part: PlanPart, candidates: Sequence[Sequence[Candidate]]) -> Order:
    if part.kind == "DO":
        return _deed(candidates[part.clause])
    if part.kind in ("SEQUENCE", "ANY_ORDER"):
        parts = tuple(_part(child, candidates) for child in part.children)
        return InOrder(parts) if part.kind == "SEQUENCE" else InAnyOrder(parts)
    if part.kind == "REPEAT" and not part.period_s:
        return Again(_part(part.children[0], candidates), part.count or part.most)
    if part.kind == "UNTIL" and not part.duration_s:
        return _part(part.children[-1], candidates)  # What ends it need never come.
    raise NoVisits(f"{part} is no order of visits")


def _deed(candidates: Sequence[Candidate]) -> Order:
    found: List[Order] = []
    for frame in candidates[0].frames:
        if frame.name not in _VISITS:
            raise NoVisits(f"{frame.name} is no visit")
        element, is_endless = _VISITS[frame.name]
        said = {argument.name: argument for argument in frame.arguments if argument.text}
        other = said.keys() - _BESIDE - {element, "avoided"}
        if other or element not in said:
            raise NoVisits(f"{frame.name} has {sorted(said)}")
        avoided = frozenset(_rooms(said["avoided"])) if "avoided" in said else frozenset()
        visits = InOrder(tuple(Visit(room, avoided) for room in _rooms(said[element])))
        found.append(Again(visits) if is_endless else visits)
    return InOrder(tuple(found))


def _rooms(argument: TypedArgument) -> Tuple[str, ...]:
    if argument.members:
        return tuple(room for member in argument.members for room in _rooms(member))
    for article in _ARTICLES:
        name = argument.text[len(article) :].replace(" ", "_")
        if argument.text.startswith(article) and name in ROOMS:
            return (name,)
    raise NoVisits(f"{argument.text!r} is no room")
