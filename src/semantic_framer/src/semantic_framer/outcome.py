"""What comes of an utterance: it is understood, refused, or something is asked; and how careful the framer is."""

from dataclasses import dataclass
from enum import Enum
from typing import Iterable, Sequence, Tuple, Union

from semantic_framer.reading import Reading
from semantic_framer.sentence import Sentence

#: Codes of refusals of what was said against something that runs.
PROHIBITION = "NEGATED"
CORRECTION = "CORRECTION"
#: Codes of refusals of what asks for nothing to be done.
QUESTION = "QUESTION"
REPORT = "REPORT"
WISH = "WISH"
TALK = "TALK"
#: What a person says who answers no, or takes back what they were saying: nothing that runs is meant.
DECLINED = "DECLINED"


class LeftOverWords(Enum):
    """What to do when a reading does not account for every content word."""

    STRICT = "strict"  # refuse, and say which words
    WARN = "warn"  # act, and say which words
    IGNORE = "ignore"  # act, as in 2012


class Alternatives(Enum):
    """What to do with "the mug or the plate"."""

    ASK = "ask"
    EITHER = "either"


@dataclass(frozen=True)
class Policy:
    """How careful to be.

    Attributes:
        left_over_words: for words that a reading does not account for
        alternatives: for "or"
        question_timeout_s: how long a question may be answered
    """

    left_over_words: LeftOverWords = LeftOverWords.STRICT
    alternatives: Alternatives = Alternatives.EITHER
    question_timeout_s: float = 30.0


@dataclass(frozen=True)
class Understood:
    """What is to be done: clauses in order, the readings of each the best first; ``warning`` names words that were
    ignored.
    """

    clauses: Tuple[Tuple[Reading, ...], ...]
    warning: str = ""


@dataclass(frozen=True)
class Refusal:
    """It is not to be done; ``code`` as in ``Reply.code``."""

    code: str
    sentence: str
    left_over: Tuple[str, ...] = ()


@dataclass(frozen=True)
class Question:
    """Something must be known first; ``code`` as in ``Reply.code``."""

    code: str
    sentence: str


Outcome = Union[Understood, Refusal, Question]


def reply_outcome(of: Union[Refusal, Question]) -> str:
    """Return the outcome that a command ends with in the framer: the name of a constant of ``Reply``."""
    return "REFUSED" if isinstance(of, Refusal) else "NEEDS_INFORMATION"


def join_with_or(options: Sequence[str]) -> str:
    """Return options as a person lists them: "a, b or c"."""
    return " or ".join(filter(None, (", ".join(options[:-1]), *options[-1:])))


def left_over_refusal(sentence: Sentence, positions: Sequence[int]) -> Refusal:
    """Return the refusal of a sentence of which words are left over."""
    left = (sentence.word(index) for index in positions)
    words = tuple(word.form for word in left if word.upos != "PUNCT")
    return Refusal(
        "LEFT_OVER_WORDS",
        f'I do not understand "{" ".join(words)}" in "{sentence.tree.text.strip()}", so I do nothing.',
        left_over=words,
    )


def not_then(sentence: Sentence, positions: Iterable[int]) -> Refusal:
    """Return the refusal of what is to be done at another time, or under a condition."""
    return Refusal("CONDITION", f'I can only act now, not "{sentence.text(sorted(positions))}".')
