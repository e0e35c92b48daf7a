"""Reads numbers in English words and digits."""

import math
import re
import unicodedata
from typing import Dict, List, Optional, Sequence

_ONES = (
    "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen "
    "seventeen eighteen nineteen"
).split()
_TENS = "twenty thirty forty fifty sixty seventy eighty ninety".split()
_SMALL: Dict[str, int] = {word: value for value, word in enumerate(_ONES)}
_SMALL.update({word: 20 + 10 * index for index, word in enumerate(_TENS)})
_SMALL.update({"fourty": 40})
#: A zero among other digits ("one oh five" is 105); alone it is an exclamation.
_OH = "oh"
_MULTIPLIERS: Dict[str, float] = {"dozen": 12.0, "hundred": 1e2, "thousand": 1e3, "million": 1e6}
_NAMES_OF_FRACTIONS: Dict[str, int] = {
    "half": 2,
    "third": 3,
    "quarter": 4,
    "fourth": 4,
    "fifth": 5,
    "sixth": 6,
    "seventh": 7,
    "eighth": 8,
    "ninth": 9,
    "tenth": 10,
}
_FRACTIONS: Dict[str, float] = {name: 1.0 / parts for name, parts in _NAMES_OF_FRACTIONS.items()}
_FRACTIONS.update({name + "s": share for name, share in _FRACTIONS.items() if name != "half"})
_FRACTIONS["halves"] = 0.5
#: The only words that are a number without another word beside them.
_WHOLE_NUMBERS = frozenset(["a", "an"]).union(_SMALL, _MULTIPLIERS, _FRACTIONS)
_SIGNS = {"minus": -1.0, "negative": -1.0, "plus": 1.0}
_DIGIT_OF: Dict[str, int] = {word: value for word, value in _SMALL.items() if value < 10}
_DIGIT_OF.update({str(value): value for value in range(10)})
_DIGIT_OF[_OH] = 0
#: Words before a number that do not change its amount.
_HEDGES = {"about", "around", "approximately", "roughly", "exactly", "another", "some", "just"}
_JOINING_HYPHEN = re.compile(r"(?<![a-z])([a-z]+|\d+(?=-and-))-(?=([a-z]+))")
#: Turns that are said as one word: "a one-eighty".
_IDIOMS = frozenset([180, 270, 360, 540, 720])
_LEADING_SIGN = re.compile(r"^\s*([+-])\s*(?=[^\s+-])")
_SPACED_SLASH = re.compile(r"(?<=\d)\s*/\s*(?=\d)", re.ASCII)
_RATIO = re.compile(r"(\d{1,9})/(\d{1,9})", re.ASCII)
#: "3 1/2", "3-1/2", "3 and 1/2".
_MIXED_RATIO = re.compile(r"(.+?)(?:\s+and\s+|\s+|-)(\d{1,2})/(\d{1,2})", re.ASCII)
#: Usual denominators of measures. "10/15 degrees" means one of two numbers.
_DENOMINATORS = frozenset([0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 32, 64])
_DIGITS = re.compile(r"(\d{1,3}(,\d{3})+|\d+)?(\.\d+)?(e[+-]?\d+)?", re.IGNORECASE | re.ASCII)
#: Fraction characters such as "½", written with digits.
_SINGLE_SIGNS: Dict[str, str] = {
    sign: unicodedata.normalize("NFKC", sign).replace("\u2044", "/") for sign in "¼½¾⅐⅑⅒⅓⅔⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞"
}


class QuantityError(ValueError):
    """The words are not the wanted quantity.

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


def plain_digits(text: str) -> str:
    """Return a text with digits of any width and script as those of ASCII: "\uff13\uff10" is "30".

    Full-width letters and marks become plain ones as well ("\uff12\uff0e\uff15\uff4d" is "2.5m"). The text keeps its
    length.
    """
    if text.isascii():
        return text
    return "".join(_plain(sign) for sign in text)


def _plain(sign: str) -> str:
    if unicodedata.category(sign) == "Nd":
        return str(unicodedata.digit(sign))
    return unicodedata.normalize("NFKC", sign) if "\uff01" <= sign <= "\uff5e" else sign


def number_words() -> Sequence[str]:
    """Return the words that numbers consist of, without "and" and the articles."""
    return tuple(_SMALL) + (_OH,) + tuple(_MULTIPLIERS) + tuple(_FRACTIONS) + tuple(_SIGNS) + ("couple", "few")


def parse_number(text: str) -> float:
    """Read a number in digits or in English words.

    Args:
        text: "120", "-2.5", "1,000", "3 1/2", "½", "three", "minus two", "one hundred and twenty", "one eighty" (180),
            "one oh five" (105), "forty-five", "two and a half", "nine and three quarters", "half a", "a couple of" (2),
            "a dozen", "a"
    Returns:
        the number
    Raises:
        QuantityError: NOT_A_NUMBER, NOT_FINITE ("1e400")
    """
    value = _value(text)
    if value is None:
        raise QuantityError("NOT_A_NUMBER", f'"{text.strip()}" is not a number.')
    if not math.isfinite(value):
        raise QuantityError("NOT_FINITE", f'"{text.strip()}" is more than I can count.')
    return value


def find_number(text: str) -> Optional[float]:
    """Return the number that :func:`parse_number` reads; None for words that it refuses."""
    value = _value(text)
    return value if value is not None and math.isfinite(value) else None


def find_whole_number(text: str) -> Optional[int]:
    """Return the number that :func:`find_number` finds if it is a whole one; None otherwise."""
    number = find_number(text)
    return int(number) if number is not None and number.is_integer() else None


def _value(text: str) -> Optional[float]:
    # Most words of a sentence are asked, and few are numbers.
    if text.isalpha() and text.lower() not in _WHOLE_NUMBERS:
        return None
    words = _spelled(text).split()
    sign = _SIGNS[words.pop(0)] if words and words[0] in _SIGNS else 1.0
    value = _parse_unsigned(words)
    return None if value is None else sign * value


def _spelled(text: str) -> str:
    """Return a text in lower case without hedges, with its sign as a word and its parts separated."""
    spelled = plain_digits(text).lower().replace("\u2212", "-").replace("\u2044", "/")
    spelled = "".join(" " + _SINGLE_SIGNS[sign] + " " if sign in _SINGLE_SIGNS else sign for sign in spelled)
    spelled = " ".join(word for word in spelled.split() if word not in _HEDGES)
    spelled = _SPACED_SLASH.sub("/", spelled)
    spelled = _LEADING_SIGN.sub(lambda sign: "minus " if sign.group(1) == "-" else "plus ", spelled)
    return _JOINING_HYPHEN.sub(_parted, spelled)


def _parted(hyphen: "re.Match[str]") -> str:
    """Return a word, and a space for the hyphen after it if the hyphen joins two number words ("twenty-one").

    Between digits a hyphen means a range ("100-50"). In "five-ten" and "three-fifty" it may too; neither is a number.
    """
    first, second = _SMALL.get(hyphen.group(1), 0), _SMALL.get(hyphen.group(2), 0)
    is_range = 0 < first < 10 <= second and first * 100 + second not in _IDIOMS
    return hyphen.group(0) if is_range else hyphen.group(1) + " "


def _is_digits(text: str) -> bool:
    """Whether a text is a number in digits without a sign."""
    return text[:1] not in ("e", "E") and bool(text) and _DIGITS.fullmatch(text) is not None


def _digits(text: str) -> float:
    return float(text.replace(",", ""))


def _parse_unsigned(words: List[str]) -> Optional[float]:
    if not words:
        return None
    if len(words) == 1 and _is_digits(words[0]):
        return _digits(words[0])
    if any("/" in word for word in words):
        return _ratio(" ".join(words))
    if words[0] in ("a", "an", "one") and words[1:] and words[1] in ("couple", "few"):
        return ({"couple": 2.0, "few": 3.0}[words[1]]) if words[2:] in ([], ["of"]) else None
    if words in (["a"], ["an"]):
        return 1.0
    if (words[-2:] == ["a", "dozen"] and words[:-2] == ["half"]) or words == ["half", "dozen"]:
        return 6.0
    if any(word in _FRACTIONS for word in words):
        return _fraction_at_end(words)
    if "point" in words:
        return _decimal(words)
    return _whole(words)


def _ratio(text: str) -> Optional[float]:
    """Read "3/4", or "3 1/2" if its ratio is less than one."""
    mixed = _MIXED_RATIO.fullmatch(text)
    if mixed is not None:
        whole = _count(mixed.group(1).split())
        part = _share(int(mixed.group(2)), int(mixed.group(3)))
        return whole + part if whole is not None and part is not None and 0.0 < part < 1.0 else None
    ratio = _RATIO.fullmatch(text)
    return _share(int(ratio.group(1)), int(ratio.group(2))) if ratio is not None else None


def _share(numerator: int, denominator: int) -> Optional[float]:
    if denominator not in _DENOMINATORS or (numerator > 9 and 0 < denominator < 16):
        return None
    return numerator / denominator if denominator else math.inf


def _count(words: List[str]) -> Optional[float]:
    """Read a whole number before a fraction; "a dozen and a half" does not mean twelve and a half."""
    value = _whole(words) if words and words[-1] not in _MULTIPLIERS else None
    return value if value is not None and value.is_integer() else None


def _fraction_at_end(words: List[str]) -> Optional[float]:
    """Read "half a", "a quarter of a", "two and a half", "nine and three quarters"; None for other words."""
    words = list(words)
    while words[-1:] in (["a"], ["an"], ["of"], ["the"]):
        words.pop()
    if not words or words[-1] not in _FRACTIONS:
        return None
    name = words.pop()
    if "and" not in words:
        return _parts(words, name)
    joint = len(words) - 1 - words[::-1].index("and")
    whole, part = _count(words[:joint]), _parts(words[joint + 1 :], name)
    return whole + part if whole is not None and part is not None and part < 1.0 else None


def _parts(count: List[str], name: str) -> Optional[float]:
    """Read the number of halves, quarters and so on; it is one word."""
    is_plural = name.endswith("s")
    if not count:
        # "Third" alone is an ordinal.
        return _FRACTIONS[name] if name in ("half", "quarter") else None
    if len(count) > 1:
        return None
    if count[0] in ("a", "an", "one", "1"):
        return None if is_plural else _FRACTIONS[name]
    number = _whole(count)
    # "Two third" is no fraction either; "three quarter" is, before a noun ("a three quarter turn").
    is_before_a_noun = name == "quarter" and number == 3
    if number is None or not number.is_integer() or number < 2 or not (is_plural or is_before_a_noun):
        return None
    return number * _FRACTIONS[name]


def _decimal(words: List[str]) -> Optional[float]:
    split = words.index("point")
    whole = _whole(words[:split]) if words[:split] not in ([], [_OH]) else 0.0
    digits = [_DIGIT_OF.get(word) for word in words[split + 1 :]]
    if whole is None or not whole.is_integer() or not digits or None in digits:
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
        elif word == _OH:
            # "One oh oh five" means 1005 to some and 105 to nobody.
            if before == _OH or before not in _DIGIT_OF or group is None or not 0 < group < 10:
                return None
        elif word in _SMALL or _is_digits(word):
            value = float(_SMALL[word]) if word in _SMALL else _digits(word)
            group = _append(group, value, before, is_word=word in _SMALL)
            if group is None or group >= largest:
                return None
        elif word in _MULTIPLIERS:
            factor = _MULTIPLIERS[word]
            # Thousands come before hundreds, each at most once: "one hundred two hundred" is two numbers.
            if factor >= largest or (group is None and before is not None) or before in ("and", _OH):
                return None
            if factor < 1e3 and group is not None and group >= 100:
                return None
            group = (1.0 if group is None else group) * factor
            if factor >= 1e3:
                total, group, largest = total + group, None, factor
        else:
            return None
        before = word
    if before in ("and", _OH, None):
        return None
    return total + (group or 0.0)


def _append(group: Optional[float], value: float, before: Optional[str], *, is_word: bool) -> Optional[float]:
    """Append a number to the words before it; None if the result is not an English number."""
    if group is None:
        return value
    if before == "dozen" or not value.is_integer():
        return None
    if before in ("hundred", "and"):
        return group + value if value < 100 else None
    if before == _OH:
        return group * 100 + value if 0 < value < 10 else None
    if not is_word or before not in _SMALL:
        # "100 50" and "20 3" are two numbers; they are not added.
        return None
    if group % 10 == 0 and group % 100 >= 20 and 0 < value < 10:
        return group + value
    # "One eighty" means 180, and "one twenty five" 125; "five ten" means five to ten.
    if 1 <= group < 10 <= value < 100 and (value >= 20 or group <= 3):
        return group * 100 + value
    return None
