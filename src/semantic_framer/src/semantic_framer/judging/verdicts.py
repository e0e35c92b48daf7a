"""Verdicts that refuse a clause or drop readings: each has a name and a reason, and they run in a fixed order."""

from dataclasses import dataclass
from typing import Callable, Optional, Tuple

from roboframenet_ros.spoken_text import join_with_or
from semantic_framer.judging import plausibility
from semantic_framer.judging.plausibility import Filled
from semantic_framer.kinds.mood_file import UtteranceKind
from semantic_framer.kinds.utterance_kind import RENEWING, KindVerdict, kinds_of_clauses
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.outcome import (
    REPORT,
    LeftOverWords,
    Policy,
    Refusal,
    asks_for_nothing,
    left_over_refusal,
    not_then,
    not_to_be_done,
)
from semantic_framer.values.reading import Reading, rank
from semantic_framer.values.sentence import Sentence
from semantic_types.parts_of_speech import VERB, parts_of_speech
from typed_arguments import TypedArgument
from utterance_passes.phrases.clauses import Clause, shared_subject
from utterance_passes.phrases.measures import amounts_of
from utterance_passes.phrases.verb_matching import VerbMatch
from utterance_passes.trees.inner_conditions import inner_condition
from word_classes import word_class

_CONDITIONS = word_class("conditions")
_PERSONS_OR_THINGS = word_class("pronouns_of_persons_or_things")


@dataclass(frozen=True)
class Case:
    """A sentence to be judged.

    Attributes:
        sentence: the sentence
        clauses: all of its clauses
        kinds: the kind of each clause
        known: lexical units and frames
        policy: how careful to be
    """

    sentence: Sentence
    clauses: Tuple[Clause, ...]
    kinds: Tuple[KindVerdict, ...]
    known: FramedLexicon
    policy: Policy

    @property
    def acts(self) -> bool:
        """Whether any clause asks the robot to do something."""
        return any(kind.acts for kind in self.kinds)

    def kind_of(self, clause: Clause) -> KindVerdict:
        """Return the kind of a clause."""
        return self.kinds[self.clauses.index(clause)]

    def text_of(self, clause: Clause) -> str:
        """Return the words of a clause."""
        words = sorted(clause.positions)
        return self.sentence.text([index for index in words if self.sentence.word(index).upos != "PUNCT"])

    def is_background(self, clause: Clause) -> bool:
        """Whether a clause gives the reason for a command: "*I'm thirsty*, bring me water".

        Such a clause has its own subject and verb, and comes before another clause or after a mark or a conjunction.
        "The door *we just left*" does not: it says which door is meant.
        """
        tree = self.sentence.tree
        if not self.acts or not self.kind_of(clause).is_background:
            return False
        first = self.sentence.word(min(clause.positions))
        # "When I come home turn on the light", "in case it rains close the window": it is a condition.
        is_phrase = first.deprel == "mark" and any(child.deprel == "fixed" for child in tree.children(first.index))
        if is_phrase or first.said in _CONDITIONS:
            return False
        # An amount in such a clause may belong to the command: "turn left, anything but one point six radians".
        if any(amount.unit or amount.is_doubtful for amount in amounts_of(tree, clause.positions, clause.verb)):
            return False
        if clause.verb < max(other.verb for other in self.clauses):
            return True
        before = self.sentence.word(first.index - 1) if first.index > 1 else first
        is_joined = bool({before.deprel, first.deprel} & {"punct", "cc", "mark"})
        return is_joined or first.said in RENEWING or self.kind_of(clause).is_remark


def case_of(sentence: Sentence, clauses: Tuple[Clause, ...], known: FramedLexicon, policy: Policy) -> Case:
    """Decide the kind of each clause, before any unit is tried."""
    return Case(sentence, clauses, kinds_of_clauses(sentence.tree, clauses, known), known, policy)


@dataclass(frozen=True)
class ClauseCase:
    """A clause to be judged.

    Attributes:
        of: the sentence with the clause
        clause: the clause
        matches: verbs of the lexicon that the clause uses
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
        return self.of.text_of(self.clause)

    @property
    def kind(self) -> KindVerdict:
        """The kind of the clause."""
        return self.of.kind_of(self.clause)


@dataclass(frozen=True)
class ClauseVerdict:
    """Refuses a clause, independently of its readings."""

    name: str
    reason: str
    refuse: Callable[[ClauseCase], Optional[Refusal]]


#: Decides whether to drop a reading, given the other readings.
Drops = Callable[[ClauseCase, Reading, Tuple[Reading, ...]], bool]


@dataclass(frozen=True)
class ReadingVerdict:
    """Drops readings of a clause.

    Attributes:
        name: the name in the trace
        reason: why such a reading cannot be meant
        drops: decides whether to drop a reading
        refuse: returns the refusal if no reading is left; None leaves the refusal to the next verdict
    """

    name: str
    reason: str
    drops: Drops
    refuse: Callable[[ClauseCase], Optional[Refusal]] = lambda case: None


# --- clauses


def _negated(case: ClauseCase) -> Optional[Refusal]:
    if not case.clause.is_negated and case.kind.kind is not UtteranceKind.PROHIBITION:
        return None
    if case.kind.kind is UtteranceKind.REPORT and any(kind.acts for kind in case.of.kinds):
        return left_over_refusal(case.sentence, sorted(case.clause.positions))
    return not_to_be_done(case.sentence, case.clause, case.said)


def _condition_without_verb(case: ClauseCase) -> Optional[Refusal]:
    if case.matches or not case.clause.condition:
        return None
    return not_then(case.sentence, case.clause.condition_positions)


def _is_of_somebody_else(case: ClauseCase) -> bool:
    """Whether a clause has a described subject, and so is no command to a robot of that name: "the baby is crying"."""
    subject = case.clause.subject
    return any(child.deprel in ("det", "nmod:poss") for child in case.sentence.children(subject)) if subject else False


def _unknown_verb(case: ClauseCase) -> Optional[Refusal]:
    if case.matches:
        return None
    if case.kind.kind is UtteranceKind.REPORT and _is_of_somebody_else(case):
        return asks_for_nothing(REPORT, case.kind.reason, case.said)
    # A verb of English is no typo of another one.
    is_verb = VERB in parts_of_speech(case.clause.lemma)
    near = () if is_verb else case.of.known.lexicon.nearest_verbs(case.clause.lemma)
    quoted = [f'"{verb}"' for verb in near]
    hint = f" Do you mean {join_with_or(quoted)}?" if near else ""
    return Refusal("UNKNOWN_VERB", f'I do not know how to "{case.clause.lemma}".{hint}')


CLAUSE_VERDICTS: Tuple[ClauseVerdict, ...] = (
    ClauseVerdict("negated", "It is not to be done.", _negated),
    ClauseVerdict("condition_without_verb", "It depends on something, and no verb is known.", _condition_without_verb),
    ClauseVerdict("unknown_verb", "No lexical unit has its verb.", _unknown_verb),
)


# --- implausible readings


def _of_any_value(judge: Callable[[Filled], bool], *, also_of_listed_type: bool = False) -> Drops:
    """Judge a reading by each of its values, except words that its unit lists ("give me 5").

    Args:
        judge: whether a value speaks against its reading
        also_of_listed_type: whether it judges words of which the unit lists only the type, too
    """

    def is_listed(reading: Reading, value: TypedArgument) -> bool:
        if value.head_position not in reading.listed:
            return False
        named = (relation.name for relation in reading.unit.relations if relation.words)
        return not also_of_listed_type or value.name in named

    def drops(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
        frames = case.of.known.frames
        return any(
            judge(Filled(value, reading, beside, frames[reading.unit.frame_name], case.sentence.tree))
            for value in reading.arguments
            if value.head_position and not is_listed(reading, value)
        )

    return drops


#: Each verdict compares a reading with all readings of the clause.
PLAUSIBILITY: Tuple[ReadingVerdict, ...] = (
    ReadingVerdict(
        "noun_of_another_verb",
        'A noun fills an element though it is part of the verb of another unit: "take a look".',
        _of_any_value(plausibility.is_noun_of_a_verb, also_of_listed_type=True),
    ),
    ReadingVerdict(
        "measured_elsewhere",
        'A number fills an element though another unit measures with it: "turn one eighty".',
        _of_any_value(plausibility.is_measure_elsewhere),
    ),
    ReadingVerdict(
        "miscounted",
        'A number counts a singular noun though another unit asks for an amount: "turn right 90 image".',
        lambda case, reading, beside: plausibility.is_miscounted(reading, beside, case.sentence.tree),
    ),
    ReadingVerdict(
        "joined_to_a_listed_word",
        'A listed word is joined to one that is not listed: "to your right, photos at the door".',
        lambda case, reading, beside: plausibility.joins_unlisted_word(reading, case.sentence.tree),
    ),
    ReadingVerdict(
        "unread_elsewhere",
        'An amount that another unit asks for, and must not be acted on, is taken for a thing: "two or three metres".',
        _of_any_value(plausibility.is_unread_elsewhere),
    ),
    ReadingVerdict(
        "asked_about_elsewhere",
        'A person is taken for a thing, and a reading that has a person there lacks an element: "take Anna".',
        _of_any_value(plausibility.is_asked_about_elsewhere),
    ),
    ReadingVerdict(
        "number_is_no_place",
        'A number is taken for the place of something: "set the thermostat to 20".',
        _of_any_value(plausibility.is_numbered_place),
    ),
    ReadingVerdict(
        "one_place",
        'One thing is put in two places: "put the cup on the table and the bowl".',
        _of_any_value(plausibility.is_one_of_two_places),
    ),
    ReadingVerdict(
        "two_phrases",
        'Two noun phrases fill one element with nothing between them: "go to room 3 polish the table".',
        _of_any_value(plausibility.is_two_phrases),
    ),
    ReadingVerdict(
        "subject_of_a_question",
        'The subject of an indirect question is taken for what is looked at: "find out where my keys are".',
        _of_any_value(plausibility.is_subject_of_a_question),
    ),
    ReadingVerdict(
        "way_is_no_place", 'A way to do it is taken for a place: "go in circles".', _of_any_value(plausibility.is_way)
    ),
    ReadingVerdict(
        "wisher_is_not_sought",
        'A person for whom it is done is taken for what is sought or said: "check the door for me".',
        _of_any_value(plausibility.is_wisher),
    ),
    ReadingVerdict(
        "degree_is_no_thing", 'A degree is taken for a thing: "move a bit".', _of_any_value(plausibility.is_degree)
    ),
    ReadingVerdict("side_is_no_thing", 'A side is taken for a thing: "a right".', _of_any_value(plausibility.is_side)),
    ReadingVerdict(
        "side_of_the_place_before",
        'A side behind a place is taken for another place to go to: "through the door on the left".',
        _of_any_value(plausibility.is_side_of_the_place_before),
    ),
    ReadingVerdict(
        "deed_is_no_thing",
        'A deed, an event or a way is taken for a thing: "take a nap", "take the lift".',
        _of_any_value(plausibility.is_deed),
    ),
    ReadingVerdict(
        "listed_elsewhere",
        'An indefinite noun is taken for a thing though another unit lists it: "take a photo northwards".',
        _of_any_value(plausibility.is_listed_elsewhere),
    ),
)


def _says_less(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    return any(
        reading.unit.frame_name == other.unit.frame_name
        and reading.said < other.said
        and frozenset(other.left_over) <= frozenset(reading.left_over)
        for other in beside
    )


#: Each verdict compares a reading with the plausible readings.
DOMINATED: Tuple[ReadingVerdict, ...] = (
    ReadingVerdict(
        "says_less",
        'Another reading of the same frame says all that it does and more: "turn off the light", not "turn the light".',
        _says_less,
    ),
)


# --- readings that were not asked for, or that are worse than another reading


def _is_no_fact(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    """ "The mug stands on the table": a unit describes a state only if it is about the subject."""
    return case.kind.is_fact and case.clause.lemma != "be" and not _is_about_its_subject(case, reading)


def _is_about_its_performer(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    """ "Could you stand next to the desk": the subject is to act; it is not the thing that a unit is about."""
    return (
        case.kind.acts
        and _is_about_its_subject(case, reading)
        and not all(_is_about_its_subject(case, other) for other in beside)
    )


def _is_about_its_subject(case: ClauseCase, reading: Reading) -> bool:
    subject = case.clause.subject or shared_subject(case.sentence.tree, case.clause.verb)
    elements = case.of.known.frames[reading.unit.frame_name].frame_elements
    core = {element.name for element in elements if element.is_core}
    required = {relation.name for relation in reading.unit.relations if relation.is_required}
    return bool(subject) and any(
        subject in value.positions and value.name in core | required for value in reading.arguments
    )


def _report(case: ClauseCase) -> Optional[Refusal]:
    return asks_for_nothing(case.kind.kind.name, case.kind.reason, case.said) if case.kind.is_fact else None


def _is_never_dropped(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    return False


def _nothing_fits(case: ClauseCase) -> Optional[Refusal]:
    known = case.of.known
    wanted = {unit.frame_name for match in case.matches for unit in known.units_of(match.verb)}
    if not wanted & set(known.frames):
        return Refusal("UNKNOWN_FRAME", f"No file describes the frame {' or '.join(sorted(wanted))}.")
    return Refusal("NO_READING", f'I know "{case.matches[0].verb}", but not used like this.')


def _depends_on_something(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    """ "Check if the oven is hot" has no condition: the words after "if" fill an element. "If" itself fills nothing."""
    positions = case.clause.condition_positions
    if not positions:
        return False
    conditional = {index for index in positions if case.sentence.word(index).deprel != "mark"}
    filled = {position for value in reading.arguments for position in value.positions}
    return not (conditional or set(positions)) <= filled or bool(
        inner_condition(case.sentence.tree, case.clause.condition_positions)
    )


def _condition(case: ClauseCase) -> Optional[Refusal]:
    return not_then(
        case.sentence,
        inner_condition(case.sentence.tree, case.clause.condition_positions) or case.clause.condition_positions,
    )


def _is_of_class(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    """Whether no programmer wrote the verb into a unit, and one wrote a unit that fits."""
    return _is_unwritten(reading) and any(not _is_unwritten(other) and not other.missing for other in beside)


def _is_unwritten(reading: Reading) -> bool:
    return reading.unit.is_learned or bool(reading.unit.stands_for(reading.verb))


def _is_incomplete(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    return bool(reading.missing) and any(not other.missing for other in beside)


def _is_less_likely_asked(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    """ "Move." leads to two questions, where to and how far: the answer shows which reading was meant."""
    return bool(reading.missing) and rank(reading).of_what_was_said != rank(beside[0]).of_what_was_said


def _is_of_another_type(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    return len(reading.wrong_types) > len(beside[0].wrong_types)


def _is_of_a_doubtful_type(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    # "Take them to the hall": what was said before decides whether they are carried or guided.
    is_open = any(value.text.lower() in _PERSONS_OR_THINGS for value in reading.arguments)
    return not reading.missing and not is_open and reading.doubtful_types > beside[0].doubtful_types


def _leaves_more_over(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    if reading.missing or case.of.policy.left_over_words is LeftOverWords.IGNORE:
        return False
    return len(reading.left_over) > len(beside[0].left_over)


def _lists_less(case: ClauseCase, reading: Reading, beside: Tuple[Reading, ...]) -> bool:
    if not reading.listed or reading.missing:
        return False
    named = reading.listed.union(reading.verb_positions)
    return any(reading.listed < one.listed or named < one.listed.union(one.verb_positions) for one in beside)


#: Which of several readings is meant, in any mood. The verdicts run one after the other; each compares a reading with
#: the remaining ones, likeliest first.
COMPARING: Tuple[ReadingVerdict, ...] = (
    ReadingVerdict(
        "verb_class",
        "Its verb comes from the lexicon or from a person, and a unit that lists the verb fits.",
        _is_of_class,
    ),
    ReadingVerdict("incomplete", "A core element is missing, and another reading has all.", _is_incomplete),
    ReadingVerdict(
        "less_likely_asked", "It is less likely than the reading that is asked about.", _is_less_likely_asked
    ),
    ReadingVerdict(
        "wrong_type",
        'Words have another semantic type than their element, and another reading has the right types: "take Anna".',
        _is_of_another_type,
    ),
    ReadingVerdict("leaves_more_over", "Another reading accounts for more words.", _leaves_more_over),
    ReadingVerdict(
        "doubtful_type",
        'A unit asks for a semantic type that the words hardly have, and another reading fits: "open the thing".',
        _is_of_a_doubtful_type,
    ),
    ReadingVerdict(
        "lists_less", 'A unit lists less than another one of what was said: "low five", "turn around".', _lists_less
    ),
)
#: Of a command: whether it is one for now, and then which reading is meant.
READING_VERDICTS: Tuple[ReadingVerdict, ...] = (
    ReadingVerdict("report", "It tells how something is, and the unit is not about its subject.", _is_no_fact, _report),
    ReadingVerdict("performer", "The unit is about who is to do something.", _is_about_its_performer),
    ReadingVerdict("nothing_fits", "No lexical unit of the verb fits.", _is_never_dropped, _nothing_fits),
    ReadingVerdict("condition", "It depends on something, or is to be done later.", _depends_on_something, _condition),
    *COMPARING,
)
