"""What was said to all robots while nobody passed it on."""

import time
from collections import deque
from dataclasses import dataclass
from typing import Callable, Deque, Tuple

from roboframenet_ros.command_ids import came_by_action

#: The sign that a text was taken may arrive before the text, by this much at most, seconds.
_SKEW_S = 2.0
#: How long a text is kept; the node is started again within some seconds.
_REMEMBER_S = 60.0
#: A text is recognised by its beginning.
KEY_LENGTH = 200


@dataclass(frozen=True)
class Untaken:
    """A text that was said.

    Attributes:
        text: as it was said
        command_id: of a goal; empty for a text
        heard_s: when it was said, monotonic seconds
    """

    text: str
    command_id: str
    heard_s: float


class UntakenTexts:
    """Texts, until it is told that they are taken. One thread at a time calls.

    Who takes a text gives it an id; that it is taken may be told again.
    """

    def __init__(self, *, now: Callable[[], float] = time.monotonic, most: int = 1000) -> None:
        """
        Args:
            now: monotonic clock, seconds
            most: most texts that are kept; the oldest is dropped first
        """
        self._now = now
        self._texts: Deque[Untaken] = deque(maxlen=most)
        self._early: Deque[Untaken] = deque(maxlen=most)
        self._taken: Deque[str] = deque(maxlen=most)

    def hear(self, text: str, command_id: str = "") -> None:
        """A text was said, or a goal with an id."""
        self._forget()
        said = Untaken(text, command_id, self._now())
        for early in self._early:
            if _is_same(said, early):
                self._early.remove(early)
                return
        self._texts.append(said)

    def hear_taken(self, command_id: str, text: str) -> None:
        """A text was taken, as the command with an id."""
        self._forget()
        if command_id in self._taken:
            return
        self._taken.append(command_id)
        taken = Untaken(text, command_id, self._now())
        # Of equal texts the last one was taken: the others were said while nobody was there.
        for said in reversed(self._texts):
            if _is_same(said, taken):
                self._texts.remove(said)
                return
        self._early.append(taken)

    def take(self, *, before_s: float) -> Tuple[Untaken, ...]:
        """Remove and return what was said before a time and nobody took, oldest first.

        Args:
            before_s: monotonic seconds
        """
        self._forget()
        found = tuple(said for said in self._texts if said.heard_s < before_s)
        for said in found:
            self._texts.remove(said)
        return found

    def _forget(self) -> None:
        now_s = self._now()
        while self._texts and now_s - self._texts[0].heard_s > _REMEMBER_S:
            self._texts.popleft()
        while self._early and now_s - self._early[0].heard_s > _SKEW_S:
            self._early.popleft()


def _is_same(heard: Untaken, taken: Untaken) -> bool:
    if heard.command_id or came_by_action(taken.command_id):
        return heard.command_id == taken.command_id
    return heard.text[:KEY_LENGTH] == taken.text[:KEY_LENGTH]
