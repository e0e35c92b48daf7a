"""What persons taught the robot by their answers: words that mean a verb it knows, and words that do not."""

import re
from dataclasses import dataclass

_NOT_IN_NAMES = re.compile(r"[^a-z0-9]+")
#: In the place of a frame: a noun that is a kind of another noun, and a name of a place. No frame has such a name.
KIND, PLACE = "(kind)", "(place)"
#: Between the text of the lexical unit file and that of the frame file.
_BETWEEN = "\n---\n"


@dataclass(frozen=True)
class LearnedUnit:
    """Words that mean a known verb, one deed or a sequence of deeds; a kind; or a place.

    Attributes:
        name: of its own, by which it is listed and forgotten: "make_your_way"
        said: the words, in lower case: "make your way"
        verb: the known verb, "go", or the sentence that says what they mean; the noun of a kind; the id of a place
        frame_name: the frame that they evoke; KIND or PLACE
        text: of the lexical unit file, and of the frame file that a sequence needs; see :func:`text_with_frame`
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

    @property
    def meaning(self) -> str:
        """What the words mean, as a sentence."""
        if self.frame_name == KIND:
            return f'"{self.said}" is a kind of "{self.verb}"'
        if self.frame_name == PLACE:
            return f'"{self.said}" is a name of the place {self.verb}'
        return f'"{self.said}" means "{self.verb}"'

    @property
    def unit_text(self) -> str:
        """The text of its lexical unit file; empty for a kind or a place."""
        return self.text.partition(_BETWEEN)[0]

    @property
    def frame_text(self) -> str:
        """The text of the frame file of a sequence; empty for everything else."""
        return self.text.partition(_BETWEEN)[2]


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
    return f"{name_in_words(said)}.{frame_name.strip('()')}"


def text_with_frame(unit_text: str, frame_text: str) -> str:
    """Return the text of a unit whose words mean a sequence of deeds.

    Args:
        unit_text: of the lexical unit file
        frame_text: of the frame file, which says the sequence
    """
    return unit_text.rstrip() + _BETWEEN + frame_text


def name_in_words(said: str) -> str:
    """Return words as the name of a frame has them: "tidy_up"."""
    return _NOT_IN_NAMES.sub("_", said.lower()).strip("_") or "unit"
