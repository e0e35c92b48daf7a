"""Stops that the command server answered in place of a stop server that was hung."""
import time
from collections import deque
from dataclasses import dataclass
from typing import Callable, Deque

# Utterance and answer come on connections of their own: of two that came together either may be first.
_SKEW_S = 0.25
_FORGET_S = 30.0
_MOST_KEPT = 1000


@dataclass(frozen=True)
class _Answer:
    command_id: str
    text: str
    heard_s: float


class OtherAnswers:
    """Says of a stop whether it has its reply already. Not for several threads at once."""

    def __init__(self, *, now: Callable[[], float] = time.monotonic) -> None:
        """Start with none.

        Args:
            now: monotonic clock, seconds
        """
        self._now = now
        self._answers: Deque[_Answer] = deque(maxlen=_MOST_KEPT)

    def note(self, command_id: str, text: str) -> None:
        """Somebody else answered a stop."""
        self._answers.append(_Answer(command_id, text, self._now()))

    def take(self, command_id: str, text: str, *, heard_s: float) -> bool:
        """Whether a stop has been answered; each answer counts for one stop.

        Args:
            command_id: of a stop that came as a goal; empty for one that came as text
            text: as it was said
            heard_s: when it was heard, monotonic seconds; an answer from before it belongs to another stop
        """
        while self._answers and self._answers[0].heard_s < self._now() - _FORGET_S:
            self._answers.popleft()
        for answer in self._answers:
            is_meant = answer.command_id == command_id if command_id else answer.text == text
            if is_meant and answer.heard_s >= heard_s - _SKEW_S:
                self._answers.remove(answer)
                return True
        return False
