"""From a parsed utterance to what it asks for: clauses of readings, a refusal, or a question."""

from dataclasses import dataclass, replace
from enum import Enum
from typing import FrozenSet, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from semantic_frames.frame import SemanticFrame
from stanford_parser_ros.tree import DependencyTree

from semantic_framer.answers import answer, question_of
from semantic_framer.asides import with_asides, with_opening_aside
from semantic_framer.choices import choices_of_clauses, chosen, question_of_choices
from semantic_framer.clauses import CONDITIONS, RENEWING, WRAPPERS, Clause, find_clauses, shared_subject, whole_sentence
from semantic_framer.dialogue import Choice, Context, Pending, is_no
from semantic_framer.kind_replies import reply_to
from semantic_framer.lexicon import Lexicon
from semantic_framer.matching import Reading, rank
from semantic_framer.plain_verbs import with_plain_verbs
from semantic_framer.quotations import with_quotations
from semantic_framer.readings import readings_of
from semantic_framer.references import remember, resolve
from semantic_framer.repairs import repaired
from semantic_framer.sentence import Sentence
from semantic_framer.times import find_times
from semantic_framer.utterance_kind import KindVerdict, UtteranceKind, kind_without_clause, kinds_of_clauses
from semantic_framer.verb_matching import VerbMatch, match_verbs
from semantic_framer.values import ElementValue


class LeftOverWords(Enum):
    """What to do when a reading does not account for every content word."""

    STRICT = "strict"  # refuse, and say which words
    WARN = "warn"  # act, and say which words
    IGNORE = "ignore"  # act, as in 2012


class Alternatives(Enum):
    """What to do with "the mug or the plate"."""

    ASK = "ask"
    EITHER = "either"


@dataclass(frozen=True)
class Policy:
    """How careful to be.

    Attributes:
        left_over_words: for words that a reading does not account for
        alternatives: for "or"
        question_timeout_s: how long a question may be answered
    """

    left_over_words: LeftOverWords = LeftOverWords.STRICT
    alternatives: Alternatives = Alternatives.EITHER
    question_timeout_s: float = 30.0


@dataclass(frozen=True)
class Understood:
    """What is to be done: clauses in order, the readings of each the best first; ``warning`` names words that were
    ignored.
    """

    clauses: Tuple[Tuple[Reading, ...], ...]
    warning: str = ""


@dataclass(frozen=True)
class Refusal:
    """It is not to be done; ``code`` as in ``Reply.code``."""

    code: str
    sentence: str
    left_over: Tuple[str, ...] = ()


@dataclass(frozen=True)
class Question:
    """Something must be known first; ``code`` as in ``Reply.code``."""

    code: str
    sentence: str


Outcome = Union[Understood, Refusal, Question]

#: Verbs that only lead to a request: "go get the mug", "would you be so kind".
_LEADING = frozenset(["go", "come", "would", "be"])


def read(
    tree: DependencyTree,
    lexicon: Lexicon,
    frames: Mapping[str, SemanticFrame],
    *,
    context: Context = Context(),
    policy: Policy = Policy(),
    now_s: float = 0.0,
) -> Tuple[Outcome, Context]:
    """Understand an utterance.

    Args:
        tree: its parse
        lexicon: lexical units
        frames: by name
        context: what is remembered of the utterances before
        policy: how careful to be
        now_s: the caller's clock, seconds; questions expire on it
    Returns:
        what came of it, and what is to be remembered
    """
    context = context.at(now_s)
    meant = prepared(tree, lexicon, frames)
    if not isinstance(meant, Sentence):
        # What was asked before is answered by none of this.
        return _offer(meant, replace(context, pending=None), policy, now_s)
    pending = context.pending
    context = replace(context, pending=None)
    if pending is None:
        return _read_sentence(meant, lexicon, frames, context, policy, now_s)
    if is_no(tree.text):
        return Refusal("NEGATED", "As you wish: I do nothing."), context
    if pending.readings:
        choice = chosen(meant, pending.readings, lexicon)
        sentence = Sentence(_arranged(choice.tree, lexicon, frames)) if choice else meant
        outcome, context = _read_sentence(sentence, lexicon, frames, context, policy, now_s)
        if choice and isinstance(outcome, Understood):
            outcome = replace(outcome, clauses=_waiting(outcome.clauses))
        return outcome, context
    answered = answer(meant, pending, lexicon, frames, is_strict=policy.left_over_words is LeftOverWords.STRICT)
    if answered is None:
        return _read_sentence(meant, lexicon, frames, context, policy, now_s)
    # A yes counts only where it was asked for: "right" may be a direction.
    return _finish(answered, meant, frames, context, policy, now_s, is_confirmed=not pending.elements)


def _read_sentence(
    sentence: Sentence,
    lexicon: Lexicon,
    frames: Mapping[str, SemanticFrame],
    context: Context,
    policy: Policy,
    now_s: float,
) -> Tuple[Outcome, Context]:
    """Understand a sentence that answers nothing."""
    spoken = _known_clauses(sentence, lexicon)
    kinds = _kinds(sentence, spoken, lexicon)
    refusal = _asks_for_nothing(sentence, spoken, kinds)
    if refusal is not None:
        return refusal, context
    time = _time_of_a_command(sentence, lexicon)
    if time and not any(clause.is_negated for clause in spoken):
        return _not_then(sentence, time), context
    if not spoken:
        return Refusal("NO_VERB", f'I hear no command in "{sentence.tree.text.strip()}".'), context
    clauses: Tuple[Clause, ...] = ()
    understood: List[Tuple[Reading, ...]] = []
    for clause, kind in zip(spoken, kinds):
        # "I'm thirsty, bring me water": why somebody asks for something is no step.
        is_beside = kind.is_background and _is_set_off(sentence, clause, spoken)
        if not (kind.acts or kind.is_fact or kind.kind is UtteranceKind.PROHIBITION):
            if not is_beside:
                return _left_over(sentence, sorted(clause.positions)), context
            continue
        outcome = _read_one(sentence, clause, kind, lexicon, frames, policy)
        if isinstance(outcome, Refusal):
            if outcome.code == "REPORT" and any(other.acts for other in kinds) and is_beside:
                continue
            return outcome, context
        clauses += (clause,)
        understood.append(outcome)
    open_words = _outside(sentence, spoken)
    if open_words and policy.left_over_words is LeftOverWords.STRICT:
        return _left_over(sentence, open_words), context
    choices = choices_of_clauses(sentence, clauses, lexicon)
    if choices:
        return _offer(choices, context, policy, now_s)
    outcome, context = _finish(tuple(understood), sentence, frames, context, policy, now_s)
    if isinstance(outcome, Understood) and open_words and policy.left_over_words is LeftOverWords.WARN:
        words = " ".join(sentence.word(index).form for index in open_words)
        outcome = replace(outcome, warning=f"{outcome.warning or 'ignored:'} {words}")
    return outcome, context


def _kinds(sentence: Sentence, clauses: Tuple[Clause, ...], lexicon: Lexicon) -> Tuple[KindVerdict, ...]:
    return kinds_of_clauses(sentence.tree, sentence.abandoned | sentence.quoted, clauses, lexicon)


def _asks_for_nothing(
    sentence: Sentence, clauses: Tuple[Clause, ...], kinds: Tuple[KindVerdict, ...]
) -> Optional[Refusal]:
    """Return the refusal of an utterance that only asks or tells something; None for one that a unit may be about."""
    if not clauses:
        verdict = kind_without_clause(sentence.tree, sentence.abandoned | sentence.quoted)
        if verdict.kind not in (UtteranceKind.TALK, UtteranceKind.QUESTION):
            return None
        return Refusal(*reply_to(verdict, sentence.tree.text.strip(" .!?")))
    for clause, kind in zip(clauses, kinds):
        if kind.kind is UtteranceKind.QUESTION:
            return Refusal(*reply_to(kind, _said(sentence, clause)))
    if any(kind.acts or kind.is_fact or kind.kind is UtteranceKind.PROHIBITION for kind in kinds):
        return None
    return Refusal(*reply_to(kinds[0], sentence.tree.text.strip(" .!?")))


def _is_set_off(sentence: Sentence, clause: Clause, clauses: Tuple[Clause, ...]) -> bool:
    """Whether a clause stands before another one, or behind a mark or a conjunction: "the door we just left" tells
    which door is meant.
    """
    if clause.verb < max(other.verb for other in clauses):
        return True
    first = min(clause.positions)
    before = sentence.word(first - 1) if first > 1 else sentence.word(first)
    joined = {word.deprel for word in (before, sentence.word(first))}
    return bool(joined & {"punct", "cc", "mark"}) or sentence.word(first).form.lower() in RENEWING


def prepared(
    tree: DependencyTree, lexicon: Lexicon, frames: Mapping[str, SemanticFrame]
) -> Union[Sentence, Tuple[Choice, ...]]:
    """Put together what is to be said, and set aside what was corrected or is only said around the command.

    Returns:
        the sentence; or, where it is not certain what was corrected, the readings to choose from
    """
    corrected = repaired(tree, lexicon)
    if not isinstance(corrected, DependencyTree):
        return corrected
    return Sentence(_arranged(corrected, lexicon, frames))


def _arranged(tree: DependencyTree, lexicon: Lexicon, frames: Mapping[str, SemanticFrame]) -> DependencyTree:
    tree = with_plain_verbs(with_opening_aside(tree, lexicon), lexicon)
    return with_asides(with_quotations(tree, lexicon, frames), lexicon)


def _offer(
    choices: Tuple[Choice, ...], context: Context, policy: Policy, now_s: float
) -> Tuple[Union[Refusal, Question], Context]:
    """Let a person choose between readings, or tell one who took everything back that nothing is done."""
    if not choices:
        return Refusal("NEGATED", "You took that back, so I do nothing."), context
    expires_s = now_s + policy.question_timeout_s
    pending = Pending(clauses=(), clause=0, elements=(), expires_s=expires_s, readings=choices)
    return Question("AMBIGUOUS", question_of_choices(choices)), replace(context, pending=pending)


def _outside(sentence: Sentence, clauses: Tuple[Clause, ...]) -> Tuple[int, ...]:
    """Content words that are in no clause; those around a request ("I would like you to ...") are none of them."""
    inside = frozenset().union(*(clause.positions for clause in clauses))
    return tuple(
        word.index
        for word in sentence.tree.words
        if word.index not in inside
        and sentence.is_content(word.index)
        and word.lemma.lower() not in WRAPPERS | _LEADING
        and not (word.deprel.startswith("nsubj") and word.form.lower() in ("i", "you", "we"))
    )


def _left_over(sentence: Sentence, positions: Sequence[int]) -> Refusal:
    words = tuple(sentence.word(index).form for index in positions)
    return Refusal(
        "LEFT_OVER_WORDS",
        f'I do not understand "{" ".join(words)}" in "{sentence.tree.text.strip()}", so I do nothing.',
        left_over=words,
    )


def _time_of_a_command(sentence: Sentence, lexicon: Lexicon) -> FrozenSet[int]:
    """Return the words that say when something is to be done; none where nothing is.

    No element of a frame holds them, and a time hides the verb from the parser ("at five turn left"): so it counts
    wherever it stands, and whatever became of the clauses.
    """
    times = [time for time in find_times(sentence) if not time & (sentence.abandoned | sentence.quoted)]
    inside = frozenset().union(*times)
    is_command = any(
        lexicon.verbs_beginning_with(spelling)
        for word in sentence.tree.words
        if word.index not in inside
        for spelling in (word.lemma.lower(), word.form.lower())
    )
    return times[0] if times and is_command else frozenset()


def _inner_condition(sentence: Sentence, positions: FrozenSet[int]) -> FrozenSet[int]:
    """Return the words of a condition inside of what is to be found out: "see if it is hot when I say so"."""
    for index in sorted(positions):
        word = sentence.word(index)
        marks = {child.form.lower() for child in sentence.children(index) if child.deprel in ("mark", "advmod")}
        if word.deprel.startswith("advcl") and word.head in positions and marks & (CONDITIONS - {"if"}):
            return sentence.subtree(index)
    return frozenset()


def _not_then(sentence: Sentence, positions: Iterable[int]) -> Refusal:
    return Refusal("CONDITION", f'I can only act at once, not "{sentence.text(sorted(positions))}".')


def _known_clauses(sentence: Sentence, lexicon: Lexicon) -> Tuple[Clause, ...]:
    """Clauses of the sentence; where the parser saw no verb, a verb of the lexicon at its front ("High five!") makes
    one.
    """
    clauses = find_clauses(sentence, lexicon)
    if clauses and any(match_verbs(sentence, clause, lexicon) for clause in clauses):
        return clauses
    words = [
        word
        for word in sentence.tree.words
        if word.upos != "PUNCT" and (word.upos != "INTJ" or len(sentence.tree.words) < 3)
        if word.index not in sentence.abandoned
    ]
    if words:
        front = whole_sentence(sentence, words[0].index)
        if match_verbs(sentence, front, lexicon):
            return (front,)
    return clauses


def _read_one(
    sentence: Sentence,
    clause: Clause,
    kind: KindVerdict,
    lexicon: Lexicon,
    frames: Mapping[str, SemanticFrame],
    policy: Policy,
) -> Union[Tuple[Reading, ...], Refusal]:
    matches: Tuple[VerbMatch, ...] = match_verbs(sentence, clause, lexicon)
    if clause.is_negated or kind.kind is UtteranceKind.PROHIBITION:
        return Refusal("NEGATED", f'You said not to: "{sentence.text(sorted(clause.positions))}". I do nothing.')
    if not matches and clause.condition:
        return _not_then(sentence, clause.condition_positions)
    if not matches:
        near = lexicon.nearest_verbs(clause.lemma)
        hint = f' Do you mean {" or ".join(near)}?' if near else ""
        return Refusal("UNKNOWN_VERB", f'I do not know how to "{clause.lemma}".{hint}')
    readings = readings_of(sentence, clause, lexicon, frames)
    subject = clause.subject or shared_subject(sentence, clause.verb)
    about = tuple(reading for reading in readings if _is_about(reading, subject, frames))
    if kind.is_fact and clause.lemma != "be":
        # Only a unit that is about its subject tells how something is: "The mug stands on the table."
        if not about:
            return Refusal(*reply_to(kind, _said(sentence, clause)))
        readings = about
    elif kind.acts and subject:
        # Who is to do something is no thing that a unit is about: "could you stand next to the desk".
        readings = tuple(reading for reading in readings if reading not in about) or readings
    if not readings:
        wanted = {unit.frame_name for match in matches for unit in lexicon.units_of(match.verb)}
        if not wanted & set(frames):
            return Refusal("UNKNOWN_FRAME", f"No file describes the frame {' or '.join(sorted(wanted))}.")
        return Refusal("NO_READING", f'I know "{matches[0].verb}", but not in this way.')
    if clause.condition:
        # "Check if the oven is hot": the words fill an element and are no condition; "if" itself fills nothing.
        conditional = {index for index in clause.condition_positions if sentence.word(index).deprel != "mark"}
        readings = tuple(
            reading
            for reading in readings
            if (conditional or set(clause.condition_positions))
            <= {position for value in reading.values for position in value.positions}
        )
        # "... when I say so" behind it is one, whatever the words fill.
        inner = _inner_condition(sentence, clause.condition_positions)
        if not readings or inner:
            return _not_then(sentence, inner or clause.condition_positions)
    complete = tuple(reading for reading in readings if not reading.missing)
    if not complete:
        # "Move." asks where to as well as how far: the answer tells which was meant.
        return tuple(reading for reading in readings if rank(reading)[:4] == rank(readings[0])[:4])
    # Words that one reading accounts for must not be dropped by taking another.
    fewest = len(complete[0].left_over)
    full = tuple(
        reading
        for reading in complete
        if policy.left_over_words is LeftOverWords.IGNORE or len(reading.left_over) == fewest
    )
    # "Five" is less than was said where another unit lists "low five".
    return tuple(
        reading for reading in full if not any(reading.listed and reading.listed < other.listed for other in full)
    )


def _is_about(reading: Reading, subject: int, frames: Mapping[str, SemanticFrame]) -> bool:
    """Whether a subject is what a frame is about, and not only who does it."""
    frame = frames[reading.unit.frame_name]
    relations = {relation.name: relation for relation in reading.unit.relations}
    for value in reading.values:
        element = frame.element(value.name)
        if subject in value.positions and element is not None:
            is_required = value.name in relations and relations[value.name].is_required
            return element.is_core or is_required
    return False


def _said(sentence: Sentence, clause: Clause) -> str:
    return sentence.text([index for index in sorted(clause.positions) if sentence.word(index).upos != "PUNCT"])


def _finish(
    clauses: Tuple[Tuple[Reading, ...], ...],
    sentence: Sentence,
    frames: Mapping[str, SemanticFrame],
    context: Context,
    policy: Policy,
    now_s: float,
    *,
    is_confirmed: bool = False,
) -> Tuple[Outcome, Context]:
    """Resolve pronouns, then refuse or ask where something is open."""
    # Words that are left over are words of this sentence: they are judged before anything waits for another one.
    if policy.left_over_words is LeftOverWords.STRICT:
        for readings in clauses:
            if readings[0].left_over:
                return _left_over(sentence, readings[0].left_over), context
    ignored = [sentence.word(index).form for readings in clauses for index in readings[0].left_over]
    done: List[Tuple[Reading, ...]] = []

    def asked(readings: Tuple[Reading, ...], elements: Tuple[str, ...], choices: Tuple[str, ...] = ()) -> Context:
        """Return what is remembered while a question about the next clause is open."""
        waiting = _waiting(tuple(done) + (readings,) + clauses[len(done) + 1 :])
        expires_s = now_s + policy.question_timeout_s
        pending = Pending(clauses=waiting, clause=len(done), elements=elements, expires_s=expires_s, choices=choices)
        return replace(context, pending=pending)

    for readings in clauses:
        resolved_readings: List[Reading] = []
        unresolved: List[Tuple[Reading, ElementValue]] = []
        for reading in readings:
            outcome = resolve(reading, context)
            if isinstance(outcome, ElementValue):
                unresolved.append((reading, outcome))
            else:
                resolved_readings.append(outcome)
        if unresolved:
            question = Question("AMBIGUOUS", f'What do you mean by "{unresolved[0][1].argument}"?')
            elements = tuple(value.name for _, value in unresolved)
            return question, asked(tuple(reading for reading, _ in unresolved), elements)
        best = resolved_readings[0]
        if best.missing:
            elements = tuple(reading.asked[0].name for reading in resolved_readings)
            question = Question("MISSING_ELEMENT", question_of(resolved_readings))
            return question, asked(tuple(resolved_readings), elements)
        alternative = next((value for value in best.values if value.conjunction == "or"), None)
        if alternative is not None and policy.alternatives is Alternatives.ASK:
            question = Question("AMBIGUOUS", f"Which one: {' or '.join(alternative.items)}?")
            return question, asked((best,), (alternative.name,), alternative.items)
        context = remember(best, frames, context)
        done.append(tuple(resolved_readings))
    confirm = [readings[0] for readings in done if frames[readings[0].unit.frame_name].is_confirmed]
    if confirm and not is_confirmed:
        pending = Pending(
            clauses=_waiting(tuple(done)), clause=0, elements=(), expires_s=now_s + policy.question_timeout_s
        )
        acts = ", then ".join(_in_words(readings[0]) for readings in done)
        return Question("CONFIRM", f'Shall I really do this: "{acts}"? Say yes or no.'), replace(
            context, pending=pending
        )
    warning = f'ignored: {" ".join(ignored)}' if ignored and policy.left_over_words is LeftOverWords.WARN else ""
    return Understood(tuple(done), warning=warning), context


def _waiting(clauses: Tuple[Tuple[Reading, ...], ...]) -> Tuple[Tuple[Reading, ...], ...]:
    """Return readings that outlive their sentence: the positions of its words mean nothing in the next one."""
    return tuple(tuple(replace(reading, left_over=()) for reading in readings) for readings in clauses)


def _in_words(reading: Reading) -> str:
    """Return what a reading does: the verb, and the arguments that were said, in the order of the frame."""
    return " ".join([reading.verb] + [value.argument for value in reading.values if value.positions])
