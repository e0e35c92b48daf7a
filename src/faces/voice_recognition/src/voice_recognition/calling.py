"""Whether somebody calls the robot by a name: "Robot, go to the kitchen", "Hey Rosie"."""

import re
from typing import FrozenSet, Iterable, Optional

from voice_recognition.agreement import Heard
from voice_recognition.dialogue import Understood
from voice_recognition.voice_words import voice_words


class Calls:
    """The names by which a robot is called, or several robots."""

    def __init__(self, names: Iterable[str] = ()) -> None:
        """
        Args:
            names: as people say them
        """
        self.names = tuple(dict.fromkeys(" ".join(name.replace("_", " ").split()) for name in names if name.strip()))
        self._call = re.compile(
            rf"\W*(?:(?:{_any_of(voice_words().greetings)})\W+)?(?:{_any_of(self.names)})(?![\w'])\W*", re.IGNORECASE
        )

    @property
    def words(self) -> FrozenSet[str]:
        """The words of the names, in lower case."""
        return frozenset(word for name in self.names for word in name.lower().split())

    def behind(self, text: str) -> Optional[str]:
        """Return what stands behind the call in a text, empty for a call alone; None if it begins with no call."""
        call = self._call.match(text) if self.names else None
        return text[call.end() :] if call is not None else None


def _any_of(phrases: Iterable[str]) -> str:
    return "|".join(re.escape(one).replace(r"\ ", r"\W+") for one in sorted(phrases, key=len, reverse=True))


def understood(heard: Heard, calls: Calls) -> Understood:
    """Return the event of the dialogue for what was heard.

    Args:
        heard: by the searches
        calls: the names by which the robot is called
    """
    behind = calls.behind(" ".join(heard.by_ngram))
    return Understood(heard, is_called=behind is not None, is_call_only=behind == "")
