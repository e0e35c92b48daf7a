"""Reads numbers, lengths, angles and durations in English words, and converts them to SI units."""

from spoken_quantities.measure import Measure, parse_measure
from spoken_quantities.numbers import (
    QuantityError,
    find_number,
    find_whole_number,
    number_words,
    parse_number,
    plain_digits,
)
from spoken_quantities.units import DEGREE_SIGNS, Unit, find_unit, unit_words, units_of

__all__ = [
    "DEGREE_SIGNS",
    "Measure",
    "QuantityError",
    "Unit",
    "find_number",
    "find_unit",
    "find_whole_number",
    "number_words",
    "parse_measure",
    "parse_number",
    "plain_digits",
    "unit_words",
    "units_of",
]
