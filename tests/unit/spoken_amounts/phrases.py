"""Sentences with amounts: carriers x units x numerals, each with the motion that the base must make."""

import math
import random
from dataclasses import dataclass
from fractions import Fraction
from typing import List, Optional, Tuple

from .numerals import ENDINGS, Chance, Numeral, hedged, open_numeral, plain, signed

SEED = 9
#: The resulting motion: "straight" in metres, forward; "turn" in radians, to the left.
Motion = Tuple[str, float]

#: Singular, plural, largest number used, and size in metres or radians.
_LENGTHS: Tuple[Tuple[str, str, int, float], ...] = (
    ("metre", "metres", 18, 1.0),
    ("meter", "meters", 18, 1.0),
    ("foot", "feet", 19, 0.3048),
    ("inch", "inches", 90, 0.0254),
    ("yard", "yards", 19, 0.9144),
    ("centimetre", "centimetres", 99, 0.01),
    ("centimeter", "centimeters", 99, 0.01),
    ("millimetre", "millimetres", 99, 0.001),
)
_ANGLES: Tuple[Tuple[str, str, int, float], ...] = (
    ("degree", "degrees", 360, math.pi / 180.0),
    ("degree", "degrees", 360, math.pi / 180.0),
    ("radian", "radians", 6, 1.0),
    ("turn", "turns", 4, 2.0 * math.pi),
)
_SHORT = {
    "metre": "m",
    "centimetre": "cm",
    "foot": "ft",
    "inch": "in",
    "millimetre": "mm",
    "degree": "deg",
    "radian": "rad",
}
_MOST_METRES = 20.0
_MOST_RAD = 20.0 * math.pi

#: Carriers with their sign; "{a}" is the amount.
_STRAIGHT: Tuple[Tuple[str, int], ...] = (
    ("move forward {a}", 1),
    ("move {a} forward", 1),
    ("go forward {a}", 1),
    ("go {a}", 1),
    ("drive ahead {a}", 1),
    ("drive {a} ahead", 1),
    ("roll forwards {a}", 1),
    ("please drive forward {a}", 1),
    ("could you move forward {a}", 1),
    ("robot, go straight {a}", 1),
    ("I want you to move forward {a}", 1),
    ("move backwards {a}", -1),
    ("move back {a}", -1),
    ("drive {a} backwards", -1),
    ("back up {a}", -1),
    ("reverse {a}", -1),
    ("please go back {a} now", -1),
)
_TURN: Tuple[Tuple[str, int], ...] = (
    ("turn left {a}", 1),
    ("turn {a} to the left", 1),
    ("turn {a} left", 1),
    ("rotate left by {a}", 1),
    ("turn to the left {a}", 1),
    ("spin {a} counterclockwise", 1),
    ("could you turn left {a}", 1),
    ("turn around {a}", 1),
    ("turn right {a}", -1),
    ("turn {a} to the right", -1),
    ("rotate {a} right", -1),
    ("rotate {a} clockwise", -1),
    ("please turn right {a} slowly", -1),
    ("turn to your right {a}", -1),
    ("pivot right {a} please", -1),
)
#: "{a}" is a share of a turn, or degrees in the singular.
_NOUN_TURN: Tuple[Tuple[str, int], ...] = (
    ("make {a} turn to the left", 1),
    ("make {a} turn to the right", -1),
    ("do {a} turn to the left", 1),
    ("could you make {a} turn to the right", -1),
    ("turn left {a} turn", 1),
)
#: A direction in which a base cannot move; it must not take another one.
_ASTRAY = (
    "walk to your left {a}",
    "move {a} to the right",
    "go sideways {a}",
    "drive up {a}",
    "go {a} diagonally",
    "drive sideways {a}",
    "move {a} to your left",
    "walk {a} upwards",
    "go to the left {a}",
    "move left {a}",
)


@dataclass(frozen=True)
class Phrase:
    """A sentence.

    Attributes:
        text: the words
        motions: the required motions, in order; None if the robot must ask or refuse
        family: kind of amount
        is_within_limits: whether the robot may do it; beyond its limits it must refuse
    """

    text: str
    motions: Optional[Tuple[Motion, ...]]
    family: str
    is_within_limits: bool = True


def generate(count: int, seed: int = SEED) -> List[Phrase]:
    """Return ``count`` different sentences; the same for the same seed."""
    chance = random.Random(seed)
    found = {}
    while len(found) < count:
        phrase = _phrase(chance)
        found.setdefault(phrase.text, phrase)
    return list(found.values())


def _phrase(chance: Chance) -> Phrase:
    kind = chance.random()
    if kind < 0.60:
        return _written(chance, _simple(chance))
    if kind < 0.67:
        first, second = _simple(chance), _simple(chance)
        joint = chance.choice([" and then ", ", then ", " and "])
        motions = (first.motions or ()) + (second.motions or ())
        is_within = first.is_within_limits and second.is_within_limits
        return _written(chance, Phrase(first.text + joint + second.text, motions, "two commands", is_within))
    if kind < 0.71:
        return _written(chance, _several_units(chance))
    if kind < 0.75:
        carrier = chance.choice(_ASTRAY)
        singular, plural, most, _ = chance.choice(_LENGTHS)
        numeral = plain(chance, most)
        amount = _amount(chance, numeral, singular, plural)
        return _written(chance, Phrase(carrier.format(a=amount), None, "direction that is not understood"))
    return _written(chance, _open(chance))


def _written(chance: Chance, phrase: Phrase) -> Phrase:
    text = phrase.text
    if chance.random() < 0.7:
        text = text[0].upper() + text[1:]
    if chance.random() < 0.7:
        text += "?" if text.lower().startswith("could") else "."
    return Phrase(text, phrase.motions, phrase.family, phrase.is_within_limits)


def _simple(chance: Chance) -> Phrase:
    kind = chance.random()
    if kind < 0.5:
        return _of_unit(chance, "straight", _STRAIGHT, chance.choice(_LENGTHS))
    if kind < 0.92:
        return _of_unit(chance, "turn", _TURN, chance.choice(_ANGLES))
    carrier, sign = chance.choice(_NOUN_TURN)
    if chance.random() < 0.5:
        share, words = chance.choice(
            [
                (Fraction(1, 4), "quarter"),
                (Fraction(1, 2), "half"),
                (Fraction(3, 4), "three quarter"),
                (Fraction(1), "full"),
            ]
        )
        amount, value = f"a {words}", float(share) * 2.0 * math.pi
        if carrier.startswith("turn left") and words == "full":
            amount = "one full"
    else:
        degrees = chance.choice([10, 30, 45, 60, 90, 120, 135, 180])
        amount, value = f"a {degrees}{chance.choice(['-', ' '])}degree", math.radians(degrees)
        if carrier.startswith("turn left"):
            carrier = "make {a} turn to the left"
    return Phrase(carrier.format(a=amount), (("turn", sign * value),), "noun of a turn")


def _of_unit(
    chance: Chance, kind: str, carriers: Tuple[Tuple[str, int], ...], unit: Tuple[str, str, int, float]
) -> Phrase:
    singular, plural, most, size = unit
    carrier, sign = chance.choice(carriers)
    numeral = plain(chance, most)
    chosen = chance.random()
    if chosen < 0.12:
        numeral = signed(chance, numeral)
    elif chosen < 0.2 and numeral.family != "article" and not numeral.text.startswith("a "):
        numeral = hedged(chance, numeral)
    # Nobody says "go a third"; "move around 5" means to go round something.
    amount = _amount(chance, numeral, singular, plural)
    value = sign * float(numeral.value) * size
    is_within = abs(value) <= (_MOST_METRES if kind == "straight" else _MOST_RAD)
    return Phrase(carrier.format(a=amount), ((kind, value),), numeral.family, is_within)


def _amount(chance: Chance, numeral: Numeral, singular: str, plural: str) -> str:
    is_written = numeral.text[-1].isdigit()
    if is_written and singular in _SHORT and chance.random() < 0.25:
        return numeral.text + chance.choice([" ", ""]) + _SHORT[singular]
    if is_written and singular == "degree" and chance.random() < 0.15:
        return numeral.text + "°"
    if numeral.is_share:
        if numeral.text.endswith("half"):
            between = chance.choice([" a ", " "]) if numeral.text == "half" else " "
            return f"{numeral.text}{between}{singular}"
        return f"{numeral.text} of a{'n' if singular[0] == 'i' else ''} {singular}"
    if numeral.text[-1] in "½¼¾⅓⅔⅛" or "/" in numeral.text:
        return f"{numeral.text} {singular if abs(numeral.value) < 1 else plural}"
    if numeral.family.endswith("article"):
        return f"{numeral.text}{'n' if singular[0] == 'i' and numeral.text.endswith('a') else ''} {singular}"
    return f"{numeral.text} {singular if abs(numeral.value) == 1 else plural}"


def _several_units(chance: Chance) -> Phrase:
    carrier, sign = chance.choice(_STRAIGHT)
    feet, inches = chance.randint(1, 9), chance.randint(1, 11)
    kind = chance.randint(0, 4)
    if kind == 0:
        text, value = f"{feet} feet {inches} inches", feet * 0.3048 + inches * 0.0254
    elif kind == 1:
        text, value = f"{feet} feet and {inches} inches", feet * 0.3048 + inches * 0.0254
    elif kind == 2:
        text, value = f"{feet + 1} metres {chance.choice([25, 50, 75])}", 0.0
        value = feet + 1 + float(text.split()[-1]) / 100
    elif kind == 3:
        text, value = f"{feet + 1} m {inches * 5} cm", feet + 1 + inches * 0.05
    else:
        text, value = chance.choice(
            [("a metre and a half", 1.5), ("two metres and a half", 2.5), ("a foot and a half", 0.4572)]
        )
    return Phrase(carrier.format(a=text), (("straight", sign * value),), "several units")


def _open(chance: Chance) -> Phrase:
    is_turn = chance.random() < 0.5
    singular, plural, most, _ = chance.choice(_ANGLES if is_turn else _LENGTHS)
    carrier, _ = chance.choice(_TURN if is_turn else _STRAIGHT)
    if chance.random() < 0.2:
        numeral = plain(chance, most)
        # "Sixteen feet five" means sixteen feet and five inches.
        ending = chance.choice([ending for ending in ENDINGS if ending != "five" or singular != "foot"])
        return Phrase(carrier.format(a=f"{_amount(chance, numeral, singular, plural)} {ending}"), None, "ending")
    said, family = open_numeral(chance, most)
    return Phrase(carrier.format(a=f"{said} {plural}"), None, family)
