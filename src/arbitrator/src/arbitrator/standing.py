"""Standing orders as values: what is to be done at a time, or whenever something happens.

They are no plans: nothing carries them out now. The node ``standing_orders`` keeps them, and sends what is to be done
as a plan each time.
"""

from dataclasses import dataclass
from typing import Union

from arbitrator.plan import CONDITIONS, AnyCondition, Plan, Trigger
from typed_arguments import TimeExpression


@dataclass(frozen=True)
class At:
    """Carry out a plan at a time, or each time of a set: "every day at eight".

    Attributes:
        label: the words of the whole order
        child: what is to be done
        when: the time

    Raises:
        ValueError: the child is a condition, or another standing order
    """

    label: str
    child: Plan
    when: TimeExpression

    def __post_init__(self) -> None:
        _must_be_plan(self.child)


@dataclass(frozen=True)
class Whenever:
    """Carry out a plan each time a condition begins to hold.

    Attributes:
        label: the words of the whole order
        condition: what is watched; its trigger does not matter
        child: what is to be done

    Raises:
        ValueError: there is no condition, or the child is no plan
    """

    label: str
    condition: AnyCondition
    child: Plan

    def __post_init__(self) -> None:
        if not isinstance(self.condition, CONDITIONS):
            raise ValueError("a whenever has something to do in the place of its condition")
        if self.condition.trigger not in (Trigger.HOLDS, Trigger.BEGINS):
            raise ValueError(f"no condition triggers in the way {self.condition.trigger}")
        _must_be_plan(self.child)


#: What is kept, and not carried out at once.
STANDING = (At, Whenever)
AnyOrder = Union[At, Whenever]


def _must_be_plan(child: object) -> None:
    if isinstance(child, CONDITIONS):
        raise ValueError(f"a standing order has the condition {child.label!r} in the place of something to do")
    if isinstance(child, STANDING):
        raise ValueError(f"a standing order has the standing order {child.label!r} in the place of something to do")
