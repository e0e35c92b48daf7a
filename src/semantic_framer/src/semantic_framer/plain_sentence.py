"""Understands a sentence without conditions: small talk, a question, a change of the last command, or a command."""

from dataclasses import replace
from typing import Optional, Sequence, Tuple, Union

from semantic_framer.amending import Change, change_of
from semantic_framer.choices import choices_of_amounts, choices_of_clauses
from semantic_framer.dialogue import Context, Pending
from semantic_framer.found_clauses import found_clauses
from semantic_framer.mood_file import UtteranceKind
from semantic_framer.outcome import REPORT, LeftOverWords, Outcome, Question, Refusal, Understood
from semantic_framer.questions import question_readings
from semantic_framer.readings import ClauseReadings, Heard, as_wish, readings_of_clause
from semantic_framer.sentence import Sentence
from semantic_framer.sentence_verdicts import (
    REST_VERDICTS,
    SENTENCE_VERDICTS,
    SentenceVerdict,
    words_outside,
)
from semantic_framer.settling import Now, ask_which, resolve_and_confirm
from semantic_framer.small_talk import answer_small_talk, small_talk_of
from semantic_framer.utterance_kind import KindVerdict
from semantic_framer.verdicts import Case, case_of
from word_classes import word_class

_WANTING = word_class("wanting_verbs")


def read_plain(sentence: Sentence, context: Context, now: Now) -> Heard:
    """Understand a sentence that has no conditions.

    Args:
        sentence: the sentence
        context: what the framer remembers of earlier utterances
        now: the circumstances of the utterance
    """
    talk = small_talk_of(sentence.tree)
    if talk is not None:
        kind = KindVerdict(UtteranceKind.TALK, talk.name)
        now.write("utterance_kind", sentence.tree.text, str(kind))
        return Heard(answer_small_talk(talk), context, sentence, is_small_talk=True)
    change = change_of(sentence, context, now.known) if now.policy.fragment_timeout_s else None
    if change is not None:
        now.write("fragment", sentence.tree.text, change.note)
        return Heard(*_changed(change, sentence, context, now), sentence)
    known, policy = now.known, now.policy
    case = case_of(sentence, found_clauses(sentence, known, now.trace), known, policy)
    if now.trace is not None:
        for clause, kind in zip(case.clauses, case.kinds):
            now.trace.add("utterance_kind", case.text_of(clause), after=str(kind), positions=clause.positions)
    asked = question_readings(case)
    if asked:
        now.write("question", str(asked[0]), f'answered, by "{asked[0].verb}"')
        return Heard(*resolve_and_confirm((asked,), sentence, context, now), sentence)
    refusal = _refusal(SENTENCE_VERDICTS, case, now)
    if refusal is not None:
        return Heard(refusal, context, sentence)
    clauses = _readings(case, now)
    refusal = _rest_refusal(case, clauses, now)
    if refusal is not None:
        return Heard(refusal, context, sentence, clauses)
    best = [read.kept[0] for read in clauses]
    choices = choices_of_clauses(sentence, [read.clause for read in clauses], known) or choices_of_amounts(
        sentence, best, known
    )
    if choices:
        offered = " or ".join(choice.text for choice in choices)
        now.write("choices", offered, "asked. The person left it open.")
        return Heard(*ask_which(choices, context, now), sentence, clauses)
    kept = tuple(read.kept for read in clauses)
    outcome, context = resolve_and_confirm(kept, sentence, context, now)
    words = words_outside(sentence, case.clauses)
    if isinstance(outcome, Understood) and words and policy.left_over_words is LeftOverWords.WARN:
        ignored = " ".join(sentence.word(index).form for index in words)
        outcome = replace(outcome, warning=f"{outcome.warning or 'ignored:'} {ignored}")
    return Heard(outcome, context, sentence, clauses)


def deeds_of(case: Case, now: Now) -> Union[Refusal, Tuple[ClauseReadings, ...]]:
    """Return the readings of the clauses of a sentence, or why it is refused."""
    refusal = _refusal(SENTENCE_VERDICTS, case, now)
    if refusal is not None:
        return refusal
    clauses = _readings(case, now)
    return _rest_refusal(case, clauses, now) or clauses


def _changed(change: Change, sentence: Sentence, context: Context, now: Now) -> Tuple[Outcome, Context]:
    """Carry out a changed command, or ask first."""
    if change.outcome is not None:
        return change.outcome, context
    if not change.wants_yes:
        return resolve_and_confirm(change.clauses, sentence, context, now)
    act = change.clauses[0][0].clause_text
    now.write("confirm", act, "asked. The amount would be done again.")
    pending = Pending(change.clauses, 0, (), now.expires_s)
    return Question("CONFIRM", f'Shall I do this: "{act}"? Say yes or no.'), replace(context, pending=pending)


def _readings(case: Case, now: Now) -> Tuple[ClauseReadings, ...]:
    """Read each clause except the clauses that only tell something."""
    found = []
    has_order = any(word.form.lower() == "then" for word in case.sentence.tree.words)
    for clause, kind in zip(case.clauses, case.kinds):
        is_read = kind.is_read or clause.is_negated
        read = readings_of_clause(case, clause, now.trace) if is_read else None
        is_told = read is None or (read.refusal is not None and read.refusal.code == REPORT)
        if read is not None and not (is_told and case.is_background(clause)):
            found.append(as_wish(read) if clause.lemma in _WANTING and not has_order else read)
        elif now.trace is not None:
            now.trace.add("told", case.text_of(clause), after="no step", positions=clause.positions)
    return tuple(found)


def _rest_refusal(case: Case, clauses: Tuple[ClauseReadings, ...], now: Now) -> Optional[Refusal]:
    refused = next((read.refusal for read in clauses if read.refusal), None)
    return refused or _refusal(REST_VERDICTS, case, now)


def _refusal(verdicts: Sequence[SentenceVerdict], case: Case, now: Now) -> Optional[Refusal]:
    for verdict in verdicts:
        refusal = verdict.refuse(case)
        if refusal is not None:
            if now.trace is not None:
                now.trace.add(verdict.name, after=f"refused. {verdict.reason}")
            return refusal
    return None
