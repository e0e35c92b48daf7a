"""Units of measure in English, and their factors to the units of REP 103: metres, radians, seconds."""

import math
from dataclasses import dataclass
from typing import Dict, Optional, Tuple


@dataclass(frozen=True)
class Unit:
    """A unit of measure.

    Attributes:
        name: singular English name
        quantity: length, angle, duration or speed
        si_factor: metres, radians, seconds, or metres per second in one of it
        is_assumed: whether nobody knows how much it is, and the factor is a stated default: a step
    """

    name: str
    quantity: str
    si_factor: float
    is_assumed: bool = False


_SPELLINGS: Tuple[Tuple[Unit, str], ...] = (
    (Unit("metre", "length", 1.0), "metre metres meter meters m mtr mtrs mts"),
    (Unit("centimetre", "length", 0.01), "centimetre centimetres centimeter centimeters cm cms"),
    (Unit("millimetre", "length", 0.001), "millimetre millimetres millimeter millimeters mm mms"),
    (Unit("decimetre", "length", 0.1), "decimetre decimetres decimeter decimeters dm"),
    (Unit("kilometre", "length", 1000.0), "kilometre kilometres kilometer kilometers km kms"),
    (Unit("foot", "length", 0.3048), "foot feet ft '"),
    (Unit("inch", "length", 0.0254), 'inch inches in "'),
    (Unit("yard", "length", 0.9144), "yard yards yd yds"),
    (Unit("mile", "length", 1609.344), "mile miles mi"),
    (Unit("step", "length", 0.5, is_assumed=True), "step steps"),
    (Unit("degree", "angle", math.pi / 180.0), "degree degrees deg degs °"),
    (Unit("radian", "angle", 1.0), "radian radians rad rads"),
    (Unit("turn", "angle", 2.0 * math.pi), "turn turns revolution revolutions rotation rotations circle circles"),
    (Unit("second", "duration", 1.0), "second seconds sec secs s"),
    (Unit("millisecond", "duration", 0.001), "millisecond milliseconds ms msec msecs"),
    (Unit("minute", "duration", 60.0), "minute minutes min mins"),
    (Unit("hour", "duration", 3600.0), "hour hours h hr hrs"),
    (Unit("metre per second", "speed", 1.0), "m/s mps"),
    (Unit("kilometre per hour", "speed", 1.0 / 3.6), "km/h kmh kph"),
    (Unit("mile per hour", "speed", 0.44704), "mph"),
)
#: What keyboards have for the sign of degrees, beside the sign itself: the ordinal mark of Spanish, Portuguese and
#: Italian keys, the ring above, the ring operator, a raised zero and a raised letter.
DEGREE_SIGNS = "°\u00ba\u02da\u2218\u2070\u1d52"
_UNITS: Dict[str, Unit] = {spelling: unit for unit, spellings in _SPELLINGS for spelling in spellings.split()}


def find_unit(word: str) -> Optional[Unit]:
    """Return the unit that an English word or symbol names, singular or plural; None for other words."""
    return _UNITS.get(word.strip(" .").lower())


def unit_words() -> Tuple[str, ...]:
    """Return every spelling of every unit."""
    return tuple(_UNITS)


def units_of(quantity: str) -> Tuple[str, ...]:
    """Return the singular names of the units of a quantity."""
    return tuple(unit.name for unit, _ in _SPELLINGS if unit.quantity == quantity)
