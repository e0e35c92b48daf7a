"""Numbers as people say and write them, some of them ambiguous."""

import random
from dataclasses import dataclass
from fractions import Fraction
from typing import Callable, Dict, List, Tuple, Union

Chance = random.Random
Number = Union[int, Fraction]

_ONES = (
    "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen "
    "seventeen eighteen nineteen"
).split()
_TENS = "zero ten twenty thirty forty fifty sixty seventy eighty ninety".split()
_SHARES: Tuple[Tuple[Fraction, str, str, str], ...] = (
    (Fraction(1, 2), "half", "1/2", "½"),
    (Fraction(1, 4), "a quarter", "1/4", "¼"),
    (Fraction(3, 4), "three quarters", "3/4", "¾"),
    (Fraction(1, 3), "a third", "1/3", "⅓"),
    (Fraction(2, 3), "two thirds", "2/3", "⅔"),
    (Fraction(1, 8), "an eighth", "1/8", "⅛"),
)


@dataclass(frozen=True)
class Numeral:
    """A number as it is said.

    Attributes:
        text: "forty-five", "3 1/2"
        value: the number
        family: the kind of spelling
        is_share: whether "of a" or "a" stands between it and its unit: "three quarters of a turn"
    """

    text: str
    value: Number
    family: str
    is_share: bool = False


def in_words(number: int, joint: str = "-", and_word: str = "and ") -> str:
    """Return a number below 1000 in words."""
    if number >= 100:
        rest = number % 100
        return f"{_ONES[number // 100]} hundred" + (f" {and_word}{in_words(rest, joint)}" if rest else "")
    if number < 20:
        return _ONES[number]
    return _TENS[number // 10] + (joint + _ONES[number % 10] if number % 10 else "")


def _digits(chance: Chance, most: int) -> Numeral:
    value = chance.randint(1, most)
    return Numeral(str(value), value, "digits")


def _decimal_digits(chance: Chance, most: int) -> Numeral:
    whole, places = chance.randint(0, most - 1), chance.choice([1, 2])
    rest = chance.randint(1, 10**places - 1)
    text = f"{whole}.{rest:0{places}d}"
    return Numeral(text if whole or chance.random() < 0.7 else text[1:], Fraction(text), "decimal digits")


def _small_words(chance: Chance, most: int) -> Numeral:
    value = chance.randint(1, min(most, 19))
    return Numeral(_ONES[value], value, "words below 20")


def _decade(chance: Chance, most: int) -> Numeral:
    del most
    value = chance.choice([number for number in range(21, 100) if number % 10])
    joint = chance.choice(["-", "-", " ", "\u2011", "\u2013"])
    family = "decades with a blank" if joint == " " else "decades with a hyphen"
    return Numeral(in_words(value, joint), value, family)


def _tens(chance: Chance, most: int) -> Numeral:
    del most
    value = chance.randint(2, 9) * 10
    return Numeral(in_words(value), value, "tens")


def _hundreds(chance: Chance, most: int) -> Numeral:
    del most
    value = chance.randint(100, 399)
    words = in_words(value, chance.choice(["-", " "]), chance.choice(["and ", ""]))
    if value < 200 and chance.random() < 0.5:
        words = "a" + words[len("one") :]
    return Numeral(words, value, "hundreds")


def _short_hundreds(chance: Chance, most: int) -> Numeral:
    del most
    first, rest = chance.randint(1, 3), chance.choice([5, 8, 20, 35, 45, 60, 70, 80, 90])
    if rest < 10:
        return Numeral(f"{_ONES[first]} oh {_ONES[rest]}", first * 100 + rest, "one oh five")
    return Numeral(f"{_ONES[first]} {in_words(rest)}", first * 100 + rest, "one eighty")


def _share(chance: Chance, most: int) -> Numeral:
    del most
    value, words, ratio, sign = chance.choice(_SHARES)
    text = chance.choice([words, words if words.startswith("a") else words.replace(" ", "-"), ratio, sign])
    return Numeral(text, value, "shares", is_share=text not in (ratio, sign))


def _mixed(chance: Chance, most: int) -> Numeral:
    value, words, ratio, sign = chance.choice(_SHARES[:5])
    whole = chance.randint(1, min(most, 19))
    name = chance.choice([_ONES[whole], str(whole)])
    text = chance.choice(
        [
            f"{name} and {'a half' if words == 'half' else words}",
            f"{_ONES[whole]} and {'a half' if words == 'half' else words}",
            f"{whole} {ratio}",
            f"{whole}{sign}",
            f"{whole} and {ratio}",
        ]
    )
    if text.endswith("and a half") and chance.random() < 0.3:
        text = text.replace(" ", "-")
    return Numeral(text, whole + value, "mixed numbers")


def _decimal_words(chance: Chance, most: int) -> Numeral:
    whole, rest = chance.randint(0, min(most, 30)), chance.randint(1, 99)
    digits = " ".join(_ONES[int(digit)] for digit in str(rest))
    lead = chance.choice(["zero ", ""]) if whole == 0 else in_words(whole) + " "
    return Numeral(f"{lead}point {digits}", Fraction(f"{whole}.{rest}"), "point")


def _article(chance: Chance, most: int) -> Numeral:
    del chance, most
    return Numeral("a", 1, "article")


_PLAIN: Dict[Callable[[Chance, int], Numeral], int] = {
    _digits: 12,
    _decimal_digits: 6,
    _small_words: 8,
    _decade: 14,
    _tens: 4,
    _hundreds: 5,
    _short_hundreds: 4,
    _share: 8,
    _mixed: 12,
    _decimal_words: 5,
    _article: 2,
}


def plain(chance: Chance, most: int) -> Numeral:
    """Return a number as people say it; ``most`` is roughly the largest in digits and small words."""
    return chance.choices(list(_PLAIN), list(_PLAIN.values()))[0](chance, most)


def signed(chance: Chance, numeral: Numeral) -> Numeral:
    """Return a number with a sign."""
    is_written = numeral.text[0].isdigit() or numeral.text[0] == "."
    marks = ["minus ", "negative "] + (["-", "\u2212", "-"] if is_written else ["-"])
    if numeral.is_share or numeral.family == "article":
        marks = ["minus "]
    return Numeral(
        chance.choice(marks) + numeral.text, -numeral.value, "sign and " + numeral.family, is_share=numeral.is_share
    )


_HEDGES = ("about", "exactly", "approximately", "another", "roughly", "around", "just", "almost")


def hedged(chance: Chance, numeral: Numeral) -> Numeral:
    """Return a number with a word before it that does not change its amount."""
    text = f"{chance.choice(_HEDGES)} {numeral.text}"
    return Numeral(text, numeral.value, "hedge and " + numeral.family, is_share=numeral.is_share)


def _two(chance: Chance, most: int) -> Tuple[str, str]:
    first = chance.randint(1, most)
    second = first + chance.randint(1, most)
    if chance.random() < 0.5:
        return in_words(first), in_words(second)
    return str(first), str(second)


def _range(chance: Chance, most: int) -> str:
    first, second = _two(chance, most)
    between = chance.choice([" to ", " or ", "-", " - ", " or maybe ", " till ", "\u2013", " to about ", ", "])
    # "Eighty-one hundred" and "one-eighty" are one number each.
    is_one = f"{first}-{second}" in ("one-eighty", "two-seventy", "three-sixty")
    if is_one or (first in _TENS[2:] and second.split()[0] in _ONES[1:10]):
        between = " to "
    return f"{first}{between}{second}"


def _opened_range(chance: Chance, most: int) -> str:
    first, second = _two(chance, most)
    return chance.choice([f"between {first} and {second}", f"from {first} to {second}"])


def _negated(chance: Chance, most: int) -> str:
    return (
        chance.choice(["not ", "no ", "never ", "not even ", "no more than ", "anything but "])
        + plain(chance, most).text
    )


def _bounded(chance: Chance, most: int) -> str:
    bounds = ["less than ", "more than ", "at least ", "at most ", "up to ", "fewer than ", "under ", "a maximum of "]
    return chance.choice(bounds) + str(chance.randint(2, most))


def _in_a_row(chance: Chance, most: int) -> str:
    first, second = _two(chance, min(most, 9))
    return chance.choice(
        [f"{first} {first}", f"{second} {first}", f"{first} {second} {first}", f"{first}, uh, {second}"]
    )


def _stray(chance: Chance, most: int) -> str:
    number = chance.randint(2, most)
    return chance.choice(
        [
            f"e{number}",
            f"1e{number}e{number}",
            f"{number},5",
            f"{number} 000",
            f"{number}.{number}.{number}",
            f"--{number}",
            f"+-{number}",
            f"x{number}",
            f"{number}x",
            f"{number}%",
            f"- {number}",
            f"{number} percent of",
            f"{number}ish",
            "umpteen",
            f"${number}",
            f"{number}:30",
            f"{10 * number}/{10 * number + 5}",
            f"0x{number}",
            f"minus minus {number}",
            f"{number} thousand {number}000",
            f"{_ONES[number % 9 + 1]} hundred hundred",
            f"{_ONES[number % 8 + 1]}-{_ONES[number % 8 + 2]}",
            f"half {number}",
            f"{number} half",
            f"twice {number}",
            f"{number} dozen {number}",
            "five ten",
            f"nine {chance.choice(['twelve', 'eleven', 'fifteen'])}",
            f"{number} and",
            f"and a half {number}",
            "a dozen and a half",
            "several",
            f"{number} point {number + 10}",
            f"{number} out of {number + 1}",
            f"{number} times {number}",
            f"{number} squared",
        ]
    )


_OPEN: Dict[str, Tuple[Callable[[Chance, int], str], int]] = {
    "range": (_range, 8),
    "opened range": (_opened_range, 4),
    "negated": (_negated, 5),
    "bounded": (_bounded, 4),
    "numbers in a row": (_in_a_row, 4),
    "stray": (_stray, 10),
}


def open_numeral(chance: Chance, most: int) -> Tuple[str, str]:
    """Return words with numbers in them that do not name one number, and their family."""
    family = chance.choices(list(_OPEN), [weight for _, weight in _OPEN.values()])[0]
    return _OPEN[family][0](chance, most), family


#: Words after an amount that make it ambiguous.
ENDINGS: List[str] = [
    "minus one",
    "plus one",
    "or two",
    "or more",
    "or less",
    "per second",
    "at most",
    "and a bit",
    "times two",
    "minus a half",
    "to three",
    "five",
]
