"""Standing orders in a plan: at its root they are kept; elsewhere the robot waits, or repeats, within the plan."""

from dataclasses import replace
from typing import Iterable, Tuple

from semantic_framer.values.clause_plan import PlanPart


class NotAlone(ValueError):
    """A standing order is a part of a longer plan; the text is its words."""


def with_orders_at_the_root(plan: PlanPart) -> PlanPart:
    """Return a plan in which only the root may be a standing order.

    Raises:
        NotAlone: an order for a time of the clock, or for whenever something happens, is not the root
    """
    children = tuple(_inside(child) for child in plan.children)
    return replace(plan, children=_flat(children) if plan.kind == "SEQUENCE" else children)


def with_wait(plan: PlanPart) -> PlanPart:
    """Return a plan that waits in the place of an order for a span of time: "stop in ten seconds"."""
    is_span = plan.kind == "AT" and plan.when is not None and not plan.when.value and plan.when.period_s is None
    return _inside(plan) if is_span else plan


def _flat(children: Iterable[PlanPart]) -> Tuple[PlanPart, ...]:
    """Return the parts of a sequence, without sequences inside it."""
    return tuple(one for child in children for one in (child.children if child.kind == "SEQUENCE" else (child,)))


def _inside(part: PlanPart) -> PlanPart:
    children = tuple(_inside(child) for child in part.children)
    if part.kind == "WHENEVER":
        raise NotAlone(part.label)
    if part.kind == "SEQUENCE":
        return replace(part, children=_flat(children))
    when = part.when
    if part.kind != "AT" or when is None:
        return replace(part, children=children)
    if when.value or (when.offset_s is None and when.period_s is None):
        raise NotAlone(part.label)
    if when.period_s is not None:
        return replace(part, kind="REPEAT", children=children, period_s=when.period_s, when=None)
    # "Go to the kitchen and in five minutes go back" waits between the two.
    wait = PlanPart("WAIT", when.words, duration_s=when.offset_s or 0.0)
    return PlanPart("SEQUENCE", part.label, (wait, *children))
