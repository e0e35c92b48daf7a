"""One lexical unit that is tried against one clause, and what is found for its elements."""

from typing import Dict, FrozenSet, Iterable, List, Tuple

from semantic_framer.filling.measured_elements import (
    is_in_a_measure,
    measured_elements,
    measures_as_in_2012,
)
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from semantic_types import Fit
from utterance_passes.engine.trace import TraceLine
from utterance_passes.phrases.clauses import Clause, shared_subject
from utterance_passes.phrases.measures import Amount
from utterance_passes.phrases.verb_matching import VerbMatch


class TriedUnit:
    """A lexical unit beside a clause, and what fills its elements so far.

    Attributes:
        sentence: the sentence
        clause: its clause
        unit: the unit
        frame: the frame that it evokes
        match: the words of its verb
        amounts: those of the clause
        without: rules that are switched off
        is_measuring: whether a unit of the verb asks for a measure
        subject: position of the subject, which another clause may share; 0 if there is none
        heads: the head of the phrase of each element
        listed: words of the unit's own list that are said for an element
        fits: how well a phrase fits the types of the relation that it fills, by element
        amount_of: the amount of each element
        numeral_of: numbers of several words, by element, in units of 2012
        unread: amounts that were said for an element but must not fill it
        unfinished: words of phrases without a noun; the framer asks for the elements that these phrases began
        notes: trace lines for phrases that rules moved or left out
    """

    def __init__(
        self,
        sentence: Sentence,
        clause: Clause,
        unit: LexicalUnit,
        frame: SemanticFrame,
        match: VerbMatch,
        amounts: Tuple[Amount, ...],
        without: FrozenSet[str],
        is_measuring: bool,
    ) -> None:
        self.without = without
        self.sentence = sentence
        self.clause = clause
        self.unit = unit
        self.frame = frame
        self.match = match
        self.amounts = amounts
        self.is_measuring = is_measuring
        self.fits: Dict[str, Fit] = {}
        self.heads: Dict[str, int] = {}
        self.listed: Dict[str, FrozenSet[int]] = {}
        measured = measured_elements(sentence, unit, frame, match.positions, amounts, clause.positions)
        self.amount_of = measured.amount_of
        self.unread = measured.unread
        self.unfinished: FrozenSet[int] = frozenset()
        self.numeral_of: Dict[str, Amount] = {}
        self.subject = clause.subject or shared_subject(sentence.tree, clause.verb)
        self.notes: List[TraceLine] = []

    def is_taken(self, name: str) -> bool:
        """Whether something is found for an element."""
        return name in self.heads or name in self.amount_of or name in self.numeral_of

    def is_core(self, name: str) -> bool:
        """Whether an element of the frame is a core element."""
        element = self.frame.element(name)
        return element is not None and element.is_core

    def is_in_a_measure(self, head: int) -> bool:
        """Whether a word belongs to an amount."""
        return any(head in amount.positions for amount in self.amount_of.values()) or (
            not measures_as_in_2012(self.unit)
            and is_in_a_measure(self.sentence, head, self.amounts, is_measuring=self.is_measuring)
        )

    def note(self, rule: str, positions: Iterable[int], what: str) -> None:
        """Write what a rule did with words."""
        words = frozenset(positions)
        self.notes.append(TraceLine(rule, tuple(sorted(words)), self.sentence.text(sorted(words)), "", what))
