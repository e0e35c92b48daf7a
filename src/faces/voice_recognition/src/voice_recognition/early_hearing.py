"""What the searches make of an utterance before it is certain that it has ended.

An utterance ends after some quiet. The searches begin in the middle of that quiet: when nobody speaks on, what they
heard is there at once.
"""

from dataclasses import dataclass
from typing import Callable, Generic, Optional, TypeVar

from voice_recognition.endpointing import Utterance

How = TypeVar("How")
What = TypeVar("What")


@dataclass(frozen=True)
class _Early(Generic[How, What]):
    begin_s: float
    end_s: float
    how: How
    what: What


class EarlyHearing(Generic[How, What]):
    """Keeps what was heard before a pause until it is certain that the pause ends the utterance.

    Not thread-safe: the thread of the searches owns it.
    """

    def __init__(self) -> None:
        self._last: Optional[_Early[How, What]] = None

    def listen(self, utterance: Utterance, how: How, hear: Callable[[bytes], What]) -> None:
        """Hear an utterance that may have ended.

        Args:
            utterance: what was said so far
            how: for what it is heard: the state of the dialogue, and the language
            hear: the searches
        """
        self._last = _Early(utterance.begin_s, utterance.end_s, how, hear(utterance.pcm))

    def heard(self, utterance: Utterance, how: How, hear: Callable[[bytes], What]) -> What:
        """Return what was heard in an utterance that has ended: what is there already, if nobody spoke on."""
        last, self._last = self._last, None
        if last is not None and (last.begin_s, last.end_s, last.how) == (utterance.begin_s, utterance.end_s, how):
            return last.what
        return hear(utterance.pcm)
