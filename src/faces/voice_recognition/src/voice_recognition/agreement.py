"""Compares what two searches heard: one is forced into the grammar, the other is not."""

import enum
from dataclasses import dataclass
from typing import Mapping, Optional, Sequence, Tuple

from command_server.emergency_words import is_emergency_stop
from command_server.stop_words import is_stop
from voice_recognition.offers import Offer, OfferFinder, without_politeness
from voice_recognition.spoken_language import Words

#: From this share of equal words on, words that the second search misheard do not count.
NEARLY_EQUAL = 0.4
#: Shorter commands have to be heard by both searches.
FEWEST_WORDS = 2


class Verdict(enum.Enum):
    """How sure it is what was said."""

    SURE = "sure"  # both searches heard the same command
    LIKELY = "likely"  # the grammar heard a command, and the other search most of its words
    CHOICE = "choice"  # they heard two different commands
    AGAIN = "again"  # the grammar heard a command, and the other search something else
    NOTHING = "nothing"  # no search heard a command


@dataclass(frozen=True)
class Heard:
    """What was heard.

    Attributes:
        verdict: how sure it is
        offers: commands that may have been said: one, two for a choice, none otherwise
        by_grammar, by_ngram: words that the searches heard
        answer: name of the answer that both searches heard; empty for none
        is_stop: whether both searches heard words that stop the robot
    """

    verdict: Verdict
    offers: Tuple[Offer, ...] = ()
    by_grammar: Words = ()
    by_ngram: Words = ()
    answer: str = ""
    is_stop: bool = False

    @property
    def is_emergency(self) -> bool:
        """Whether both searches heard the emergency stop."""
        return all(is_emergency_stop(" ".join(words)) for words in (self.by_grammar, self.by_ngram))


def compare(by_grammar: Words, by_ngram: Words, finder: OfferFinder) -> Heard:
    """Compare what both searches heard of a command."""
    one, other = finder.find(by_grammar), finder.find(by_ngram)
    stops = is_stop(" ".join(by_grammar)) and is_stop(" ".join(by_ngram))
    verdict, offers = _verdict(one, other, share_of_equal_words(by_grammar, by_ngram), len(by_grammar))
    return Heard(verdict, offers, by_grammar, by_ngram, is_stop=stops)


def _verdict(
    one: Optional[Offer], other: Optional[Offer], equal: float, count: int
) -> Tuple[Verdict, Tuple[Offer, ...]]:
    if one is not None and other is not None:
        if one.means_the_same(other):
            return Verdict.SURE, (one,)
        return Verdict.CHOICE, (one, other)
    if one is None:
        return Verdict.NOTHING, ()
    if count >= FEWEST_WORDS and equal >= NEARLY_EQUAL:
        return Verdict.LIKELY, (one,)
    return Verdict.AGAIN, ()


def compare_answers(by_grammar: Words, by_ngram: Words, answers: Mapping[str, Sequence[Words]]) -> Heard:
    """Compare what both searches heard as the answer to a question; only equal answers count."""
    one, other = answer_of(by_grammar, answers), answer_of(by_ngram, answers)
    stops = is_stop(" ".join(by_grammar)) and is_stop(" ".join(by_ngram))
    if one and one == other:
        return Heard(Verdict.SURE, (), by_grammar, by_ngram, answer=one, is_stop=stops)
    return Heard(Verdict.AGAIN if one else Verdict.NOTHING, (), by_grammar, by_ngram, is_stop=stops)


def answer_of(words: Words, answers: Mapping[str, Sequence[Words]]) -> str:
    """Return the name of the answer that some words are; empty for none."""
    said = without_politeness(words)
    return next((name for name, ways in answers.items() if words in ways or said in ways), "")


def share_of_equal_words(one: Words, other: Words) -> float:
    """Return 1 less the edits from one to the other, divided by the words of the longer one."""
    if not one or not other:
        return 0.0
    row = list(range(len(other) + 1))
    for at, word in enumerate(one, 1):
        diagonal, row[0] = row[0], at
        for column, against in enumerate(other, 1):
            diagonal, row[column] = (
                row[column],
                min(row[column] + 1, row[column - 1] + 1, diagonal + (word != against)),
            )
    return 1.0 - row[-1] / max(len(one), len(other))
