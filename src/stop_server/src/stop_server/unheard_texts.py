"""Texts that were said while the command server did not run."""

import time
from collections import deque
from dataclasses import dataclass
from typing import Callable, Deque, Tuple

#: A text is recognised by its beginning; the command server cuts long ones.
_KEY_LENGTH = 200
#: A sign that a text was taken may arrive before the text, by this much at most, seconds.
_SKEW_S = 2.0
#: How long a text is kept; the command server is restarted within a second or two.
_REMEMBER_S = 60.0


@dataclass(frozen=True)
class _Entry:
    text: str
    heard_s: float


class UnheardTexts:
    """Notes the texts that are said, and what becomes of them: a command, or a reply. One thread at a time calls."""

    def __init__(self, *, now: Callable[[], float] = time.monotonic, max_kept: int = 1000) -> None:
        """Start empty.

        Args:
            now: monotonic clock, seconds
            max_kept: most texts that are kept; the oldest is dropped first
        """
        self._now = now
        self._texts: Deque[_Entry] = deque(maxlen=max_kept)
        self._early: Deque[_Entry] = deque(maxlen=max_kept)

    def hear(self, text: str) -> None:
        """A text was said."""
        self._forget()
        if not _take(self._early, text):
            self._texts.append(_Entry(text, self._now()))

    def hear_taken(self, text: str) -> None:
        """The command server has sent a text on, or replied to it."""
        self._forget()
        if not _take(self._texts, text):
            self._early.append(_Entry(text, self._now()))

    def take_unheard(self, *, before_s: float) -> Tuple[str, ...]:
        """Remove and return the texts that nobody took, oldest first.

        Args:
            before_s: when the command server began to listen, monotonic seconds
        """
        self._forget()
        unheard = tuple(entry.text for entry in self._texts if entry.heard_s < before_s)
        later = [entry for entry in self._texts if entry.heard_s >= before_s]
        self._texts.clear()
        self._texts.extend(later)
        return unheard

    def _forget(self) -> None:
        now_s = self._now()
        while self._texts and now_s - self._texts[0].heard_s > _REMEMBER_S:
            self._texts.popleft()
        while self._early and now_s - self._early[0].heard_s > _SKEW_S:
            self._early.popleft()


def _take(entries: Deque[_Entry], text: str) -> bool:
    """Remove the oldest entry of a text; returns whether there was one."""
    for entry in entries:
        if entry.text[:_KEY_LENGTH] == text[:_KEY_LENGTH]:
            entries.remove(entry)
            return True
    return False
