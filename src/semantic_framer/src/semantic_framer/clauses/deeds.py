"""Reads the clauses of a sentence that are to be done, or refuses the sentence."""

from typing import FrozenSet, List, Optional, Sequence, Tuple

from semantic_framer.clauses.readings import ClauseReadings, as_wish, readings_of_clause, with_extra
from semantic_framer.clauses.things_done import told_by_deeds
from semantic_framer.filling.extra_phrases import prohibition_beside
from semantic_framer.judging.sentence_verdicts import REST_VERDICTS, SENTENCE_VERDICTS, SentenceVerdict, told_above
from semantic_framer.judging.verdicts import Case
from semantic_framer.values.outcome import REPORT, LeftOverWords, Refusal
from utterance_passes.engine.trace import Trace
from utterance_passes.phrases.clauses import Clause
from word_classes import word_class

_HEARERS = word_class("hearers")
_NOT = word_class("not")
_WANTING = word_class("wanting_verbs")


def deeds_of(case: Case, trace: Optional[Trace]) -> Tuple[Optional[Refusal], Tuple[ClauseReadings, ...]]:
    """Return why a sentence is refused (None if it is not), and the readings of its clauses.

    Args:
        case: the sentence with its clauses
        trace: receives a line for each unit, verdict and rank; None for no trace
    """
    refusal = _refusal(SENTENCE_VERDICTS, case, trace)
    if refusal is not None:
        return refusal, ()
    clauses = _deeds(case, trace)
    refused = next((read.refusal for read in clauses if read.refusal), None)
    refused = refused or _refusal(REST_VERDICTS, case, trace)
    return (refused, clauses) if refused is not None else told_by_deeds(case, clauses, trace)


def _deeds(case: Case, trace: Optional[Trace]) -> Tuple[ClauseReadings, ...]:
    """Read each clause except the clauses that only tell something."""
    found: List[ClauseReadings] = []
    ahead: List[Clause] = []
    has_order = any(word.said == "then" for word in case.sentence.tree.words)
    for clause, kind in zip(case.clauses, case.kinds):
        is_read = kind.is_read or (clause.is_negated and not _is_reason(case, clause))
        is_beside = bool(found and found[-1].kept) or (not found and _is_before_command(case, clause))
        if is_beside and _is_forbidden_meanwhile(case, clause):
            if found:
                found[-1] = with_extra(found[-1], prohibition_beside(case.sentence, clause))
            else:
                ahead.append(clause)
            if trace is not None:
                trace.add("forbidden_meanwhile", case.text_of(clause), after="asked", positions=clause.positions)
            continue
        read = readings_of_clause(case, clause, trace) if is_read else None
        while read is not None and read.kept and ahead:
            read = with_extra(read, prohibition_beside(case.sentence, ahead.pop(0)))
        is_told = read is None or (read.refusal is not None and read.refusal.code == REPORT)
        if read is not None and not (is_told and case.is_background(clause)):
            found.append(as_wish(read) if clause.lemma in _WANTING and not has_order else read)
        elif trace is not None:
            trace.add("told", case.text_of(clause), after="no step", positions=clause.positions)
    return tuple(found)


def words_told(case: Case, clauses: Sequence[ClauseReadings]) -> FrozenSet[int]:
    """Return the positions of the words that only tell something, beside clauses that are to be done."""
    read = [one.clause for one in clauses]
    told = [clause for clause in case.clauses if clause not in read and case.is_background(clause)]
    return frozenset().union(*(clause.positions | told_above(case, clause) for clause in told))


def _is_before_command(case: Case, clause: Clause) -> bool:
    """Whether a command of its own follows a clause, behind a mark: "don't touch the vase; *clean the table*"."""
    words = case.sentence.tree.words
    return any(
        kind.acts
        and case.sentence.word(other.verb).deprel == "parataxis"
        and any(word.upos == "PUNCT" for word in words[clause.verb : other.verb])
        for other, kind in zip(case.clauses, case.kinds)
    )


def _is_forbidden_meanwhile(case: Case, clause: Clause) -> bool:
    """Whether a clause says what is not to be done besides a command: "take the cup, but *don't drop it*"."""
    if case.policy.left_over_words is not LeftOverWords.ASK or not clause.is_negated or clause.condition:
        return False
    subject = case.sentence.word(clause.subject).said if clause.subject else ""
    forms = [child.said for child in case.sentence.children(clause.verb)]
    is_forbidden = "never" in forms or ("do" in forms and not _NOT.isdisjoint(forms))
    return (not subject or subject in _HEARERS) and is_forbidden


def _is_reason(case: Case, clause: Clause) -> bool:
    """Whether a negated clause gives the reason for a later command, and forbids nothing: "*I can't reach it*, get it
    for me"."""
    subject = case.sentence.word(clause.subject).said if clause.subject else ""
    is_before = clause.verb < max((one.verb for one, kind in zip(case.clauses, case.kinds) if kind.acts), default=0)
    return is_before and bool(subject) and subject not in _HEARERS and case.is_background(clause)


def _refusal(verdicts: Sequence[SentenceVerdict], case: Case, trace: Optional[Trace]) -> Optional[Refusal]:
    for verdict in verdicts:
        refusal = verdict.refuse(case) if verdict.name not in case.known.without else None
        if refusal is not None:
            if trace is not None:
                trace.add(verdict.name, after=f"refused. {verdict.reason}")
            return refusal
    return None
