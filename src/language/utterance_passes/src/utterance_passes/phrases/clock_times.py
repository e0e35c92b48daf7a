"""Reads times of the clock: "at eight", "tomorrow at half past nine", "every Monday morning at 8:30"."""

import re
from dataclasses import dataclass, replace
from typing import Optional, Sequence, Tuple

from spoken_quantities import find_number, find_unit, find_whole_number
from typed_arguments import TimeExpression
from word_classes import word_class, word_list

_DAY_S = 86_400.0
#: A time of this day; the offset of a time must not be 0.
_TODAY_S = 1.0
_LONGEST = 9
_AT = "at"
_ABOUT = word_class("hedges_of_times")
_MERIDIEM = ("am", "pm")
_O_CLOCK = "o'clock"
_PAST, _TO = word_class("minutes_after"), word_class("minutes_before")
_EXACT = word_class("exact_adverbs")
#: Parts of an hour, "half past eight".
_PARTS = ("half", "quarter")
_OH = word_class("zeros_before_minutes")
_MIDNIGHT, _MORNING, *_NOON, _AFTERNOON, _EVENING, _NIGHT = word_list("parts_of_the_day")
_TODAY, _TONIGHT, _TOMORROW = word_list("days_from_today")
_EACH, _DAILY, _DAY = word_class("determiners_of_all"), ("daily", "everyday"), "day"
_WEEKDAYS, _WORKDAYS = word_list("weekdays"), word_class("workday_words")
_WRITTEN = re.compile(r"(\d{1,2})(?:[:.h](\d{2}))?(am|pm|a\.m\.|p\.m\.)?")
#: Hours that nobody means at night, on a day that is named.
_OF_THE_DAY = range(7, 12)


@dataclass(frozen=True)
class ClockTime:
    """A time of the clock in a sentence.

    Attributes:
        length: number of words
        when: None if the person must say more
        question: what the person must say; empty if nothing
        is_certain: whether the words are written or marked as a time of the clock ("20:15", "8 pm", "six thirty"); the
            number in "at five" may be anything
    """

    length: int
    when: Optional[TimeExpression] = None
    question: str = ""
    is_certain: bool = False


@dataclass(frozen=True)
class _Clock:
    """What the words say: an hour with its minute, whether it is before noon, and the day."""

    hour: Optional[int] = None
    minute: int = 0
    is_exact: bool = False
    half: str = ""  # am, pm or night
    day: Optional[int] = None
    weekdays: Tuple[int, ...] = ()
    is_repeated: bool = False
    is_certain: bool = False


_Part = Optional[Tuple[_Clock, int]]


def clock_time_at(forms: Sequence[str]) -> Optional[ClockTime]:
    """Return the time of the clock that words begin with; None if they begin with none.

    Args:
        forms: words in lower case, without marks
    """
    # "Around noon", "at about six": noon and six are as good as any time near them.
    about = 1 if forms[:1] and forms[0] == _AT else 0
    if len(forms) > about + 1 and forms[about] in _ABOUT and forms[about + 1] != _AT:
        found = _clock_time_at((*forms[:about], *forms[about + 1 :]))
        return replace(found, length=found.length + 1) if found is not None and found.when is not None else None
    return _clock_time_at(forms)


def _clock_time_at(forms: Sequence[str]) -> Optional[ClockTime]:
    clock, place = _Clock(), 0
    has_day = False
    while place < min(len(forms), _LONGEST):
        found = _hour(forms[place:], clock) if clock.hour is None else None
        if found is None:
            found = _half(forms[place:], clock) or _day(forms[place:], clock)
            has_day = has_day or found is not None
        if found is None:
            break
        clock, length = found
        place += length
        if place < len(forms) and forms[place] in _EXACT and clock.hour is not None:
            place += 1
    if not place:
        return None
    words = " ".join(forms[:place])
    if clock.hour is None:
        is_day = clock.day is not None or clock.weekdays or clock.is_repeated
        return ClockTime(place, question=f"At what time {words}?") if is_day else None
    return _resolved(clock, words, place)


def _resolved(clock: _Clock, words: str, length: int) -> ClockTime:
    hours = _hours(clock)
    if len(hours) > 1 and (clock.is_repeated or clock.weekdays or (clock.day or 0) > 0):
        if clock.hour not in _OF_THE_DAY:
            said = " or at ".join(f"{hour}:{clock.minute:02d}" for hour in hours)
            question = f'At {said}? Say "in the morning", "in the afternoon" or "in the evening" with it.'
            return ClockTime(length, question=question, is_certain=clock.is_certain)
        hours = hours[:1]
    week = f"XXXX-WXX-{''.join(str(day + 1) for day in clock.weekdays)}" if clock.weekdays else ""
    value = "/".join(f"{week}T{hour:02d}:{clock.minute:02d}" for hour in hours)
    when = TimeExpression("time", words, relation="at", value=value)
    if clock.is_repeated:
        period_s = 7 * _DAY_S if len(clock.weekdays) == 1 else _DAY_S
        when = replace(when, kind="set", relation="every", period_s=period_s)
    elif clock.day is not None:
        when = replace(when, offset_s=clock.day * _DAY_S or _TODAY_S)
    return ClockTime(length, when, is_certain=clock.is_certain)


def _hours(clock: _Clock) -> Tuple[int, ...]:
    hour = clock.hour or 0
    if clock.is_exact or hour == 0 or hour > 12:
        return (hour,)
    before, after = hour % 12, hour % 12 + 12
    if clock.half == "am":
        return (before,)
    if clock.half == "pm":
        return (after,)
    if clock.half == "night":
        return (after,) if 6 <= hour < 12 else (before,)
    return (before, after)


def _hour(forms: Sequence[str], clock: _Clock) -> _Part:
    """Read "at eight", "8:30 pm", "half past eight", "noon"."""
    start = 1 if forms[0] == _AT else 0
    rest = forms[start:]
    if not rest:
        return None
    if rest[0] in (*_NOON, _MIDNIGHT):
        return replace(clock, hour=12 if rest[0] in _NOON else 0, is_exact=True), start + 1
    found = _relative(rest, clock) or _spoken(rest, clock)
    if found is None:
        return None
    read, length = found
    end = start + length
    # A number alone may be anything: "the office seventeen", "ten to fifteen", "every day seven".
    is_certain = bool({":", "h"} & set(rest[0]) and rest[0][0].isdigit())
    is_certain = is_certain or any(word in _PARTS or _is_minute(word) for word in rest[:length])
    if forms[end : end + 1] and forms[end].replace("\u2019", "'") == _O_CLOCK:
        is_certain, end = True, end + 1
    half = _meridiem(forms[end:])
    if half:
        is_certain, end, read = True, end + 1, replace(read, half=half)
    is_certain = is_certain or bool(read.half) or (start == 1 and length > 1)
    return (replace(read, is_certain=is_certain), end) if is_certain or start == 1 else None


def _meridiem(forms: Sequence[str]) -> str:
    first = forms[0].replace(".", "") if forms else ""
    return first if first in _MERIDIEM else ""


def _is_minute(word: str) -> bool:
    unit = find_unit(word)
    return unit is not None and unit.name == "minute"


def _relative(forms: Sequence[str], clock: _Clock) -> _Part:
    """Read "half past eight", "a quarter to nine", "ten minutes past eight"."""
    place = 1 if forms[0] in ("a", "an") else 0
    if len(forms) < place + 3:
        return None
    word = forms[place]
    part = find_number(word) if word in _PARTS else None
    minutes = _number(word, 59) if part is None else round(part * 60)
    place += 1
    if _is_minute(forms[place]):
        place += 1
    if minutes is None or len(forms) < place + 2 or forms[place] not in _PAST | _TO:
        return None
    is_before = forms[place] in _TO
    if is_before and minutes == 30:
        return None
    named = 12 if forms[place + 1] in (*_NOON, _MIDNIGHT) else _number(forms[place + 1], 24)
    if named is None:
        return None
    is_exact = forms[place + 1] in (*_NOON, _MIDNIGHT) or named > 12
    hour = 0 if forms[place + 1] == _MIDNIGHT else named
    if is_before:
        hour = (hour - 1) % 24 if is_exact else (hour - 2) % 12 + 1
        minutes = 60 - minutes
    return replace(clock, hour=hour % 24, minute=minutes, is_exact=is_exact), place + 2


def _spoken(forms: Sequence[str], clock: _Clock) -> _Part:
    """Read "eight", "8", "8:30", "8pm", "eight thirty", "eight forty-five", "20:00"."""
    written = _WRITTEN.fullmatch(forms[0])
    if written:
        hour, minute = int(written.group(1)), int(written.group(2) or 0)
        half = (written.group(3) or "").replace(".", "")
        if hour > 24 or minute > 59 or (half and not 1 <= hour <= 12):
            return None
        is_exact = not half and (hour > 12 or hour == 0 or forms[0].startswith("0"))
        has_minute = written.group(2) is not None
        if has_minute or half:
            return replace(clock, hour=hour % 24, minute=minute, is_exact=is_exact, half=half or clock.half), 1
    hour_said = _number(forms[0], 24)
    if hour_said is None:
        return None
    is_exact = hour_said > 12 or hour_said == 0 or forms[0].startswith("0")
    minute, length = _minutes_said(forms[1:])
    if length:
        return replace(clock, hour=hour_said % 24, minute=minute, is_exact=is_exact), 1 + length
    return replace(clock, hour=hour_said % 24, is_exact=is_exact), 1


def _minutes_said(forms: Sequence[str]) -> Tuple[int, int]:
    """Return the minutes behind an hour, and the number of their words: "thirty", "forty five", "forty-five", "oh
    five"; no words if none follow."""
    if forms[:1] and forms[0] in _OH:
        after = _number(forms[1], 9) if len(forms) > 1 else None
        return (after, 2) if after else (0, 0)
    for length in (3, 2, 1):
        said = forms[:length]
        is_joined = length < 3 or (len(said) > 1 and said[1] == "-")
        words = [form for form in said if form != "-"]
        minute = _number(" ".join(words), 59) if is_joined and len(said) == length and _AT not in words else None
        if minute is not None and minute >= 10:
            return minute, length
    return 0, 0


def _number(word: str, most: int) -> Optional[int]:
    number = None if word in ("a", "an") else find_whole_number(word)
    return number if number is not None and 0 <= number <= most else None


def _half(forms: Sequence[str], clock: _Clock) -> _Part:
    """Read "in the morning", "at night", "tonight", "this evening"."""
    for before in (("in", "the"), ("at",), ("this",), ()):
        length = len(before)
        if tuple(forms[:length]) != before or len(forms) <= length:
            continue
        half = _half_of(forms[length])
        # "Every morning" is a day; a morning alone stands behind a day: "tomorrow morning".
        if half and (before or clock.day is not None or clock.weekdays):
            today = 0 if before == ("this",) and clock.day is None else clock.day
            return replace(clock, half=half, day=today), length + 1
    return None


def _half_of(word: str) -> str:
    singular = word[:-1] if word.endswith("s") else word
    if singular == _MORNING:
        return "am"
    if singular in (_AFTERNOON, _EVENING):
        return "pm"
    return "night" if singular == _NIGHT else ""


def _day(forms: Sequence[str], clock: _Clock) -> _Part:
    """Read "tomorrow", "today", "on Monday", "every day", "every Monday morning", "on weekdays"."""
    if clock.day is not None or clock.weekdays or clock.is_repeated:
        return None
    first = forms[0]
    if first == _TOMORROW:
        return replace(clock, day=1), 1
    if first == _TODAY:
        return replace(clock, day=0), 1
    if first == _TONIGHT:
        return replace(clock, day=0, half="pm"), 1
    if first in _DAILY:
        return replace(clock, is_repeated=True), 1
    for before, is_each in (("on", False), (None, False), (_EACH, True)):
        word = first if before is None else forms[1] if len(forms) > 1 else ""
        length = 1 if before is None else 2
        if (before == "on" and first != "on") or (is_each and first not in _EACH):
            continue
        found = _named_day(word, is_each=is_each)
        if found is not None:
            days, is_repeated = found
            return replace(clock, weekdays=days, is_repeated=is_repeated), length
        if is_each and word == _DAY:
            return replace(clock, is_repeated=True), length
        if is_each and _half_of(word):
            return replace(clock, is_repeated=True, half=_half_of(word)), length
    return None


def _named_day(word: str, *, is_each: bool) -> Optional[Tuple[Tuple[int, ...], bool]]:
    """Return the days of the week that a word names, and whether each of them is meant."""
    singular = word[:-1] if word.endswith("s") else word
    if singular in _WORKDAYS:
        return tuple(range(5)), True
    if singular in _WEEKDAYS:
        return (_WEEKDAYS.index(singular),), is_each or word != singular
    return None
