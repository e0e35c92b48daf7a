"""Conditions on what is said, and on the clock."""

import re
import threading
from dataclasses import dataclass
from datetime import datetime
from typing import List, Optional

from condition_watchers.words import is_one_of
from typed_arguments import TimeExpression, TypedArgument

#: What happens in a moment holds for so long, seconds: long enough to be noticed.
MOMENT_S = 0.5
#: What is remembered of what was said.
_MOST_KEPT = 50
_NO_WORD = re.compile(r"[^\w]+")
#: A time of the day in ISO 8601, as TIMEX3 writes it: "T08:00".
_TIME_OF_DAY = re.compile(r"^T(\d{1,2})(?::?(\d{2}))?")
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


def clock_shows(time: Optional[TimeExpression], now: datetime) -> bool:
    """Whether the clock shows a time: from that moment on, for a minute.

    Args:
        time: as the framer read it
        now: local time
    Raises:
        ValueError: it is no moment
    """
    if time is None:
        raise ValueError("that is no time of the day")
    if time.begin_s is not None:
        return 0.0 <= now.timestamp() - time.begin_s < _SHOWN_S
    found = _TIME_OF_DAY.search(time.value)
    if found is None:
        raise ValueError(f'"{time.words or time.value}" is no time of the day')
    return (now.hour, now.minute) == (int(found[1]) % 24, int(found[2] or 0))
