"""Cries that the command server answered: the stop server hung, or the cry was none."""

import time
from collections import deque
from dataclasses import dataclass
from typing import Callable, Deque

# Two nodes receive one utterance at nearly the same time.
_SKEW_NS = 500_000_000
_FORGET_S = 30.0
_MOST_KEPT = 1000


@dataclass(frozen=True)
class _Answer:
    command_id: str
    text: str
    stamp_ns: int
    noted_s: float


class OtherAnswers:
    """Keeps which stops have been answered already. For one thread."""

    def __init__(self, *, now: Callable[[], float] = time.monotonic) -> None:
        """Start with none.

        Args:
            now: monotonic clock, seconds
        """
        self._now = now
        self._answers: Deque[_Answer] = deque(maxlen=_MOST_KEPT)

    def note(self, command_id: str, text: str, *, stamp_ns: int) -> None:
        """Another node answered a stop that was said at `stamp_ns`, nanoseconds of ROS time."""
        self._answers.append(_Answer(command_id, text, stamp_ns, self._now()))

    def take(self, command_id: str, text: str, *, stamp_ns: int, is_just_awake: bool) -> bool:
        """Whether a stop has been answered; each answer counts for one stop.

        Args:
            command_id: of a stop that came as a goal; empty for one that came as text
            text: as it was said
            stamp_ns: when it arrived here, nanoseconds of ROS time
            is_just_awake: this process was suspended, so the stop may have been said long before
        """
        while self._answers and self._answers[0].noted_s < self._now() - _FORGET_S:
            self._answers.popleft()
        for answer in self._answers:
            is_same_time = is_just_awake or abs(answer.stamp_ns - stamp_ns) <= _SKEW_NS
            if (answer.command_id == command_id) if command_id else (answer.text == text and is_same_time):
                self._answers.remove(answer)
                return True
        return False
