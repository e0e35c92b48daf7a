"""Reads a condition about a deed by the units of its verb: "you have closed the door", "Anna closes the door".

What the robot does is known from its log. What others do is known by what it results in, if the frame says so.
"""

from dataclasses import replace
from typing import FrozenSet, NamedTuple, Optional, Sequence

from semantic_framer.clauses.deed_clauses import DeedClause
from semantic_framer.judging.verdicts import Case
from semantic_framer.kinds.clause_features import Aspect, Form, features_of
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import PRONOUNS
from semantic_framer.values.outcome import Policy
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import Result
from typed_arguments import Source, TypedArgument

#: The frame that says that the robot did something.
CONDITION_OF_DEED = "condition_of_deed"
_DONE = (Aspect.DONE, Aspect.EVER_DONE)


class EventCondition(NamedTuple):
    """A condition about a deed, and whether the opposite is meant."""

    reading: Reading
    is_negated: bool


def event_condition(sentence: Sentence, known: FramedLexicon, positions: Sequence[int]) -> Optional[EventCondition]:
    """Read some words as a condition about a deed; None if they are about none that anybody can notice.

    Args:
        sentence: the sentence
        known: lexical units and frames
        positions: of the words, in order
    """
    words = frozenset(positions)
    tops = [index for index in positions if sentence.word(index).head not in words]
    tops = [index for index in tops if sentence.word(index).upos == "VERB"]
    if len(tops) != 1 or any(child.deprel == "cop" for child in sentence.children(tops[0])):
        return None
    features = features_of(sentence.tree, tops[0])
    if features.form is not Form.PLAIN or features.modal or not (features.agent or features.is_passive):
        return None
    clause = DeedClause(Case(sentence, (), (), known, Policy()), tops[0], features, words)
    deed = clause.deed()
    if deed is None or deed.missing or clause.said_when or not words <= _words_read(sentence, clause, deed):
        return None
    if clause.is_of_robot:
        return _of_robot(known, clause, deed) if features.aspect in _DONE else None
    result = known.frames[deed.unit.frame_name].results_in
    if result is None or features.aspect not in (Aspect.PRESENT, *_DONE) or result.frame not in known.frames:
        return None
    reading = _of_result(deed, result)
    return EventCondition(reading, features.is_negated) if reading is not None else None


def _words_read(sentence: Sentence, clause: DeedClause, deed: Reading) -> FrozenSet[int]:
    """Return the words that the deed accounts for, with its agent and its auxiliaries."""
    top = clause.features.top
    marks = (word.index for word in sentence.tree.words if word.upos in ("PUNCT", "CCONJ", "DET", "ADP", "ADV", "PART"))
    agent = sentence.subtree(clause.features.agent) if clause.features.agent else frozenset()
    arguments = frozenset(index for argument in deed.arguments for index in argument.positions)
    return frozenset([top]).union(clause.features.auxiliaries, agent, arguments, deed.verb_positions, marks)


def _of_robot(known: FramedLexicon, clause: DeedClause, deed: Reading) -> Optional[EventCondition]:
    is_open = any(argument.text.lower() in PRONOUNS for argument in deed.arguments)
    if CONDITION_OF_DEED not in known.frames or is_open:
        return None
    reading = _reading(deed, CONDITION_OF_DEED, clause.argument(deed, "statement"))
    return EventCondition(reading, clause.features.is_negated)


def _of_result(deed: Reading, result: Result) -> Optional[Reading]:
    """Return the reading of what a deed results in; None if it lacks what that is said of."""
    arguments = []
    for name, value in result.elements:
        found = deed.argument(value)
        if found is None and value in result.own_elements:
            return None
        arguments.append(
            replace(found, name=name) if found is not None else TypedArgument(name, value, Source.INFERRED)
        )
    return _reading(deed, result.frame, *arguments)


def _reading(deed: Reading, frame_name: str, *arguments: TypedArgument) -> Reading:
    unit = replace(deed.unit, frame_name=frame_name)
    return replace(deed, unit=unit, arguments=arguments, missing=(), left_over=(), extra=None)
