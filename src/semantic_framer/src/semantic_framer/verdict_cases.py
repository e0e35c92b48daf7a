"""What a verdict is: a name, a reason, and a function that judges a sentence, a clause or a reading."""

from dataclasses import dataclass
from typing import Callable, Optional, Tuple

from semantic_framer.framed_lexicon import FramedLexicon
from semantic_framer.outcome import Policy, Refusal
from semantic_framer.reading import Reading
from semantic_framer.sentence import Sentence
from utterance_passes.clauses import Clause
from utterance_passes.verb_matching import VerbMatch


@dataclass(frozen=True)
class Case:
    """What is judged.

    Attributes:
        sentence: the sentence
        clauses: all of it
        known: lexical units and frames
        policy: how careful to be
    """

    sentence: Sentence
    clauses: Tuple[Clause, ...]
    known: FramedLexicon
    policy: Policy


@dataclass(frozen=True)
class ClauseCase:
    """A clause that is judged.

    Attributes:
        of: the sentence around it
        clause: the clause
        matches: verbs of the lexicon that it uses
    """

    of: Case
    clause: Clause
    matches: Tuple[VerbMatch, ...]

    @property
    def sentence(self) -> Sentence:
        """The sentence."""
        return self.of.sentence

    @property
    def said(self) -> str:
        """The words of the clause."""
        words = sorted(self.clause.positions)
        return self.sentence.text([index for index in words if self.sentence.word(index).upos != "PUNCT"])


@dataclass(frozen=True)
class SentenceVerdict:
    """Refuses a whole sentence, for a reason that a person may read; ``refuse`` returns None where it does not."""

    name: str
    reason: str
    refuse: Callable[[Case], Optional[Refusal]]


@dataclass(frozen=True)
class ClauseVerdict:
    """Refuses a clause whatever its readings are."""

    name: str
    reason: str
    refuse: Callable[[ClauseCase], Optional[Refusal]]


#: Whether a reading is dropped, seen beside the others.
Drops = Callable[[ClauseCase, Reading, Tuple[Reading, ...]], bool]


@dataclass(frozen=True)
class ReadingVerdict:
    """Drops readings of a clause.

    Attributes:
        name: by which it is traced
        reason: why such a reading cannot be meant
        drops: whether a reading is dropped
        refuse: what a person hears where none is left; None goes on to the next verdict
    """

    name: str
    reason: str
    drops: Drops
    refuse: Callable[[ClauseCase], Optional[Refusal]] = lambda case: None
