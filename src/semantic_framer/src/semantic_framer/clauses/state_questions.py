"""Reads questions about states: the unit that asks for an element of a frame of state evokes the question."""

from typing import FrozenSet, Optional, Tuple

from semantic_framer.clauses.state_clauses import state_clause
from semantic_framer.clauses.state_phrases import StateClause
from semantic_framer.judging.verdicts import Case
from semantic_framer.kinds.clause_features import ClauseFeatures, Form
from semantic_framer.kinds.question_extent import words_of_question
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.word_patterns import whole_reading
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.lexical_unit import LexicalUnit

_ALTERNATIVE, _LOCATION = "alternative", "location"


def state_question(case: Case, features: ClauseFeatures) -> Tuple[Reading, ...]:
    """Return the reading of a clause that asks how things are; none for other clauses.

    Args:
        case: the sentence
        features: of the clause
    """
    # "Who is not in the kitchen" asks for all others.
    if features.form is Form.PLAIN or features.is_negated:
        return ()
    words = frozenset(word.index for word in words_of_question(case.sentence))
    found = asked_frame(case.sentence, case.known, features, words)
    return (found,) if found is not None else ()


def asked_frame(
    sentence: Sentence,
    known: FramedLexicon,
    features: ClauseFeatures,
    words: FrozenSet[int],
    *,
    needs_server: bool = True,
) -> Optional[Reading]:
    """Return the reading of the question that a clause asks about a state; None for other clauses.

    Args:
        sentence: the sentence
        known: lexical units and frames
        features: of the clause
        words: positions of the words that count
        needs_server: whether a server must answer it; what somebody is told, the server of telling finds out
    """
    clause = state_clause(sentence, features, words)
    unit = _unit(known, clause, needs_server) if clause is not None else None
    return _reading(sentence, known, unit, clause) if clause is not None and unit is not None else None


def _unit(known: FramedLexicon, clause: StateClause, needs_server: bool) -> Optional[LexicalUnit]:
    for unit in known.lexicon.asking_units(f"{clause.frame}.{clause.asked}"):
        frame = known.frames.get(unit.frame_name)
        if frame is None or not frame.is_question:
            continue
        if needs_server and known.heeded and frame.name not in known.heeded:
            continue
        is_joined = frame.element(_ALTERNATIVE) is None and _LOCATION in clause.elements
        if all(frame.element(name) or (name == _ALTERNATIVE and is_joined) for name in clause.elements):
            return unit
    return None


def _reading(sentence: Sentence, known: FramedLexicon, unit: LexicalUnit, clause: StateClause) -> Reading:
    frame = known.frames[unit.frame_name]
    elements = dict(clause.elements)
    if frame.element(_ALTERNATIVE) is None and _ALTERNATIVE in elements:
        # "Who is in the hall or in the kitchen" names one place or the other.
        first, last = elements[_LOCATION], elements.pop(_ALTERNATIVE)
        elements[_LOCATION] = tuple(range(min(first), max(last) + 1))
    return whole_reading(sentence, frame, unit, f"{clause.frame}.{clause.asked}", elements)
