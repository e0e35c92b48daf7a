"""Texts that were said while the command server did not run."""

import time
from collections import deque
from dataclasses import dataclass
from typing import Callable, Deque, List, Set, Tuple

#: A text is recognised by its beginning; the command server cuts long ones.
_KEY_LENGTH = 200
#: A sign that a text was taken may arrive before the text, by this much at most, or so long after it; seconds.
_EARLY_S = 0.2
_LATE_S = 2.0
#: The command server stamps a text when it arrives there: at the time when it arrives here, but for this much.
_SAME_NS = 1_000_000_000
#: How long a text is kept; the command server is restarted within a second or two.
_REMEMBER_S = 60.0


@dataclass(frozen=True)
class _Entry:
    key: str
    heard_s: float
    stamp_ns: int = 0
    text: str = ""


class UnheardTexts:
    """Notes the texts that are said, and what becomes of them: a command, or a reply. One thread at a time calls.

    Equal texts are told apart by their times, when it is asked for those that nobody took.
    """

    def __init__(self, *, now: Callable[[], float] = time.monotonic, max_kept: int = 1000) -> None:
        """Start empty.

        Args:
            now: monotonic clock, seconds
            max_kept: most texts that are kept; the oldest is dropped first
        """
        self._now = now
        self._texts: Deque[_Entry] = deque(maxlen=max_kept)
        self._taken: Deque[_Entry] = deque(maxlen=max_kept)
        self._replies: Deque[_Entry] = deque(maxlen=max_kept)

    def hear(self, text: str, *, stamp_ns: int) -> None:
        """A text was said, at a ROS time in nanoseconds."""
        self._note(self._texts, _Entry(text[:_KEY_LENGTH], self._now(), stamp_ns, text))

    def hear_taken(self, text: str) -> None:
        """The command server has sent a text on. It was said just now: an equal one from before may be unheard."""
        self._note(self._taken, _Entry(text[:_KEY_LENGTH], self._now()))

    def hear_reply(self, text: str, *, stamp_ns: int) -> None:
        """The command server has replied to a text that it stamped so, nanoseconds of ROS time.

        It may have been killed before it could say that it took the text.
        """
        self._note(self._replies, _Entry(text[:_KEY_LENGTH], self._now(), stamp_ns))

    def take_unheard(self, *, before_s: float) -> Tuple[str, ...]:
        """Remove and return the texts that nobody took, oldest first.

        Args:
            before_s: when the command server began to listen, monotonic seconds
        """
        self._forget()
        taken = self._taken_texts()
        unheard = [
            entry for number, entry in enumerate(self._texts) if number not in taken and entry.heard_s < before_s
        ]
        for entry in unheard:
            self._texts.remove(entry)
        return tuple(entry.text for entry in unheard)

    def _taken_texts(self) -> Set[int]:
        """Return the numbers of the texts that were taken or answered."""
        texts: List[_Entry] = list(self._texts)
        found: Set[int] = set()
        # From the newest on: what was said before the command server was started is left over.
        for sign in reversed(self._taken):
            match = (
                number
                for number in range(len(texts) - 1, -1, -1)
                if number not in found
                and texts[number].key == sign.key
                and -_EARLY_S <= sign.heard_s - texts[number].heard_s <= _LATE_S
            )
            found.update([next(match, -1)])
        for reply in self._replies:
            near = [
                (abs(text.stamp_ns - reply.stamp_ns), number not in found, number)
                for number, text in enumerate(texts)
                if text.key == reply.key and abs(text.stamp_ns - reply.stamp_ns) <= _SAME_NS
            ]
            found.update([min(near)[-1]] if near else [])
        return found

    def _note(self, entries: Deque[_Entry], entry: _Entry) -> None:
        self._forget()
        entries.append(entry)

    def _forget(self) -> None:
        now_s = self._now()
        for entries in (self._texts, self._taken, self._replies):
            while entries and now_s - entries[0].heard_s > _REMEMBER_S:
                entries.popleft()
