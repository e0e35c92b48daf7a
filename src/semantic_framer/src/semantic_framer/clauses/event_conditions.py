"""Reads a condition about a deed by the units of its verb: "you have closed the door", "Anna closes the door".

What the robot does is known from its log. What others do is known by what it results in, if the frame says so.
"""

from dataclasses import replace
from typing import FrozenSet, NamedTuple, Optional

from semantic_framer.clauses.deed_clauses import AGENT, DeedClause, of_own_deed, with_going
from semantic_framer.filling.matching import match_units
from semantic_framer.judging.verdicts import Case
from semantic_framer.kinds.clause_features import Aspect, ClauseFeatures, Form
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import PRONOUNS
from semantic_framer.values.outcome import Policy
from semantic_framer.values.reading import Reading, rank
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import Result
from typed_arguments import Source, TypedArgument
from utterance_passes.phrases.clauses import clause_of
from utterance_passes.phrases.verb_matching import match_verbs
from word_classes import word_class

#: The frame that says that the robot did something.
CONDITION_OF_DEED = "condition_of_deed"
#: The frame that says that somebody else does something.
CONDITION_OF_ACT = "condition_of_act"
_AFTER = "after"
#: What somebody can perceive, they perceive.
_MODALS = frozenset(["", "can", "ca", "could"])
_WAITING = "Waiting"
_PERSONS = word_class("male_pronouns") | word_class("female_pronouns")
_HEARERS = word_class("hearers")
#: FrameNet's roles of who does something on purpose; what the robot does itself is known from its log.
_DOERS = frozenset(["Agent", "Speaker"])
_DONE = (Aspect.DONE, Aspect.EVER_DONE)


def unit_condition(
    sentence: Sentence, known: FramedLexicon, features: ClauseFeatures, words: FrozenSet[int]
) -> Optional[Reading]:
    """Read some words by the units of what happens: "Anna comes in", "the door opens"; None if none fits.

    Args: as of :func:`state_condition`
    """
    top = sentence.word(features.top)
    if top.upos not in ("VERB", "AUX", "NOUN") or (top.xpos == "VBG" and not features.agent):
        return None  # "After reaching the hall" is a deed of the robot.
    if features.modal not in _MODALS:
        return None  # "If Anna should come."
    events = replace(known, lexicon=known.lexicon.events)
    clause = clause_of(sentence.tree, features.top, words, False)
    found = [
        reading
        for reading in match_units(sentence, clause, match_verbs(sentence.tree, clause, events), events)
        if not (reading.left_over or reading.wrong_types or reading.missing)
        if _has_subject(sentence, features, reading) and not _is_done_by_robot(sentence, known, reading)
    ]
    if not found:
        return None
    # "Stands in your way" is more than standing, and "it gets dark" says nothing of a thing.
    best = min(found, key=lambda reading: (-len(reading.verb.split()), not reading.unit.subjects, rank(reading)))
    # "The door opens" says how it is then.
    arguments = tuple(
        replace(argument, source=Source.INFERRED) if argument.name in best.unit.values else argument
        for argument in best.arguments
    )
    return replace(best, arguments=arguments)


def _has_subject(sentence: Sentence, features: ClauseFeatures, reading: Reading) -> bool:
    """Whether the subject fills an element, or is what the unit says: "it" in "it rains"."""
    subject = features.agent
    if not subject or any(subject in argument.positions for argument in reading.arguments):
        return True
    words = sorted(sentence.subtree(subject))
    return sentence.text(words).lower() in reading.unit.subjects


def _is_done_by_robot(sentence: Sentence, known: FramedLexicon, reading: Reading) -> bool:
    frame = known.frames[reading.unit.frame_name]
    return any(
        argument.head_position and sentence.word(argument.head_position).said in _HEARERS
        for argument in reading.arguments
        for element in [frame.element(argument.name)]
        if element is not None and element.framenet in _DOERS
    )


class EventCondition(NamedTuple):
    """A condition about a deed, and whether the opposite is meant."""

    reading: Reading
    is_negated: bool


def event_condition(
    sentence: Sentence,
    known: FramedLexicon,
    features: ClauseFeatures,
    words: FrozenSet[int],
    *,
    is_of_the_past: bool = False,
) -> Optional[EventCondition]:
    """Read some words as a condition about a deed; None if they are about none that anybody can notice.

    Args:
        sentence: the sentence
        known: lexical units and frames
        features: of the clause
        words: positions of all of its words
        is_of_the_past: whether only the log of the robot is asked, which knows its waits, too; "until you have waited"
            is a time
    """
    sentence, features = with_going(sentence, features)
    top = features.top
    if sentence.word(top).upos != "VERB":
        return None
    features = of_own_deed(sentence, features, known)
    if any(child.deprel == "cop" for child in sentence.children(top)) and not features.is_passive:
        return None
    if features.form is not Form.PLAIN or features.modal or not (features.agent or features.is_passive):
        return None
    clause = DeedClause(Case(sentence, (), (), known, Policy()), top, features, words)
    if (clause.is_of_robot and features.aspect not in _DONE) or (is_of_the_past and not clause.is_of_robot):
        return None
    deed = clause.deed()
    if deed is None or deed.missing or clause.said_when or not words <= _words_read(sentence, clause, deed):
        return None
    if clause.is_of_robot:
        if any(child.said == _AFTER for child in sentence.children(top)):
            return None  # "After you have closed the door, go": it shall close it first.
        return _of_robot(known, clause, deed, is_of_the_past)
    result = known.frames[deed.unit.frame_name].results_in
    reading = None
    if result is not None and features.aspect in (Aspect.PRESENT, *_DONE) and result.frame in known.frames:
        reading = _of_result(clause, deed, result)
    reading = reading or _of_act(known, clause, deed)
    return EventCondition(reading, features.is_negated) if reading is not None else None


def passive_condition(
    sentence: Sentence, known: FramedLexicon, features: ClauseFeatures, words: FrozenSet[int]
) -> Optional[Reading]:
    """Read "the dishes are washed" as what somebody did, if the verb of a unit is said; None for other clauses.

    Args: as of :func:`event_condition`
    """
    event = event_condition(sentence, known, features, words) if features.is_passive else None
    return event.reading if event is not None else None


def _words_read(sentence: Sentence, clause: DeedClause, deed: Reading) -> FrozenSet[int]:
    """Return the words that the deed accounts for, with its agent and its auxiliaries."""
    top = clause.features.top
    marks = (word.index for word in sentence.tree.words if word.upos in ("PUNCT", "CCONJ", "DET", "ADP", "ADV", "PART"))
    agent = sentence.subtree(clause.features.agent) if clause.features.agent else frozenset()
    arguments = frozenset(index for argument in deed.arguments for index in argument.positions)
    return frozenset([top]).union(clause.features.auxiliaries, agent, arguments, deed.verb_positions, marks)


def _of_robot(
    known: FramedLexicon, clause: DeedClause, deed: Reading, is_of_the_past: bool
) -> Optional[EventCondition]:
    is_wait = known.frames[deed.unit.frame_name].framenet == _WAITING and not is_of_the_past
    if CONDITION_OF_DEED not in known.frames or is_wait or _is_open(deed):
        return None
    reading = _reading(deed, CONDITION_OF_DEED, clause.argument(deed, "statement"))
    return EventCondition(reading, clause.features.is_negated)


def _is_open(deed: Reading) -> bool:
    """Whether a pronoun leaves open what is meant."""
    return any(argument.text.lower() in PRONOUNS | _PERSONS for argument in deed.arguments)


def _of_act(known: FramedLexicon, clause: DeedClause, deed: Reading) -> Optional[Reading]:
    """Return the reading of a deed that results in nothing: a server may watch it, or nobody does."""
    if CONDITION_OF_ACT not in known.frames or _is_open(deed):
        return None
    return _reading(deed, CONDITION_OF_ACT, clause.argument(deed, "statement"), clause.agent())


def _of_result(clause: DeedClause, deed: Reading, result: Result) -> Optional[Reading]:
    """Return the reading of what a deed results in; None if it lacks what that is said of, or says more.

    "Agent" stands for whoever does it: who goes somewhere is there. Who has taken the mug from the table has the mug,
    but who has the mug did not always take it from there.
    """
    told = {value for _, value in result.elements}
    if AGENT in told and clause.features.is_passive and not clause.features.agent:
        return None  # Nobody is said who could have it then.
    if any(argument.source is Source.SAID and argument.name not in told | {AGENT} for argument in deed.arguments):
        return None
    arguments = []
    for name, value in result.elements:
        found = clause.agent() if value == AGENT else deed.argument(value)
        if found is None and value in result.own_elements:
            return None
        arguments.append(
            replace(found, name=name) if found is not None else TypedArgument(name, value, Source.INFERRED)
        )
    return _reading(deed, result.frame, *arguments)


def _reading(deed: Reading, frame_name: str, *arguments: TypedArgument) -> Reading:
    unit = replace(deed.unit, frame_name=frame_name)
    return replace(deed, unit=unit, arguments=arguments, missing=(), left_over=(), extra=None)
