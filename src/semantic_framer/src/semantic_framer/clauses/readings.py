"""Finds the plausible readings of a clause, or the refusal that a person hears if there are none."""

from dataclasses import dataclass, replace
from typing import Callable, FrozenSet, Iterable, Optional, Tuple, Union

from semantic_framer.filling.control import ITERATION, kept_up, with_duration, with_times
from semantic_framer.filling.extra_phrases import extra_arguments
from semantic_framer.filling.matching import match_units
from semantic_framer.filling.unheeded import with_heeded_extras, without_unheeded
from semantic_framer.judging.verdicts import (
    CLAUSE_VERDICTS,
    COMPARING,
    DOMINATED,
    PLAUSIBILITY,
    READING_VERDICTS,
    Case,
    ClauseCase,
    ClauseVerdict,
    ReadingVerdict,
)
from semantic_framer.units.frame_roles import NAME
from semantic_framer.units.heeding import FrameHeeding
from semantic_framer.values.dialogue import Context, Lesson
from semantic_framer.values.outcome import CAREFUL, Outcome, Refusal
from semantic_framer.values.reading import Reading, rank, without_duplicates
from semantic_framer.values.sentence import Sentence
from semantic_framer.values.slight_amounts import stated
from semantic_framer.values.things import is_indefinite
from semantic_frames.lexical_unit import ArgumentForm
from typed_arguments import TypedArgument
from utterance_passes.engine.trace import Trace
from utterance_passes.phrases.clauses import Clause
from utterance_passes.phrases.shared_objects import shared_object
from utterance_passes.phrases.verb_matching import match_verbs
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.wording.typos import as_written
from word_classes import word_class

#: Relations of phrases below a noun: "a left *at the door*".
_PHRASES = frozenset(["nmod", "obl", "acl", "advcl", "appos"])
#: Relations of words that choose one of several: "the *second* left".
_CHOOSING = frozenset(["amod", "nummod"])
#: Words that join a clause to the clause before it: "go to the kitchen *to* get the mug".
_JOINING = frozenset(["and", "to"])
_LEFT_AND_RIGHT = word_class("left_and_right")
_SAID_AROUND = word_class("harmless")


@dataclass(frozen=True)
class ClauseReadings:
    """The readings of a clause.

    Attributes:
        clause: the clause
        plausible: the plausible readings, best first, even if the clause is refused
        kept: the plausible readings that no verdict drops
        refusal: why no reading is kept; None if there are some
    """

    clause: Clause
    plausible: Tuple[Reading, ...]
    kept: Tuple[Reading, ...]
    refusal: Optional[Refusal] = None


@dataclass(frozen=True)
class Heard:
    """The result of an utterance.

    Attributes:
        outcome: what to do, why nothing is done, or what to ask
        context: what to remember
        sentence: the sentence that was read; None if the person must first say what was meant
        clauses: the clauses of the sentence with their readings; empty if no clause was read
        is_small_talk: whether it is small talk from end to end, which is against nothing that runs
        named: positions of words that no reading has, and that are understood: what joins clauses, what is only told,
            and when it begins
        lessons: what the answer to a question teaches
        is_answer: whether it answers a question, so that the readings are those of an earlier sentence
    """

    outcome: Outcome
    context: Context
    sentence: Optional[Sentence] = None
    clauses: Tuple[ClauseReadings, ...] = ()
    is_small_talk: bool = False
    named: FrozenSet[int] = frozenset()
    is_answer: bool = False
    lessons: Tuple[Lesson, ...] = ()


#: Understands another tree of the sentence.
Read = Callable[[DependencyTree], Heard]


def as_wish(read: ClauseReadings) -> ClauseReadings:
    """Return readings of a clause that wishes for a thing."""
    return replace(read, kept=tuple(replace(reading, is_wish=True) for reading in read.kept))


def with_extra(read: ClauseReadings, extra: TypedArgument) -> ClauseReadings:
    """Return readings of a clause beside which something was said that no server heeds."""
    return replace(read, kept=tuple(replace(one, extra=(*(one.extra or ()), extra)) for one in read.kept))


def readings_of_clause(of: Case, clause: Clause, trace: Optional[Trace] = None) -> ClauseReadings:
    """Read one clause; one that is not whole may have the object of the next: "open and close *the door*".

    Args:
        of: the sentence with the clause
        clause: the clause
        trace: receives a line for each unit, verdict and rank; None for no trace
    """
    read = _judged(of, clause, trace)
    shared = shared_object(of.sentence.tree, clause.verb) if "shared_object" not in of.known.without else 0
    if not shared or any(not reading.missing for reading in read.kept):
        return read
    lines = Trace() if trace is not None else None
    wider = replace(clause, positions=clause.positions | of.sentence.subtree(shared))
    clauses = tuple(wider if one == clause else one for one in of.clauses)
    sharing = _judged(replace(of, clauses=clauses), wider, lines)
    whole = tuple(reading for reading in sharing.kept if not reading.missing)
    if not whole:
        return read
    if trace is not None and lines is not None:
        words = sorted(of.sentence.subtree(shared))
        trace.add("shared_object", clause.lemma, "", f"{of.sentence.text(words)}: of this clause too", words)
        trace.extend(lines.lines)
    return replace(sharing, clause=clause, kept=whole)


def _judged(of: Case, clause: Clause, trace: Optional[Trace]) -> ClauseReadings:
    case = ClauseCase(of, clause, match_verbs(of.sentence.tree, clause, of.known))
    if trace is not None:
        trace.add("clause", clause.lemma, after=case.said, positions=clause.positions)
    for verdict in CLAUSE_VERDICTS:
        refusal = verdict.refuse(case) if verdict.name not in of.known.without else None
        if refusal is not None:
            return _refused(case, (), verdict, refusal, trace)
    plausible = kept = plausible_readings(case, trace)
    for reading_verdict in READING_VERDICTS:
        if reading_verdict.name in of.known.without:
            continue
        kept = _drop([reading_verdict], case, kept, kept, trace)
        refusal = None if kept else reading_verdict.refuse(case)
        if refusal is not None:
            return _refused(case, plausible, reading_verdict, refusal, trace)
    if trace is not None:
        for number, reading in enumerate(kept, start=1):
            trace.add(
                "rank",
                str(reading),
                after=f"{number}. of {len(kept)} ({rank(reading)})",
                positions=reading.verb_positions,
            )
    return ClauseReadings(clause, plausible, kept)


def _refused(
    case: ClauseCase,
    plausible: Tuple[Reading, ...],
    verdict: Union[ClauseVerdict, ReadingVerdict],
    refusal: Refusal,
    trace: Optional[Trace],
) -> ClauseReadings:
    if trace is not None:
        trace.add(verdict.name, case.clause.lemma, after=f"refused. {verdict.reason}", positions=case.clause.positions)
    return ClauseReadings(case.clause, plausible, (), refusal)


def _drop(
    verdicts: Iterable[ReadingVerdict],
    case: ClauseCase,
    readings: Tuple[Reading, ...],
    beside: Tuple[Reading, ...],
    trace: Optional[Trace],
) -> Tuple[Reading, ...]:
    """Return the readings that no verdict drops."""
    judging = [verdict for verdict in verdicts if verdict.name not in case.of.known.without]
    kept = []
    for reading in readings:
        verdict = next((one for one in judging if one.drops(case, reading, beside)), None)
        if verdict is None:
            kept.append(reading)
        elif trace is not None:
            trace.add(verdict.name, str(reading), "", f"dropped. {verdict.reason}", reading.verb_positions)
    return tuple(kept)


def plausible_readings(case: ClauseCase, trace: Optional[Trace] = None) -> Tuple[Reading, ...]:
    """Return the readings of a clause, best first, without implausible ones."""
    found = match_units(case.sentence, case.clause, case.matches, case.of.known, trace)
    different = without_duplicates(found)
    readings = tuple(_with_phrases_left_over(case.sentence, reading) for reading in different)
    if trace is not None:
        for reading in found:
            if not any(reading is other for other in different):
                reason = "dropped. Another unit says the same."
                trace.add("same_meaning", str(reading), "", reason, reading.verb_positions)
        for before, after in zip(different, readings):
            if before != after:
                words = sorted(set(after.left_over) - set(before.left_over))
                trace.add("phrases_left_over", str(after), "", f"left over: {case.sentence.text(words)}", words)
    if case.of.policy.left_over_words in CAREFUL:
        readings = tuple(_with_what_is_heeded(case, reading, trace) for reading in readings)
    plausible = _drop(PLAUSIBILITY, case, readings, readings, trace)
    listed = frozenset().union(*(reading.listed for reading in plausible))
    text = _clause_text(case.sentence.tree, case.clause)
    kept = _drop(DOMINATED, case, plausible, plausible, trace)
    said = ((reading, text + stated(reading.arguments)) for reading in kept)
    judged = (
        _with_extras(case, replace(reading, unlikely=_unlikely(case, reading, listed), clause_text=words), trace)
        for reading, words in said
    )
    return tuple(sorted(judged, key=rank))


def meant_readings(case: ClauseCase) -> Tuple[Reading, ...]:
    """Return the readings of a clause that may be meant, whatever its mood, best first."""
    kept = plausible_readings(case)
    for verdict in COMPARING:
        kept = _drop([verdict], case, kept, kept, None)
    return kept


def _with_what_is_heeded(case: ClauseCase, reading: Reading, trace: Optional[Trace]) -> Reading:
    """Leave over what reaches no server, so that it is asked about and not dropped."""
    name = reading.unit.frame_name
    kept, words = without_unheeded(case.sentence, reading, case.of.known.frames[name], case.of.known.heeded.get(name))
    if words and trace is not None:
        trace.add("unheeded", str(kept), "", f"left over: {case.sentence.text(words)}", words)
    return kept


def _with_extras(case: ClauseCase, reading: Reading, trace: Optional[Trace]) -> Reading:
    """Name the extra-thematic phrases among the left-over words; those that a server heeds become arguments."""
    name = reading.unit.frame_name
    heeded = case.of.known.heeded.get(name)
    how_often: FrozenSet[int] = frozenset()
    is_careful = case.of.policy.left_over_words in CAREFUL
    if is_careful and ITERATION not in (heeded or ()):
        reading, how_often = with_times(case.sentence, case.clause, reading, case.of.known.frames[name])
    found = replace(reading, extra=extra_arguments(case.sentence, case.clause, reading.left_over))
    if found.extra and heeded is not None:
        found = _with_heeded(case, found, heeded, trace)
    how_long: FrozenSet[int] = frozenset()
    if is_careful:
        frame = case.of.known.frames[name]
        found, how_long = with_duration(case.sentence, case.clause, found, frame)
        found = kept_up(case.sentence, case.clause, found, frame)
    words = sorted(how_often | how_long)
    if not words:
        return found
    if trace is not None:
        trace.add("control", str(found), "", f"how often or how long: {case.sentence.text(words)}", words)
    around = replace(case.clause, positions=case.clause.positions.difference(words))
    positions = found.control.positions.union(words)
    control = replace(found.control, phrase=case.sentence.text(words), positions=positions)
    text = _clause_text(case.sentence.tree, around) + stated(found.arguments)
    return replace(found, control=control, clause_text=text)


def _with_heeded(case: ClauseCase, found: Reading, heeded: FrameHeeding, trace: Optional[Trace]) -> Reading:
    """Give a reading the extra-thematic phrases that a server heeds."""
    heard = with_heeded_extras(case.sentence, found, heeded)
    if heard is not found and trace is not None:
        words = sorted(set(found.left_over) - set(heard.left_over))
        trace.add("heeded", str(heard), "", f"a server heeds: {case.sentence.text(words)}", words)
    return heard


def _clause_text(tree: DependencyTree, clause: Clause) -> str:
    """Return the words of a clause, without conjunctions and formulas around it."""
    around = tree.abandoned | tree.fillers
    said = [
        index
        for index in sorted(clause.positions)
        if index in tree.quoted or not (index in around or _is_around(tree.word(index), clause))
    ]
    while said and said[0] != clause.verb and tree.word(said[0]).said in _SAID_AROUND | _JOINING:
        del said[0]
    written = [as_written(tree, tree.word(index)) for index in said]
    # The person sees what a typo was taken for.
    typos = f" (said: {', '.join(filter(None, written))})" if any(written) else ""
    return tree.text_of(said) + typos


def _is_around(word: Word, clause: Clause) -> bool:
    """Whether a word stands around what a clause says; "and" between two things does not."""
    return word.deprel in ("punct", "discourse", "vocative") or (word.deprel == "cc" and word.head == clause.verb)


def _unlikely(case: ClauseCase, reading: Reading, listed: FrozenSet[int]) -> int:
    """Count the words that are unlikely to be meant for the element that they fill.

    A word that another unit lists is rarely a thing: a person who asks for a high five does not want an object. "A
    kitchen" and "Anna" are rarely names of places, unlike "the kitchen": they say what kind of place, or who, it is.
    """
    frame = case.of.known.frames[reading.unit.frame_name]
    names = frozenset(element.name for element in frame.frame_elements if element.framenet == NAME)
    is_doubtful = reading.doubtful_types > 0
    return sum(
        value.head_position in listed - reading.listed
        or (value.name in names and (is_doubtful or is_indefinite(case.sentence.tree, value.head_position)))
        for value in reading.arguments
        if value.head_position
    )


def _with_phrases_left_over(sentence: Sentence, reading: Reading) -> Reading:
    """Mark phrases below a listed word as left over if only the word is the argument: "take a left *at the door*"."""
    left_over = set(reading.left_over)
    for value in reading.arguments:
        relation = next((relation for relation in reading.unit.relations if relation.name == value.name), None)
        if relation is None or not relation.words or relation.argument is not ArgumentForm.HEAD:
            continue
        is_side = value.head.lower() in _LEFT_AND_RIGHT
        whole = sentence.subtree(value.head_position)
        phrases = [
            sentence.subtree(child.index)
            for child in sentence.children(value.head_position)
            if child.deprel.split(":")[0] in (_PHRASES | _CHOOSING if is_side else _PHRASES)
            and child.deprel != "nmod:poss"
        ]
        behind = frozenset(position for position in value.positions if position > max(whole))
        elsewhere = frozenset(
            position for other in reading.arguments if other is not value for position in other.positions
        )
        said = frozenset(value.positions) & behind.union(*phrases)
        left_over |= {index for index in said - elsewhere if sentence.is_content(index)}
    return reading if left_over == set(reading.left_over) else replace(reading, left_over=tuple(sorted(left_over)))
