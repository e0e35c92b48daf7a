"""What persons taught the robot by their answers: words that mean a verb it knows, and words that do not."""

import re
from dataclasses import dataclass

_NOT_IN_NAMES = re.compile(r"[^a-z0-9]+")


@dataclass(frozen=True)
class LearnedUnit:
    """Words that mean a known verb.

    Attributes:
        name: of its own, by which it is listed and forgotten: "make_your_way"
        said: the words, in lower case: "make your way"
        verb: the known verb: "go"
        frame_name: the frame that they evoke
        text: of the lexical unit file
        who: id of the person who agreed; empty when nobody was known
        when_s: when, seconds since 1970
        sentence: in which the words were said
    """

    name: str
    said: str
    verb: str
    frame_name: str
    text: str
    who: str
    when_s: float
    sentence: str

    @property
    def path(self) -> str:
        """The path under which its lexical unit file is known; no such file lies there."""
        return f"learned/{self.name}.yaml"


@dataclass(frozen=True)
class Declined:
    """Words of which a person said that they do not mean a frame.

    Attributes:
        said: the words, in lower case
        frame_name: the frame
        who, when_s, sentence: see :class:`LearnedUnit`
    """

    said: str
    frame_name: str
    who: str
    when_s: float
    sentence: str


def name_of(said: str, frame_name: str) -> str:
    """Return the name of a learned unit."""
    return f"{_NOT_IN_NAMES.sub('_', said.lower()).strip('_') or 'unit'}.{frame_name}"
