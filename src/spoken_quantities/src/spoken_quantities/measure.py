"""Measures: a number and a unit, as people say them."""

import math
import re
from dataclasses import dataclass
from typing import Optional

from spoken_quantities.numbers import QuantityError, parse_number
from spoken_quantities.units import find_unit, units_of

#: A number written together with its unit: "10cm", "90°", "3ft".
_JOINED = re.compile(r"^([+-]?[\d.,]+)\s*([^\d\s.,+-].*)$")
#: Words between the number and its unit that carry nothing: "half a metre", "a couple of metres".
_FILLERS = ("of a", "of an", "of the", "of", "a", "an")


@dataclass(frozen=True)
class Measure:
    """An amount of something that can be measured.

    Attributes:
        amount: as it was said
        unit: singular English name of the unit as it was said; empty for a bare number
        quantity: length, angle, duration or number
        si_amount: metres, radians, seconds, or the bare number
    """

    amount: float
    unit: str
    quantity: str
    si_amount: float


def parse_measure(text: str, *, quantity: Optional[str] = None, default_unit: str = "") -> Measure:
    """Read a measure.

    Args:
        text: "3 feet", "half a metre", "a couple of metres", "minus two degrees", "10cm", "90°", "one eighty"
        quantity: length, angle, duration or number, if only that is wanted
        default_unit: unit of a bare number, if it may be left out
    Returns:
        the measure, its amounts finite
    Raises:
        QuantityError: NOT_A_NUMBER, NOT_FINITE, UNKNOWN_UNIT, MISSING_UNIT, WRONG_QUANTITY
    """
    words = " ".join(text.replace("°", " ° ").split())
    if not words:
        raise QuantityError("NOT_A_NUMBER", "No amount was said.")
    joined = _JOINED.match(words)
    head, _, last = words.rpartition(" ")
    unit = find_unit(last)
    number_text = head if unit is not None else words
    if joined and find_unit(joined.group(2)) is not None:
        number_text, unit = joined.group(1), find_unit(joined.group(2))
    elif unit is not None and not head:
        # "a metre" may arrive as "metre"; "metres" alone leaves the amount open.
        number_text = words if last.lower() == "feet" or (last.lower().endswith("s") and len(last) > 2) else "one"
    elif unit is None and default_unit and quantity != "number":
        unit = find_unit(default_unit)
    for filler in _FILLERS:
        if number_text.lower().endswith(" " + filler) and not number_text.lower().startswith("a couple"):
            number_text = number_text[: -len(filler) - 1]
            break
    try:
        amount = parse_number(number_text)
    except QuantityError as error:
        if error.code == "NOT_A_NUMBER" and unit is None and head and _is_number(head):
            raise QuantityError("UNKNOWN_UNIT", f'I do not know the unit "{last}".') from error
        raise
    if unit is None:
        if quantity in (None, "number"):
            return Measure(amount=amount, unit="", quantity="number", si_amount=amount)
        raise QuantityError(
            "MISSING_UNIT", f'"{text.strip()}" needs a unit, such as {", ".join(units_of(quantity)[:3])}.'
        )
    if quantity is not None and unit.quantity != quantity:
        raise QuantityError("WRONG_QUANTITY", f'"{text.strip()}" is no {quantity}.')
    si_amount = amount * unit.si_factor
    if not math.isfinite(si_amount):
        raise QuantityError("NOT_FINITE", f'"{text.strip()}" is more than I can count.')
    return Measure(amount=amount, unit=unit.name, quantity=unit.quantity, si_amount=si_amount)


def _is_number(text: str) -> bool:
    try:
        parse_number(text)
    except QuantityError:
        return False
    return True
