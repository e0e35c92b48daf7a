"""Settles the readings of a sentence: resolves pronouns, and refuses or asks if something is still open."""

from dataclasses import dataclass, replace
from typing import Dict, List, Optional, Sequence, Tuple, Union

from referring_expressions import unknown_of
from roboframenet_ros.spoken_text import join_with_and, join_with_or
from semantic_framer.asking.answers import question_of
from semantic_framer.asking.choices import question_of_choices
from semantic_framer.asking.wishes import without_granted_wishes
from semantic_framer.clauses.embedded_statements import with_statements
from semantic_framer.clauses.indirect_questions import with_indirect_questions
from semantic_framer.filling.default_values import may_say_direction
from semantic_framer.judging.said_twice import said_twice
from semantic_framer.referring.clause_before import resolve_in_parallel, with_thing_taken
from semantic_framer.referring.findings_told import with_finding
from semantic_framer.referring.persons_spoken_of import PERSON, whom_is_meant
from semantic_framer.referring.references import noun_phrase, remember, resolve, without_named_beside
from semantic_framer.referring.world_references import refer, spoken_of, unknown_arguments
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.type_fits import accepted_types
from semantic_framer.values.clause_plan import Clauses, PlanPart, in_order
from semantic_framer.values.dialogue import Context, Pending
from semantic_framer.values.outcome import (
    CAREFUL,
    DECLINED,
    Alternatives,
    LeftOverWords,
    Outcome,
    Policy,
    Question,
    Refusal,
    Understood,
    left_over_refusal,
)
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import UnknownPolicy
from semantic_frames.semantic_type import SEMANTIC_TYPES, with_parents
from typed_arguments import Source, TypedArgument
from utterance_passes.engine.trace import Trace
from utterance_passes.engine.utterance_pass import Choice
from word_classes import word_class

_HEARERS = word_class("hearers")
_PERSONS_OR_THINGS = word_class("pronouns_of_persons_or_things")
#: A person can keep so many types of things in mind.
_MOST_TYPES_NAMED = 3


@dataclass(frozen=True)
class Now:
    """The circumstances of an utterance.

    Attributes:
        known: lexical units and frames
        policy: how careful the framer is
        time_s: time on the caller's clock, seconds; it decides when questions expire
        trace: receives a line for each change; None for no trace
        may_teach: whether who speaks may teach the robot words
    """

    known: FramedLexicon
    policy: Policy
    time_s: float
    trace: Optional[Trace] = None
    may_teach: bool = True

    def write(self, rule: str, about: str, after: str) -> None:
        """Write a line of the trace."""
        if self.trace is not None:
            self.trace.add(rule, about, after=after)

    @property
    def expires_s(self) -> float:
        """The time at which a question that is asked now expires, seconds."""
        return self.time_s + self.policy.question_timeout_s


def ask_which(choices: Tuple[Choice, ...], context: Context, now: Now) -> Tuple[Union[Refusal, Question], Context]:
    """Let a person choose between readings; without readings, refuse because the person took everything back."""
    if not choices:
        return Refusal(DECLINED, "You took that back, so I do nothing."), context
    pending = Pending(clauses=(), clause=0, elements=(), expires_s=now.expires_s, readings=choices)
    return Question("AMBIGUOUS", question_of_choices(choices)), replace(context, pending=pending)


def resolve_and_confirm(
    clauses: Clauses,
    sentence: Sentence,
    context: Context,
    now: Now,
    *,
    is_confirmed: bool = False,
    plan: Optional[PlanPart] = None,
) -> Tuple[Outcome, Context]:
    """Resolve pronouns, then refuse or ask if something is open.

    Args:
        clauses: the readings of each clause, best first
        sentence: the sentence, for its left-over words
        context: what the framer remembers of earlier utterances
        now: the circumstances of the utterance
        is_confirmed: whether a person has said yes to the readings
        plan: how the clauses are joined; None if they are done one after the other
    """
    outcome, after = _settled(clauses, sentence, context, now, is_confirmed, plan)
    if plan is None:
        return outcome, after
    if isinstance(outcome, Understood):
        clauses, plan = in_order(outcome.clauses, plan)
        return replace(outcome, clauses=clauses, plan=plan), after
    if after.pending is not None:
        after = replace(after, pending=replace(after.pending, plan=plan))
    return outcome, after


def _settled(
    clauses: Clauses,
    sentence: Sentence,
    context: Context,
    now: Now,
    is_confirmed: bool,
    plan: Optional[PlanPart],
) -> Tuple[Outcome, Context]:
    policy = now.policy
    # Judge the left-over words before asking anything: their positions belong to this sentence only.
    if policy.left_over_words in CAREFUL:
        for readings in clauses:
            is_asked = policy.left_over_words is LeftOverWords.ASK and readings[0].extra is not None
            is_asked = is_asked and not may_say_direction(sentence, readings[0], now.known.frames)
            if readings[0].left_over and not is_asked:
                words = sentence.text(readings[0].left_over)
                now.write("left_over_words", words, "refused. No element has these words.")
                return left_over_refusal(sentence, readings[0].left_over, readings[0].unheeded), context
        twice = "" if is_confirmed else said_twice([readings[0] for readings in clauses])
        if twice:
            now.write("said_twice", twice, "asked. Nothing stands between both.")
            pending = Pending(without_positions(clauses), 0, (), now.expires_s, plan=plan)
            text = f'I heard "{twice}" twice. Shall I do it twice? Say yes or no.'
            return Question("CONFIRM", text), replace(context, pending=pending)
        extra = [argument for readings in clauses for argument in readings[0].extra or ()]
        if extra:
            said = join_with_and([f'"{argument.words}"' for argument in extra])
            now.write("left_over_words", said, "asked. No server heeds it.")
            pending = Pending(without_positions(clauses), 0, (), now.expires_s, is_about_words=True)
            part = "part" if len(extra) == 1 else "parts"
            text = f"I cannot do the {said} {part}. Shall I do the rest?"
            return Question("LEFT_OVER_WORDS", text), replace(context, pending=pending)
    ignored = [sentence.word(index).form for readings in clauses for index in readings[0].left_over]
    done: List[Tuple[Reading, ...]] = []
    for readings in clauses:
        before = [one[0] for one in done]
        told = (with_finding(reading, before, now.known.frames) for reading in readings)
        readings = tuple(
            with_statements(with_indirect_questions(reading, sentence, now.known), sentence, now.known)
            for reading in told
        )
        if done:
            readings = _beside(readings, done[-1][0], context, now)
        question = _resolved(readings, context, now)
        if isinstance(question, _Open):
            waiting = without_positions(tuple(done) + (question.readings,) + clauses[len(done) + 1 :])
            pending = Pending(
                waiting, len(done), question.elements, now.expires_s, question.choices, offered=question.offered
            )
            if question.question.code == "MISSING_ELEMENT":
                # "Put the cup down." "Where should I put it?" "Put *it* on the table."
                context = remember(question.readings[0], sentence, now.known.frames, context)
            return question.question, replace(context, pending=pending)
        context = remember(question[0], sentence, now.known.frames, context)
        context = spoken_of(question[0], now.known, context)
        done.append(question)
    granted = without_granted_wishes(tuple(done), now.known.frames)
    if len(granted) < len(done):
        now.write("wishes", str(done[0][0]), "no step of its own. A later clause is a command for the same thing.")
        done = list(granted)
    unknown = [
        (now.known.frames[readings[0].unit.frame_name].on_unknown, argument)
        for readings in done
        for argument in unknown_arguments(readings[0], now.known)
    ]
    for policy_of_frame, argument in unknown:
        if policy_of_frame is UnknownPolicy.REFUSE:
            now.write("unknown_thing", argument.text, "refused. The frame wants what the robot knows.")
            return Refusal("UNKNOWN_THING", unknown_of(argument)), context
    confirm = [
        readings[0]
        for readings in done
        if policy.confirms
        and now.known.frames[readings[0].unit.frame_name].wants_yes(
            {one.name: _words_to_confirm(one) for one in readings[0].arguments}
        )
    ]
    wrong = [reason for readings in done for reason in _wrong_types(readings[0])]
    of_class = [readings[0] for readings in done if readings[0].unit.stands_for(readings[0].verb)]
    if is_confirmed:
        agreed = context.agreed_verbs.union((one.verb, one.unit.frame_name) for one in of_class)
        context = replace(context, agreed_verbs=agreed)
    meant = [
        _meant_by(one)
        for one in of_class
        if policy.confirms and (one.verb, one.unit.frame_name) not in context.agreed_verbs
    ]
    unseen = [unknown_of(argument) for policy_of_frame, argument in unknown if policy_of_frame is UnknownPolicy.ASK]
    if (confirm or wrong or unseen or meant) and not is_confirmed:
        pending = Pending(without_positions(tuple(done)), 0, (), now.expires_s)
        acts = ", then ".join(in_words(readings[0]) for readings in done)
        if wrong:
            now.write("wrong_type", acts, f"asked. {' '.join(wrong)}")
        elif unseen:
            now.write("unknown_thing", acts, f"asked. {' '.join(unseen)}")
        elif confirm:
            now.write("confirm", acts, "asked. The frame wants a yes.")
        else:
            now.write("verb_class", acts, "asked. A verb comes from the lexicon, and was not said before.")
        acts = acts if plan is None else _in_words_of(plan, sentence)
        reasons = [*meant, *wrong, *unseen]
        if meant and not (confirm or wrong or unseen):
            asked = Question("CONFIRM", " ".join([*reasons, "Say yes or no."]))
            return asked, replace(context, pending=pending)
        asked = Question("CONFIRM", " ".join([*reasons, f'Shall I really do this: "{acts}"? Say yes or no.']))
        return asked, replace(context, pending=pending)
    warning = f"ignored: {' '.join(ignored)}" if ignored and policy.left_over_words is LeftOverWords.WARN else ""
    return Understood(tuple(done), warning=warning), context


def _meant_by(reading: Reading) -> str:
    """Return the question whether a verb from the lexicon is meant like the verb in whose place it stands."""
    verb = reading.unit.stands_for(reading.verb)
    said = replace(reading, clause_text="")
    return f'By "{in_words(said)}", do you mean "{in_words(replace(said, verb=verb))}"?'


def _in_words_of(plan: PlanPart, sentence: Sentence) -> str:
    """Return a plan as it was said, which tells the order and the conditions; its label if it was said in two parts."""
    said, text = plan.label.lower().split(), sentence.tree.text.strip(" .!?")
    return text if all(word.strip(",") in text.lower() for word in said) else plan.label


def _beside(readings: Tuple[Reading, ...], before: Reading, context: Context, now: Now) -> Tuple[Reading, ...]:
    """Return the readings of a clause with the words resolved that refer to the clause before it."""
    frames = now.known.frames
    parallel = (resolve_in_parallel(reading, before, frames) for reading in readings)
    found = tuple(with_thing_taken(reading, before, context, frames) for reading in parallel)
    if found[0] != readings[0]:
        now.write("references", str(readings[0]), str(found[0]))
    return found


@dataclass(frozen=True)
class _Open:
    """A question about a clause: the readings, the element to ask for in each, and the allowed answers."""

    question: Question
    readings: Tuple[Reading, ...]
    elements: Tuple[str, ...]
    choices: Tuple[str, ...] = ()
    offered: Tuple[str, ...] = ()


def _words_to_confirm(argument: TypedArgument) -> Tuple[str, ...]:
    """Return what is compared with the words of a frame that wants a yes.

    In "go to the oven and turn *it* on", what the pronoun stands for counts.
    """
    meant = noun_phrase(argument.text) if argument.source is Source.INFERRED else ()
    return (argument.text, argument.lemma, argument.semantic_type, *meant)


def _resolved(readings: Tuple[Reading, ...], context: Context, now: Now) -> Union[Tuple[Reading, ...], _Open]:
    """Return the readings of a clause with their pronouns resolved, or the question to ask."""
    resolved: List[Reading] = []
    unresolved: List[Tuple[Reading, TypedArgument]] = []
    others_named = False
    for reading in readings:
        outcome = resolve(reading, context, now.known)
        if isinstance(outcome, TypedArgument):
            unresolved.append((reading, outcome))
        else:
            resolved.append(outcome)
            others_named |= bool(without_named_beside(reading, context).persons)
            if outcome != reading:
                now.write("references", str(reading), str(outcome))
    is_of_persons = all(value.text.lower() in _PERSONS_OR_THINGS for _, value in unresolved)
    # "Greet the guests and take *them* to the hall" carries nothing: no thing was mentioned.
    if unresolved and not (resolved and is_of_persons and others_named):
        now.write("references", unresolved[0][1].text, "asked. It is not known what it stands for.")
        question = Question("AMBIGUOUS", whom_is_meant(unresolved[0][1].text))
        names = tuple(value.name for _, value in unresolved)
        return _Open(question, tuple(reading for reading, _ in unresolved), names)
    if len(resolved) > 1:
        resolved = _of_meant_type(resolved, context, now.known)
    best = resolved[0]
    if best.missing:
        names = tuple(reading.asked[0].name for reading in resolved)
        now.write("missing_element", str(best), f"asked. No words for {' or '.join(dict.fromkeys(names))}.")
        return _Open(Question("MISSING_ELEMENT", question_of(resolved)), tuple(resolved), names)
    alternative: Optional[TypedArgument] = next((value for value in best.arguments if value.conjunction == "or"), None)
    if alternative is not None and now.policy.alternatives is Alternatives.ASK:
        now.write("alternatives", str(best), f"asked. {alternative.text} leaves a choice.")
        choices = tuple(member.text for member in alternative.members)
        question = Question("AMBIGUOUS", f"Which one: {join_with_or(choices)}?")
        return _Open(question, (best,), (alternative.name,), choices)
    referring = [refer(reading, now.known, context) for reading in resolved]
    best, unclear = referring[0]
    if unclear is not None:
        now.write("referents", str(best), f"asked. {unclear.element} may be {', '.join(unclear.ids)}.")
        return _Open(Question("AMBIGUOUS", unclear.question), (best,), (unclear.element,), offered=unclear.ids)
    for argument in best.arguments:
        if argument.referents:
            now.write("referents", argument.text, f"{', '.join(argument.referents)} ({argument.referent_count})")
    return tuple(reading for reading, others in referring if others is None)


def _of_meant_type(resolved: List[Reading], context: Context, known: FramedLexicon) -> List[Reading]:
    """Return the readings that take what their pronouns stand for: after "meet Anna", "take *them* to the hall" guides
    a person, and after "find the boxes" it carries things. All of them if none does."""
    persons = {one.text for one in context.persons} | {
        thing.text
        for thing in context.things
        if thing.phrases and all(phrase.semantic_type == PERSON for phrase in thing.phrases)
    }
    is_person: Dict[Tuple[int, ...], bool] = {}
    for reading in resolved:
        for value in reading.arguments:
            if value.source is Source.INFERRED and value.positions:
                # The best reading says what is meant.
                meant = [one.text for one in value.members] or [value.text]
                is_person.setdefault(value.positions, persons.issuperset(meant))

    def takes_what_is_meant(reading: Reading) -> bool:
        accepted = {
            value.positions: frozenset(accepted_types(reading, value.name, known.frames[reading.unit.frame_name]))
            for value in reading.arguments
            if value.positions in is_person
        }
        return all(
            not types or bool(types & with_parents(PERSON) if is_person[positions] else types - with_parents(PERSON))
            for positions, types in accepted.items()
        )

    return [reading for reading in resolved if takes_what_is_meant(reading)] or resolved


def _wrong_types(reading: Reading) -> List[str]:
    """Return a sentence for each value of another type than its element: what it is, and what it should be."""
    return [
        f'For me, "{wrong.words}" is {SEMANTIC_TYPES[wrong.found].words}{_instead_of(wrong.accepted)}.'
        for wrong in reading.wrong_types
    ]


def _instead_of(accepted: Sequence[str]) -> str:
    """Return what a value should be; nothing where that is nearly everything."""
    if len(accepted) > _MOST_TYPES_NAMED:
        return ""
    return ", not " + " or ".join(SEMANTIC_TYPES[name].words for name in accepted)


def without_positions(clauses: Clauses) -> Clauses:
    """Remove the left-over words from readings that outlive their sentence: positions mean nothing in the next one."""
    return tuple(tuple(replace(reading, left_over=(), extra=None) for reading in readings) for readings in clauses)


def in_words(reading: Reading) -> str:
    """Return a clause as it was said, or its verb and arguments where a pronoun stands for something else."""
    verb = frozenset(reading.verb_positions)
    own = (value for value in reading.arguments if value.positions and not verb.issuperset(value.positions))
    spoken = [value for value in own if value.text.lower() not in _HEARERS]
    # "Five minutes" are "5 minutes" for a server.
    said = [value.words if value.measure is not None else value.text for value in spoken]
    clause = reading.clause_text
    # "'d like the heating off" begins in the middle of a word.
    if clause[:1].isalnum() and all(text.lower() in clause.lower() for text in said):
        return clause[0].lower() + clause[1:]
    in_order = sorted(spoken, key=lambda value: min(value.positions))
    return " ".join([reading.verb, *(one.words if one.text in one.words else one.text for one in in_order)])
