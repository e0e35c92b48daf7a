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
_DIGIT_OF: Dict[str, int] = {word: value for word, value in _SMALL.items() if value < 10}
_DIGIT_OF.update({str(value): value for value in range(10)})
#: Words in front of a number that leave its amount as it is.
_HEDGES = {"about", "around", "approximately", "roughly", "exactly", "another", "some", "just"}
_JOINING_HYPHEN = re.compile(r"(?<=[a-z])-(?=[a-z])")
_LEADING_SIGN = re.compile(r"^\s*-\s*(?=[^\s-])")
_RATIO = re.compile(r"(\d{1,9})\s*/\s*(\d{1,9})$", re.ASCII)
_DIGITS = re.compile(r"[+]?(\d+(,\d{3})+|\d+)?(\.\d+)?(e[+-]?\d+)?$", re.IGNORECASE | re.ASCII)


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
    # Between two words a hyphen joins ("twenty-one"); between digits it is a range ("100-50"), which is no number.
    spelled = _JOINING_HYPHEN.sub(" ", text.lower().replace("\u2212", "-"))
    words = [word for word in _LEADING_SIGN.sub("minus ", spelled).split() if word not in _HEDGES]
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
    """Whether a text is a number in digits, without a minus."""
    return bool(_DIGITS.match(text)) and any(character.isdigit() for character in text)


def _parse_unsigned(words: List[str]) -> Optional[float]:
    if not words:
        return None
    if len(words) == 1 and _is_digits(words[0]):
        return float(words[0].replace(",", ""))
    ratio = _RATIO.match(" ".join(words))
    if ratio:
        numerator, denominator = (float(part) for part in ratio.groups())
        return numerator / denominator if denominator else math.inf
    if words[0] in ("a", "an", "one") and words[1:] and words[1] in ("couple", "few"):
        return ({"couple": 2.0, "few": 3.0}[words[1]]) if words[2:] in ([], ["of"]) else None
    if words in (["a"], ["an"]):
        return 1.0
    if words[-2:] == ["a", "dozen"] and words[:-2] == ["half"] or words == ["half", "dozen"]:
        return 6.0
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
    name = words.pop()
    fraction = _FRACTIONS[name]
    if words[-1:] == ["and"]:
        words.append("a")
    if words and words[-1] in ("a", "an", "one"):
        words.pop()
        if words and words[-1] == "and":
            whole = _parse_unsigned(words[:-1])
            return None if whole is None else whole + fraction
        return None if words else fraction
    if not words:
        return fraction
    # "twenty third" is a place in a row; "three quarter" is said before a noun ("a three quarter turn").
    if not name.endswith("s") and name != "quarter":
        return None
    count = _whole(words)
    return None if count is None else count * fraction


def _decimal(words: List[str]) -> Optional[float]:
    split = words.index("point")
    whole = _whole(words[:split]) if split else 0.0
    digits = [_DIGIT_OF.get(word) for word in words[split + 1 :]]
    if whole is None or not digits or None in digits:
        return None
    return whole + float("0." + "".join(str(digit) for digit in digits))


def _whole(words: List[str]) -> Optional[float]:
    """Read "one hundred and twenty", "one eighty", "two dozen", "3 hundred"."""
    total = 0.0
    group: Optional[float] = None
    before: Optional[str] = None
    largest = math.inf
    for word in words:
        if word == "and":
            if before not in ("hundred", "thousand", "million"):
                return None
        elif word in ("a", "an"):
            if before is not None or words[1:2] not in (["dozen"], ["hundred"], ["thousand"], ["million"]):
                return None
            group = 1.0
        elif word in _SMALL or _is_digits(word):
            value = float(_SMALL[word]) if word in _SMALL else float(word.replace(",", ""))
            group = _append(group, value, before, is_word=word in _SMALL)
            if group is None:
                return None
        elif word in _MULTIPLIERS:
            factor = _MULTIPLIERS[word]
            # Thousands come before hundreds, and each once: "one hundred two hundred" is two numbers.
            if factor >= largest or (group is None and before is not None) or before == "and":
                return None
            if factor < 1e3 and group is not None and group >= 100:
                return None
            group = (1.0 if group is None else group) * factor
            if factor >= 1e3:
                total, group, largest = total + group, None, factor
        else:
            return None
        before = word
    if before == "and" or before is None:
        return None
    return total + (group or 0.0)


def _append(group: Optional[float], value: float, before: Optional[str], *, is_word: bool) -> Optional[float]:
    """Put a number behind the words before it; None when English does not say it so."""
    if group is None:
        return value
    if before == "dozen":
        return None
    if before in ("hundred", "and"):
        return group + value if value < 100 else None
    if not is_word or before not in _SMALL:
        # "100 50" and "20 3" are two numbers, whatever their sum is.
        return None
    if group % 10 == 0 and 20 <= group % 100 and 0 < value < 10:
        return group + value
    # "one eighty" is said for 180, "one twenty five" continues it.
    if 1 <= group < 10 <= value < 100:
        return group * 100 + value
    return None
