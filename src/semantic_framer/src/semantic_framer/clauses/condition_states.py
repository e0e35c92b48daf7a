"""Reads the states that only conditions say: times of the clock, amounts, and what is said without a subject.

"It is after ten", "the battery is below 20 percent", "you are two metres from the wall", "once at the door", "when
done".
"""

from typing import FrozenSet, Iterator, Optional, Sequence

from semantic_framer.clauses.state_clauses import state_clause
from semantic_framer.clauses.state_phrases import (
    IN_STATE,
    MEASURED,
    WHETHER,
    Positions,
    StateClause,
    StatePhrases,
)
from semantic_framer.kinds.clause_features import ClauseFeatures
from semantic_framer.values.sentence import Sentence
from semantic_types import Fit
from utterance_passes.phrases.clock_times import ClockTime, clock_time_at
from utterance_passes.phrases.measures import find_amounts
from utterance_passes.trees.tree import Word
from word_classes import word_class

#: The frames of what the clock shows, and of being where one was to come.
CLOCK, THERE = "being_a_time", "being_there"
_SAYING_NOTHING = frozenset(["be", "have"])
#: The element of an amount for the verb that says it, if it says more than "be".
VERB = "verb"
#: The element of an amount for the words before it: "at least".
COMPARISON = "comparison"
_IT = "it"
_BEFORE_AMOUNTS = frozenset(["ADP", "ADV", "ADJ", "SCONJ"])
_PLACES = word_class("place_prepositions")
_STANDARDS = ("prep_from", "prep_of", "prep_to", "prep_before", "prep_in_front_of")
#: Words between a distance and what it is measured from: "two metres *away* from the wall".
_APART = frozenset(["away", "front", "shy", "short"])
_PARTICIPLES = frozenset(["VBN", "JJ"])
#: What somebody can come to.
_DESTINATIONS = ("Location", "Physical_object")


def condition_states(
    sentence: Sentence, features: ClauseFeatures, words: FrozenSet[int], *, is_until: bool
) -> Iterator[StateClause]:
    """Yield what a condition may say of a state; nothing for other clauses, and where a word is left over.

    Args:
        sentence: the sentence
        features: of the clause
        words: positions of its words, without what only denies
        is_until: whether "until" stands before them, so that a place means to be there: "until the wall"
    """
    reader = _OfCondition(sentence, features, words, is_asked=False)
    found = reader.read(is_until)
    if found is not None and reader.has_all_words(found):
        yield found
    usual = state_clause(sentence, features, words, is_asked=False)
    if usual is not None and usual.asked == WHETHER and usual.elements:
        yield usual


def clock_of(forms: Sequence[str], *, is_said: bool) -> Optional[ClockTime]:
    """Return the time of the clock that some words are as a whole; None if they are none, or one of each day.

    Args:
        forms: in lower case
        is_said: whether they are certainly a time: "it is *ten*"
    """
    clock = clock_time_at(["at", *forms] if is_said else forms)
    is_whole = clock is not None and clock.length == len(forms) + is_said
    return clock if is_whole and clock is not None and clock.when is not None and clock.when.kind == "time" else None


class _OfCondition(StatePhrases):
    """Reads what questions have no words for."""

    def read(self, is_until: bool) -> Optional[StateClause]:
        """Return what the clause says; None if it is no such clause."""
        return self._of_clock() or self._of_amount() or (self._without_subject(is_until) if not self._subject else None)

    def _said(self) -> Positions:
        """Return the words of the predicate, in order."""
        subject = self._sentence.subtree(self._subject.index) if self._subject is not None else frozenset()
        small = {c.index for c in self._children if c.deprel.split(":")[0] in ("cop", "aux", "mark", "punct")}
        return tuple(index for index in sorted(self._words - subject) if index not in small or index == self._top.index)

    def _of_clock(self) -> Optional[StateClause]:
        if self._subject is not None and (not self._is_predicate or self._subject_form() != _IT):
            return None
        words = self._said()
        is_said = self._subject is not None or any(self._words <= time for time in self._sentence.tree.times)
        forms = [self._sentence.word(index).said for index in words]
        # "*After* ten", "*later than* ten".
        sides = range(1 if self._subject is None else 3)
        side = next((count for count in sides if clock_of(forms[count:], is_said=is_said) is not None), None)
        if side is None:
            return None
        elements = {"time": words[side:], **({"side": words[:side]} if side else {})}
        self._asking = frozenset(words)
        return StateClause(CLOCK, WHETHER, elements)

    def _subject_form(self) -> str:
        return self._subject.said if self._subject is not None else ""

    def _of_amount(self) -> Optional[StateClause]:
        """Read "is below 20 percent", "falls below 20 percent", "are two metres from the wall"."""
        if self._subject is None:
            return None
        words = self._said()
        elements = {"theme": self._phrase(self._subject)}
        if not self._is_predicate:
            if self._top.upos not in ("VERB", "AUX") or words[:1] != (self._top.index,):
                return None
            words = words[1:]
            if self._lemma not in _SAYING_NOTHING:
                elements[VERB] = (self._top.index,)
        start = next((i for i, one in enumerate(words) if self._sentence.word(one).upos not in _BEFORE_AMOUNTS), 0)
        before, rest = words[:start], words[start:]
        if len(rest) == 2 and self._sentence.word(rest[0]).upos == "NUM":
            # "20 percent" counts, and is no amount.
            measure: Positions = rest[:1]
            elements["unit"] = rest[1:]
        else:
            amounts = find_amounts(self._sentence.tree, rest)
            if len(amounts) != 1 or amounts[0].is_doubtful or amounts[0].positions[0] != rest[0]:
                return None
            measure = tuple(amounts[0].positions)
        behind = rest[len(measure) + len(elements.get("unit", ())) :]
        elements["measure"] = measure
        if before:
            elements[COMPARISON] = before
        self._asking = frozenset(words)
        if not behind:
            return StateClause(MEASURED, WHETHER, elements)
        standard = self._standard(measure)
        if standard is None or behind[-1] != max(self._phrase(standard)):
            return None
        elements["standard"] = self._phrase(standard, self._cases(standard))
        between = (self._sentence.word(index) for index in behind if index < elements["standard"][0])
        if any(word.upos != "ADP" and word.said not in _APART for word in between):
            return None
        return StateClause(MEASURED, WHETHER, elements)

    def _standard(self, measure: Positions) -> Optional[Word]:
        """Return what a distance is measured from."""
        found = (
            self._sentence.word(index)
            for governor in (self._top.index, *measure)
            for relation in _STANDARDS
            for index in self._sentence.dependents(governor, relation)
        )
        return next(found, None)

    def _without_subject(self, is_until: bool) -> Optional[StateClause]:
        """Read "once *at the door*", "until *the wall*", "when *done*": the robot is meant."""
        top = self._top
        if any(child.deprel.split(":")[0] in ("aux", "cop", "obj") for child in self._children):
            return None
        if top.xpos in _PARTICIPLES:
            return StateClause(IN_STATE, WHETHER, {"state": (top.index,)})
        cases = [child.said for child in self._sentence.tree.prepositions(top.index) if child.index in self._words]
        if not self._is_destination(is_until, cases):
            return None
        return StateClause(THERE, WHETHER, {"goal": self._phrase(top)})

    def _is_destination(self, is_until: bool, cases: Sequence[str]) -> bool:
        """Whether somebody can come to a thing or a place: "at the end", "the wall", but not "lunch"."""
        if any(self._top.index in time for time in self._sentence.tree.times):
            return False
        fit = self._sentence.types.fit(self._top.index, _DESTINATIONS)
        if cases and cases[0] in _PLACES:
            return fit is not Fit.WRONG
        children = self._sentence.children(self._top.index)
        is_named = any(child.deprel in ("det", "nummod", "nmod:poss") for child in children)
        return is_until and cases in ([], ["to"]) and is_named and fit is Fit.LIKELY
