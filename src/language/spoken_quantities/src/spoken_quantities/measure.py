"""Measures: a number and a unit, as people say them."""

import math
import re
from dataclasses import dataclass
from typing import Dict, List, Optional, Tuple

from spoken_quantities.numbers import QuantityError, find_number, parse_number, plain_digits
from spoken_quantities.units import DEGREE_SIGNS, Unit, find_unit, units_of

#: A number written together with its unit: "10cm", "90°", "3ft".
_JOINED = re.compile(r"^([+-]?[\d.,]+)\s*([^\d\s.,+-].*)$")
#: Words without meaning between the number and its unit: "half a metre", "a couple of metres".
_FILLERS = ("of a", "of an", "of the", "of", "a", "an")
#: Words between the number and its unit that do not change the amount: "a full turn", "two more metres".
_EMPHASIS = ("full", "whole", "complete", "entire", "more", "further", "additional", "extra")
#: "90-degree", "two-metre".
_HYPHEN_BEFORE_UNIT = re.compile(r"(?<=[\w])-(?=([a-z]+)$)", re.IGNORECASE)
_DEGREE_SIGN = re.compile(f"[{DEGREE_SIGNS}]")
#: "5ft 6in", "5'6\"", "1h30": numbers and units may touch.
_BETWEEN_DIGITS_AND_UNITS = re.compile(r"(?<=\d)(?=[a-z'\"])|(?<=[a-z'\"])(?=\d)")
#: For each unit: how many of the smaller unit a bare number after it counts make one, and the least number that is said
#: like this. "Five foot six" is six inches; "two metres fifty" is fifty centimetres, but "two metres five" may be five
#: centimetres or half a metre.
_PARTS: Dict[str, Tuple[int, int]] = {
    "foot": (12, 1),
    "metre": (100, 10),
    "kilometre": (1000, 100),
    "hour": (60, 1),
    "minute": (60, 1),
}


@dataclass(frozen=True)
class Measure:
    """An amount of something that can be measured.

    Attributes:
        amount: the number, in the unit that was said
        unit: singular English name of the unit that was said; empty for a bare number
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
        text: "3 feet", "half a metre", "a couple of metres", "minus two degrees", "10cm", "90°", "one eighty"; also a
            measure in two units or more, "5 feet 6 inches", "five foot six", "two metres fifty", "an hour and a half",
            whose amount is given in the first unit (5.5 feet)
        quantity: length, angle, duration or number, to accept only that one
        default_unit: unit of a bare number, if the unit may be left out

    Returns:
        the measure; its amounts are finite

    Raises:
        QuantityError: NOT_A_NUMBER, NOT_FINITE, UNKNOWN_UNIT, MISSING_UNIT, WRONG_QUANTITY
    """
    text = _DEGREE_SIGN.sub(" ° ", plain_digits(text))
    try:
        return _parse_single(text, quantity, default_unit)
    except QuantityError as error:
        compound = _parse_compound(text) if error.code in ("NOT_A_NUMBER", "UNKNOWN_UNIT") else None
        if compound is None:
            raise
    if quantity is not None and compound.quantity != quantity:
        raise QuantityError("WRONG_QUANTITY", f'"{text.strip()}" is no {quantity}.')
    return compound


def _parse_compound(text: str) -> Optional[Measure]:
    """Read a measure in several units, or None. Each part must be less than one of the unit before it."""
    words = _BETWEEN_DIGITS_AND_UNITS.sub(" ", text.lower()).split()
    position = next((index for index, word in enumerate(words) if index and find_unit(word)), len(words))
    unit = find_unit(words[position]) if position < len(words) - 1 else None
    if unit is None:
        return None
    try:
        first = _parse_single(" ".join(words[: position + 1]), None, "")
        rest = _amount_behind(words[position + 1 :], unit)
    except QuantityError:
        return None
    if rest is None or not first.amount.is_integer():
        return None
    amount = first.amount + math.copysign(rest, first.amount)
    return Measure(amount=amount, unit=unit.name, quantity=unit.quantity, si_amount=amount * unit.si_factor)


def _amount_behind(words: List[str], unit: Unit) -> Optional[float]:
    """Read the words after a unit as a share of that unit: "6 inches", "six", "and a half"; None for other words.

    Raises:
        QuantityError: the words are not a measure
    """
    is_joined = words[0] == "and"
    words = words[1:] if is_joined else words
    if not words or words[0] in ("minus", "negative", "plus") or words[0][0] in "+-":
        return None
    number = find_number(" ".join(words))
    if number is not None:
        if is_joined:
            return number if 0.0 < number < 1.0 else None
        divisor, least = _PARTS.get(unit.name, (1, 1))
        return number / divisor if least <= number < divisor and number.is_integer() else None
    if len(words) < 2:
        return None
    rest = parse_measure(" ".join(words), quantity=unit.quantity)
    share = rest.si_amount / unit.si_factor
    return share if 0.0 < share < 1.0 and rest.unit != unit.name else None


def _parse_single(text: str, quantity: Optional[str], default_unit: str) -> Measure:
    """Read a measure in one unit; the arguments and errors of :func:`parse_measure`."""
    words = " ".join(text.split())
    words = _HYPHEN_BEFORE_UNIT.sub(lambda hyphen: " " if find_unit(hyphen.group(1)) else "-", words)
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
    if unit is not None and number_text.rpartition(" ")[2].lower() in _EMPHASIS:
        number_text = number_text.rpartition(" ")[0]
    for filler in _FILLERS:
        counted = number_text[: -len(filler) - 1].lower()
        is_filler = number_text.lower() == f"{counted} {filler}" and not counted.startswith("a couple")
        # In "minus a metre" the article is the number.
        if is_filler and counted not in ("minus", "plus", "negative"):
            number_text = counted
            break
    try:
        amount = parse_number(number_text)
    except QuantityError as error:
        if error.code == "NOT_A_NUMBER" and unit is None and head and find_number(head) is not None:
            raise QuantityError("UNKNOWN_UNIT", f'I do not know the unit "{last}".') from error
        raise
    if unit is None:
        if quantity is None or quantity == "number":
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
