"""Numbers in English words and digits."""

import math
import re
from typing import Dict, List, Optional, Sequence

_ONES = (
    "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen "
    "seventeen eighteen nineteen"
).split()
_TENS = "twenty thirty forty fifty sixty seventy eighty ninety".split()
_SMALL: Dict[str, int] = {word: value for value, word in enumerate(_ONES)}
_SMALL.update({word: 20 + 10 * index for index, word in enumerate(_TENS)})
_SMALL.update({"oh": 0, "fourty": 40})
_MULTIPLIERS: Dict[str, float] = {"dozen": 12.0, "hundred": 1e2, "thousand": 1e3, "million": 1e6}
_FRACTIONS: Dict[str, float] = {
    "half": 0.5,
    "third": 1 / 3,
    "quarter": 0.25,
    "fourth": 0.25,
    "halves": 0.5,
    "thirds": 1 / 3,
    "quarters": 0.25,
}
_SIGNS = {"minus": -1.0, "negative": -1.0, "plus": 1.0}
#: Words in front of a number that leave its amount as it is.
_HEDGES = {"about", "around", "approximately", "roughly", "exactly", "another", "some", "just"}
_DIGITS = re.compile(r"[+-]?(\d+(,\d{3})+|\d+)?(\.\d+)?(e[+-]?\d+)?$", re.IGNORECASE)


class QuantityError(ValueError):
    """Words that are not the quantity that was asked for.

    Attributes:
        code: stable name: NOT_A_NUMBER, NOT_FINITE, UNKNOWN_UNIT, MISSING_UNIT, WRONG_QUANTITY
    """

    def __init__(self, code: str, sentence: str) -> None:
        """
        Args:
            code: stable name of the reason
            sentence: for a person
        """
        super().__init__(sentence)
        self.code = code


def number_words() -> Sequence[str]:
    """Return the words that numbers are made of, "and" and the articles left out."""
    return tuple(_SMALL) + tuple(_MULTIPLIERS) + tuple(_FRACTIONS) + tuple(_SIGNS) + ("couple", "few")


def parse_number(text: str) -> float:
    """Read a number in digits or in English words.

    Args:
        text: "120", "-2.5", "1,000", "three", "minus two", "one hundred and twenty", "one eighty" (180), "two and a half",
            "half a", "a couple of" (2), "a dozen", "a"
    Returns:
        the number
    Raises:
        QuantityError: NOT_A_NUMBER, NOT_FINITE ("1e400")
    """
    words = text.lower().replace("-", " - ").split() if not _is_digits(text) else [text.strip()]
    # "twenty-one" is two words, "-2" and "- 2" are a sign and a number.
    words = ["minus" if word == "-" and index == 0 else word for index, word in enumerate(words)]
    words = [word for word in words if word != "-" and word not in _HEDGES]
    sign = 1.0
    while words and words[0] in _SIGNS:
        sign *= _SIGNS[words.pop(0)]
    value = _parse_unsigned(words)
    if value is None:
        raise QuantityError("NOT_A_NUMBER", f'"{text.strip()}" is not a number.')
    if not math.isfinite(value):
        raise QuantityError("NOT_FINITE", f'"{text.strip()}" is more than I can count.')
    return sign * value


def _is_digits(text: str) -> bool:
    stripped = text.strip()
    return bool(_DIGITS.match(stripped)) and any(character.isdigit() for character in stripped)


def _parse_unsigned(words: List[str]) -> Optional[float]:
    if not words:
        return None
    if len(words) == 1 and _is_digits(words[0]):
        return float(words[0].replace(",", ""))
    if len(words) == 3 and words[1] == "/" or len(words) == 1 and re.match(r"\d+/\d+$", words[0]):
        numerator, denominator = "".join(words).split("/")
        return float(numerator) / float(denominator) if float(denominator) else math.inf
    if words[0] in ("a", "an", "one") and words[1:] and words[1] in ("couple", "few"):
        return ({"couple": 2.0, "few": 3.0}[words[1]]) if words[2:] in ([], ["of"]) else None
    if words in (["a"], ["an"]):
        return 1.0
    halves = _fraction_at_end(words)
    if halves is not None:
        return halves
    if "point" in words:
        return _decimal(words)
    return _whole(words)


def _fraction_at_end(words: List[str]) -> Optional[float]:
    """Read "half a", "a quarter of a", "two and a half", "three quarters"; None when it is none of them."""
    words = list(words)
    while words[-1:] in (["a"], ["an"], ["of"], ["the"]):
        words.pop()
    if not words or words[-1] not in _FRACTIONS:
        return None
    fraction = _FRACTIONS[words.pop()]
    if words and words[-1] in ("a", "an", "one"):
        words.pop()
        if words and words[-1] == "and":
            whole = _parse_unsigned(words[:-1])
            return None if whole is None else whole + fraction
        return None if words else fraction
    if not words:
        return fraction
    count = _whole(words)
    return None if count is None else count * fraction


def _decimal(words: List[str]) -> Optional[float]:
    split = words.index("point")
    whole = _whole(words[:split]) if split else 0.0
    digits = [_SMALL.get(word, int(word) if word.isdigit() and len(word) == 1 else None) for word in words[split + 1 :]]
    if whole is None or not digits or any(digit is None or digit > 9 for digit in digits):
        return None
    return whole + float("0." + "".join(str(digit) for digit in digits))


def _whole(words: List[str]) -> Optional[float]:
    """Read "one hundred and twenty", "one eighty", "two dozen", "3 hundred"."""
    total = 0.0
    group: Optional[float] = None
    before: Optional[str] = None
    for word in words:
        if word == "and":
            if before not in ("hundred", "thousand", "million"):
                return None
        elif word in ("a", "an") and before is None:
            group = 1.0
        elif word in _SMALL or _is_digits(word):
            value = float(_SMALL[word]) if word in _SMALL else float(word.replace(",", ""))
            group = _append(group, value, before)
            if group is None:
                return None
        elif word in _MULTIPLIERS:
            factor = _MULTIPLIERS[word]
            group = (1.0 if group is None else group) * factor
            if factor >= 1e3:
                total, group = total + group, None
        else:
            return None
        before = word
    if before == "and" or (group is None and total == 0.0):
        return None
    return total + (group or 0.0)


def _append(group: Optional[float], value: float, before: Optional[str]) -> Optional[float]:
    """Put a number word behind those before it; None when English does not say it so."""
    if group is None:
        return value
    if before in ("hundred", "and") or (before is not None and before not in _SMALL and group % 100 == 0):
        return group + value if value < 100 else None
    if group % 10 == 0 and 20 <= group % 100 and value < 10 and value > 0:
        return group + value
    # "one eighty" is said for 180, "one twenty five" continues it.
    if group < 10 and 10 <= value < 100:
        return group * 100 + value
    return None
