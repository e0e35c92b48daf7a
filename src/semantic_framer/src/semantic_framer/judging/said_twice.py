"""Finds a deed with an amount that is said twice with nothing between, "turn left 2 turn left two".

Speech recognisers write one number in two ways.
"""

from typing import FrozenSet, Sequence, Tuple

from semantic_framer.values.reading import Reading


def said_twice(readings: Sequence[Reading]) -> str:
    """Return the words of the first deed that follows itself at once with the same amount; empty if none does.

    Args:
        readings: of each clause in their order, the best one
    """
    for first, second in zip(readings, readings[1:]):
        before, behind = _positions(first), _positions(second)
        is_at_once = bool(before) and bool(behind) and min(behind) == max(before) + 1
        has_amount = any(one.measure is not None and one.positions for one in second.arguments)
        if is_at_once and has_amount and _said(first) == _said(second):
            return first.clause_text
    return ""


def _positions(reading: Reading) -> FrozenSet[int]:
    return frozenset(reading.verb_positions).union(*(one.positions for one in reading.arguments))


def _said(reading: Reading) -> Tuple[object, ...]:
    values = ((one.name, one.measure.si if one.measure is not None else one.text.lower()) for one in reading.arguments)
    return (reading.unit.frame_name, *sorted(values, key=str))
