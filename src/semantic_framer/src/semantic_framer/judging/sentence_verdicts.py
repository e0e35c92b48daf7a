"""Verdicts that refuse a whole sentence: each has a name and a reason, and they run in a fixed order."""

from dataclasses import dataclass
from typing import Callable, FrozenSet, Iterable, Optional, Tuple

from semantic_framer.judging.said_words import AROUND_REQUESTS
from semantic_framer.judging.verdicts import Case
from semantic_framer.kinds.mood_file import UtteranceKind
from semantic_framer.kinds.question_extent import is_said_alone, up_to_its_end
from semantic_framer.kinds.utterance_kind import KindVerdict, kind_without_clause
from semantic_framer.values.outcome import CAREFUL, QUESTION, Refusal, asks_for_nothing, left_over_refusal, not_then
from semantic_framer.values.sentence import Sentence
from utterance_passes.phrases.clauses import Clause
from word_classes import word_class

_PARTICIPANTS = word_class("participants")
#: Replies quote the whole sentence without these final marks.
_MARKS = " .!?"


@dataclass(frozen=True)
class SentenceVerdict:
    """Refuses a whole sentence for a reason that a person can read; ``refuse`` returns None if it does not refuse."""

    name: str
    reason: str
    refuse: Callable[[Case], Optional[Refusal]]


def _nothing_asked(kind: KindVerdict, said: str) -> Refusal:
    return asks_for_nothing(kind.kind.name, kind.reason, said)


def _asks_for_nothing(case: Case) -> Optional[Refusal]:
    """Refuse a sentence that only asks or tells something, unless a unit may be about it: "the mug is on the table"."""
    said = case.sentence.tree.text.strip(_MARKS)
    if not case.clauses:
        kind = kind_without_clause(case.sentence.tree)
        return _nothing_asked(kind, said) if kind.kind in (UtteranceKind.TALK, UtteranceKind.QUESTION) else None
    for clause, kind in zip(case.clauses, case.kinds):
        if kind.kind is UtteranceKind.QUESTION:
            if case.acts or not is_said_alone(case.sentence):
                question = case.sentence.text(up_to_its_end(case.sentence, sorted(clause.positions)))
                return Refusal(QUESTION, f'Please ask "{question}" alone: I answer one question at a time.')
            return _nothing_asked(kind, case.text_of(clause) if case.clauses[1:] else said)
    if any(kind.is_read for kind in case.kinds) or any(clause.is_negated for clause in case.clauses):
        return None
    return _nothing_asked(case.kinds[0], said)


def _time(case: Case) -> Optional[Refusal]:
    """Refuse a command for another time.

    No frame element holds a time, and a time can hide the verb from the parser ("at five turn left"). So a time counts
    anywhere in the sentence, inside or outside its clauses. The verdict on negated clauses refuses those.
    """
    tree = case.sentence.tree
    times = [time for time in tree.times if not time & (tree.abandoned | tree.quoted)]
    inside = frozenset().union(*times)
    is_command = any(
        case.known.verbs_beginning_with(spelling)
        for word in tree.words
        if word.index not in inside
        for spelling in (word.lemma.lower(), word.said)
    )
    if times and is_command and not any(clause.is_negated for clause in case.clauses):
        return not_then(case.sentence, times[0])
    return None


def _no_verb(case: Case) -> Optional[Refusal]:
    if case.clauses:
        return None
    return Refusal("NO_VERB", f'I hear no command in "{case.sentence.tree.text.strip()}".')


def _told_inside(case: Case) -> Optional[Refusal]:
    """Refuse a request that has a telling clause inside: the meaning of both is uncertain."""
    for clause, kind in zip(case.clauses, case.kinds):
        if not kind.is_read and not case.is_background(clause):
            return left_over_refusal(case.sentence, sorted(clause.positions))
    return None


def _outside(case: Case) -> Optional[Refusal]:
    told = frozenset().union(*(told_above(case, clause) for clause in case.clauses))
    words = [index for index in words_outside(case.sentence, case.clauses) if index not in told]
    if words and case.policy.left_over_words in CAREFUL:
        return left_over_refusal(case.sentence, words)
    return None


def told_above(case: Case, clause: Clause) -> FrozenSet[int]:
    """Return the words above a clause that tells the reason for a command: "*the dog needs* to go out, open the
    door"."""
    tree = case.sentence.tree
    verb = tree.word(clause.verb)
    if verb.deprel != "xcomp" or case.kind_of(clause).acts or not case.is_background(clause):
        return frozenset()
    acting = (tree.subtree(one.verb) for one in case.clauses if case.kind_of(one).acts)
    return frozenset(tree.subtree(verb.head)).difference(*acting)


def words_outside(sentence: Sentence, clauses: Iterable[Clause]) -> Tuple[int, ...]:
    """Return the content words outside all clauses, without those of formulas such as "I would like you to ..."."""
    inside = frozenset().union(*(clause.positions for clause in clauses))
    return tuple(
        word.index
        for word in sentence.tree.words
        if word.index not in inside
        and sentence.is_content(word.index)
        and word.lemma.lower() not in AROUND_REQUESTS
        and not (word.deprel.startswith("nsubj") and word.said in _PARTICIPANTS)
    )


#: Verdicts before the clauses are read.
SENTENCE_VERDICTS: Tuple[SentenceVerdict, ...] = (
    SentenceVerdict("asks_for_nothing", "It is a question, a report, a wish or talk.", _asks_for_nothing),
    SentenceVerdict("another_time", "It is to be done at another time.", _time),
    SentenceVerdict("no_verb", "No verb asks for anything.", _no_verb),
)
#: Verdicts after all clauses are read.
REST_VERDICTS: Tuple[SentenceVerdict, ...] = (
    SentenceVerdict(
        "told_inside", "One of its clauses tells something, and is no background of the others.", _told_inside
    ),
    SentenceVerdict("words_outside", "Words of the sentence are in no clause.", _outside),
)
