"""Conditions on what is said, and on the clock."""

import re
import threading
from dataclasses import dataclass
from datetime import datetime
from typing import List, Optional, Tuple

from condition_watchers.words import hour, is_one_of
from spoken_quantities import QuantityError, parse_number
from typed_arguments import TypedArgument

#: What happens in a moment holds for so long, seconds: long enough to be noticed.
MOMENT_S = 0.5
#: What is remembered of what was said.
_MOST_KEPT = 50
_NO_WORD = re.compile(r"[^\w]+")
#: A time of the day in ISO 8601, as TIMEX3 writes it: "T08:00".
_TIME_OF_DAY = re.compile(r"T(\d{1,2})(?::?(\d{2}))?")
#: A clock shows a minute for so long.
_SHOWN_S = 60.0


@dataclass(frozen=True)
class Saying:
    """Something that somebody said.

    Attributes:
        speaker: a name; empty when only the voice is known
        text: the words
        heard_s: monotonic seconds
        stamp_s: ROS time, seconds
    """

    speaker: str
    text: str
    heard_s: float
    stamp_s: float


class Sayings:
    """What was said lately. Several threads may use it."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._sayings: List[Saying] = []

    def hear(self, saying: Saying) -> None:
        """Remember something."""
        with self._lock:
            self._sayings = [*self._sayings, saying][-_MOST_KEPT:]

    def match(self, speaker: TypedArgument, message: TypedArgument, *, now_s: float) -> Optional[Saying]:
        """Return what was said just now, by whom and as meant; None for nothing.

        Args:
            speaker: who has to have said it; anybody when nobody is named
            message: words that it has to contain; anything when it is empty
            now_s: monotonic seconds
        """
        with self._lock:
            sayings = list(reversed(self._sayings))
        for saying in sayings:
            if now_s - saying.heard_s <= MOMENT_S and _is_by(saying, speaker) and _contains(saying.text, message.text):
                return saying
        return None


def _is_by(saying: Saying, speaker: TypedArgument) -> bool:
    if not speaker.text or is_one_of(speaker, "speakers"):
        return True
    named = {speaker.text.lower(), speaker.head.lower()} - {""}
    return saying.speaker.lower() in named


def _contains(text: str, words: str) -> bool:
    return f" {_plain(words)} ".replace("  ", " ") in f" {_plain(text)} "


def _plain(text: str) -> str:
    return " ".join(_NO_WORD.sub(" ", text.lower()).split())


def clock_shows(said: TypedArgument, now: datetime, *, side: str = "") -> bool:
    """Whether the clock shows a time: from that moment on, for a minute.

    Args:
        said: the time; "eight" is that of the morning and that of the evening
        now: local time
        side: whether a time "after" or "before" it is meant, on this day
    Raises:
        ValueError: it is no moment, or it may be two moments of which one is before now and one is not
    """
    if side:
        return _is_on_side(said, now, side)
    time = said.time
    if time is not None and time.begin_s is not None:
        return 0.0 <= now.timestamp() - time.begin_s < _SHOWN_S
    found = _times_of_day(said)
    if found:
        return (now.hour, now.minute) in found
    named = hour(said.text.lower())
    if named is not None:
        return (now.hour, now.minute) == (named, 0)
    try:
        number = parse_number(said.text)
    except QuantityError:
        number = None
    if number is None or number not in range(25):
        raise ValueError(f'"{said.text}" is no time of the day')
    hours = {number % 24} if number > 12 else {number % 12, number % 12 + 12}
    return now.hour in hours and now.minute == 0


def _times_of_day(said: TypedArgument) -> List[Tuple[int, int]]:
    value = said.time.value if said.time is not None else ""
    return [(int(hour) % 24, int(minute or 0)) for hour, minute in _TIME_OF_DAY.findall(value)]


def _is_on_side(said: TypedArgument, now: datetime, side: str) -> bool:
    times = _times_of_day(said)
    answers = {(now.hour, now.minute) >= time for time in times}
    if len(answers) != 1:
        which = "may be in the morning or in the evening" if times else "is no time of the day"
        raise ValueError(f'"{said.text}" {which}')
    return answers.pop() is (side == "after")
