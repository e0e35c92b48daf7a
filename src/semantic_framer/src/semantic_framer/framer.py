"""Understands a parsed utterance: the result is clauses of readings, a refusal, or a question."""

from dataclasses import replace
from typing import FrozenSet, List, Mapping, Optional, Sequence, Tuple, Union

from semantic_framer.asking.answers import answer, time_answered
from semantic_framer.asking.choices import chosen
from semantic_framer.asking.nearest_meanings import asked_about
from semantic_framer.asking.other_trees import best_of_trees
from semantic_framer.asking.settling import Now, ask_which, resolve_and_confirm, without_positions
from semantic_framer.changing.fragment_changes import last_command
from semantic_framer.changing.objections import against_what_runs
from semantic_framer.clauses.readings import Heard
from semantic_framer.judging.said_words import RULE, words_left
from semantic_framer.kinds.mood_file import UtteranceKind
from semantic_framer.kinds.utterance_kind import KindVerdict
from semantic_framer.linking.beginnings import beginning_of, without_beginning
from semantic_framer.linking.clause_links import answers_a_question, asks_whether, find_joints, tells_how_long
from semantic_framer.linking.joints import Joints
from semantic_framer.linking.mixed_lists import are_handled_apart, with_items_apart
from semantic_framer.linking.news import told_when, with_end_told
from semantic_framer.queries.questions import remark_readings
from semantic_framer.referring.whose_deed import whose_deed
from semantic_framer.referring.world_attachment import attached_by_world, is_better, question_of_goal
from semantic_framer.referring.world_references import looked_up_again
from semantic_framer.sentences.linked_sentence import (
    doubtful_message,
    has_lost_link,
    joint_words,
    manners,
    swallowed_joints,
    swallowed_words,
    understand_linked,
)
from semantic_framer.sentences.plain_sentence import embedded_question, understand_plain
from semantic_framer.sentences.teaching import agreed, idiom_chosen, known_by_heart, taught_in_words
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.dialogue import Context, LastQuestion, Pending, is_no
from semantic_framer.values.outcome import (
    CAREFUL,
    CORRECTION,
    DECLINED,
    MEANING_ONLY,
    PROHIBITION,
    Alternatives,
    LeftOverWords,
    Noted,
    Outcome,
    Policy,
    Question,
    Refusal,
    Understood,
    lost_words_refusal,
)
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import SemanticFrame
from utterance_passes.engine.running import run_tree_passes
from utterance_passes.engine.trace import Trace
from utterance_passes.engine.utterance_pass import Choice, TreePass, Uncertain
from utterance_passes.table import FRAMER_TREE_PASSES, REPHRASING_PASSES
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.tree_edits import continued, lasting, said_after
from word_classes import agreement

#: The pass that makes one object of what somebody is told.
_QUOTATIONS = "quotations"
#: Codes of refusals that end an open question: what it asks about is forbidden, taken back or put right.
_ENDING_QUESTIONS = frozenset([PROHIBITION, CORRECTION, DECLINED])

__all__ = [
    "Alternatives",
    "Heard",
    "LeftOverWords",
    "Outcome",
    "Policy",
    "Question",
    "Refusal",
    "Understood",
    "hear",
    "read",
    "restructured",
]


def read(
    tree: DependencyTree,
    lexicon: Lexicon,
    frames: Mapping[str, SemanticFrame],
    *,
    context: Context = Context(),
    policy: Policy = MEANING_ONLY,
    now_s: float = 0.0,
) -> Tuple[Outcome, Context]:
    """Understand an utterance as :func:`hear` does, but return only the outcome and the context.

    Nobody is asked for a yes: this is for programs that do not act.
    """
    heard = hear(tree, FramedLexicon(lexicon, frames), context=context, policy=policy, now_s=now_s)
    return heard.outcome, heard.context


def hear(
    tree: DependencyTree,
    known: FramedLexicon,
    *,
    context: Context = Context(),
    policy: Policy = Policy(),
    now_s: float = 0.0,
    said_s: float = 0.0,
    is_at_page: bool = False,
    may_teach: bool = True,
    without: FrozenSet[str] = frozenset(),
    trace: Optional[Trace] = None,
) -> Heard:
    """Understand an utterance.

    A spoken question is answered by the person who was asked, or by anybody at the page. When another person says
    something, the question stays open.

    Args:
        tree: its parse
        known: lexical units and frames
        context: what the framer remembers of earlier utterances
        policy: how careful the framer is
        now_s: time on the caller's clock, seconds; it decides when questions expire
        said_s: stamp of the command, seconds; it decides which commands a fragment ("again") may repeat
        is_at_page: whether the utterance comes from the page or from a program, and not from the person who speaks
        may_teach: whether who speaks may teach the robot words; an agent may not
        without: names of passes and of :data:`.rules.RULES` to switch off, which shows what a rule does
        trace: receives a line from every rule that changes or settles something; None for no trace
    """
    known = replace(known, without=without) if without else known
    context = looked_up_again(context.at(now_s).fresh(said_s, policy.fragment_timeout_s), known)
    now = Now(known, policy, now_s, trace, may_teach)
    question, speaker = context.pending, "" if is_at_page else known.speaker
    is_of_another = question is not None and not question.may_be_answered_by(speaker)
    if question is not None and is_of_another:
        now.write("answer", tree.text, f"is none. {question.asked} was asked, not {speaker}")
        context = replace(context, pending=None)

    def read(other: DependencyTree, lines: Optional[Trace] = None) -> Heard:
        return _Utterance(replace(now, trace=lines)).checked(other, context)

    heard = best_of_trees(tree, read(tree, trace), context, now, read)
    heard = taught_in_words(tree, heard, context, now, read)
    heard = known_by_heart(heard, context, now)
    heard = asked_about(tree, heard, context, now, read)
    pending = heard.context.pending
    if pending is not None and pending is not question:
        words = heard.outcome.sentence if isinstance(heard.outcome, Question) else ""
        pending = replace(pending, asked=speaker, question=words)
    elif is_of_another:
        pending = question
    is_noted = heard.is_small_talk or isinstance(heard.outcome, Noted)
    outcome = heard.outcome if is_noted else against_what_runs(heard.outcome, tree)
    if pending is question and not is_of_another and isinstance(outcome, Refusal):
        pending = None if outcome.code in _ENDING_QUESTIONS else pending
    said = heard.sentence.tree if heard.sentence is not None and heard.clauses else None
    last = last_command(outcome, heard.context.last, said_s, said)
    asked = _last_question(heard, said_s)
    if trace is not None:
        if not isinstance(outcome, Understood) and outcome != heard.outcome:
            is_against = outcome.code in (PROHIBITION, CORRECTION)
            reason = "It is said against something that runs." if is_against else "It forbids nothing."
            trace.add("against_what_runs", after=f"{outcome.code}. {reason}")
        if not isinstance(outcome, Understood) and outcome.code == CORRECTION:
            trace.add("utterance_kind", after=str(KindVerdict(UtteranceKind.CORRECTION, "against_what_runs")))
        name = "understood" if isinstance(outcome, Understood) else f"{outcome.code}: {outcome.sentence}"
        trace.add("outcome", after=name)
    context = replace(heard.context, pending=pending, last=last, question=asked)
    return replace(heard, outcome=outcome, context=context, lessons=heard.lessons if may_teach else ())


def _last_question(heard: Heard, said_s: float) -> Optional[LastQuestion]:
    """Return what an utterance asks, if it does nothing else."""
    if heard.sentence is None or not isinstance(heard.outcome, Understood) or heard.outcome.plan is not None:
        return None
    return LastQuestion(heard.sentence.tree, said_s) if asks_whether(heard.sentence) else None


def restructured(
    tree: DependencyTree,
    known: FramedLexicon,
    *,
    passes: Sequence[TreePass] = FRAMER_TREE_PASSES,
    trace: Optional[Trace] = None,
) -> Union[Sentence, Tuple[Choice, ...]]:
    """Run the passes on a tree.

    Returns:
        the sentence; or the readings to choose from, if the correction is ambiguous
    """
    try:
        made = run_tree_passes(tree, known, passes, without=known.without, trace=trace)
        if not made.quoted or _QUOTATIONS in known.without:
            return Sentence(made, known.types)
        plain = run_tree_passes(tree, known, passes, without=known.without | {_QUOTATIONS})
        return Sentence(made, known.types, unquoted_tree=plain)
    except Uncertain as uncertain:
        if trace is not None:
            trace.add("corrections", after=f"asked: {uncertain}" if uncertain.choices else "all is taken back")
        return uncertain.choices


def _begun(heard: Heard, beginning: str) -> Heard:
    """Say what happens to the command that runs: at once, or when the question that is asked now is answered."""
    if isinstance(heard.outcome, Understood):
        return replace(heard, outcome=replace(heard.outcome, beginning=beginning))
    if heard.context.pending is None:
        return heard
    return replace(heard, context=replace(heard.context, pending=replace(heard.context.pending, beginning=beginning)))


def _best_readings(heard: Heard, asked: Optional[Pending]) -> List[Reading]:
    """Return the best reading of each clause that is done, or that is done after a yes to what the utterance asks."""
    if isinstance(heard.outcome, Understood):
        return [readings[0] for readings in heard.outcome.clauses]
    kept = [read.kept[0] for read in heard.clauses if read.kept]
    return [*kept, *(readings[0] for readings in asked.clauses)] if asked is not None else kept


class _Utterance:
    """Understands one utterance."""

    def __init__(self, now: Now) -> None:
        self._now = now
        self._trace = now.trace

    def checked(self, tree: DependencyTree, context: Context) -> Heard:
        """Understand an utterance, and refuse it if a word of it is lost."""
        heard = self._answer_or_command(tree, context)
        policy, sentence = self._now.policy, heard.sentence
        if policy.left_over_words not in CAREFUL or sentence is None or heard.is_answer:
            return heard
        asked = heard.context.pending if heard.context.pending is not context.pending else None
        if not isinstance(heard.outcome, Understood) and (asked is None or not asked.clauses):
            return heard
        is_asked = isinstance(heard.outcome, Question)
        lost = words_left(sentence.tree, _best_readings(heard, asked), heard.named, is_asked=is_asked)
        if not lost:
            return heard
        self._now.write(RULE, " ".join(lost), "refused. Nothing that was understood has these words.")
        refused = replace(heard, outcome=lost_words_refusal(sentence, lost), context=replace(context, pending=None))
        return self._with_open(context.pending, sentence, refused) if context.pending is not None else refused

    def _answer_or_command(self, tree: DependencyTree, context: Context) -> Heard:
        """Take an utterance as an answer to the open question, if it is one, or as a command."""
        meant = self._restructured(tree, FRAMER_TREE_PASSES)
        pending = context.pending
        context = replace(context, pending=None)
        if not isinstance(meant, Sentence):
            # This does not answer the earlier question.
            return Heard(*ask_which(meant, context, self._now))
        if pending is None:
            return self._attached_by_world(meant, context)
        if is_no(tree.text):
            self._now.write("answer", tree.text, "a no to the question before")
            return Heard(Refusal(DECLINED, "All right, I do nothing."), context, meant, lessons=pending.lessons_of_no())
        heard = self._answered(meant, pending, context)
        if heard is not None:
            return heard
        return self._with_open(pending, meant, self._attached_by_world(meant, context))

    def _with_open(self, pending: Pending, meant: Sentence, heard: Heard) -> Heard:
        """Keep a question open beside which only something else was said: talk, a question, or what is not understood.

        A new command, or a new question to the person, takes its place.
        """
        outcome, frames = heard.outcome, self._now.known.frames
        if heard.context.pending is not None or not pending.question:
            return heard
        if isinstance(outcome, Understood):
            best = [readings[0] for readings in outcome.clauses]
            if not all(frames[reading.unit.frame_name].is_question for reading in best):
                return heard
        elif isinstance(outcome, Refusal) and outcome.code not in _ENDING_QUESTIONS:
            said = outcome.sentence if agreement(meant.tree.text) is None else "That does not answer my question."
            heard = replace(heard, outcome=replace(outcome, sentence=f"{said} I still ask: {pending.question}"))
        else:
            return heard
        self._now.write("answer", pending.question, "is still open")
        return replace(heard, context=replace(heard.context, pending=pending))

    def _answered(self, meant: Sentence, pending: Pending, context: Context) -> Optional[Heard]:
        """Understand an utterance as an answer to the open question; None if it is none."""
        tree, known, policy = meant.tree, self._now.known, self._now.policy
        if pending.readings:
            choice = chosen(meant, pending.readings, known)
            if choice is None or pending.idioms:
                return None if choice is None else idiom_chosen(pending, choice, meant, context, self._now)
            self._now.write("answer", tree.text, f'chooses "{choice.text}"')
            picked = self._restructured(choice.tree, REPHRASING_PASSES)
            if not isinstance(picked, Sentence):
                return Heard(*ask_which(picked, context, self._now))
            heard = self._with_beginning(picked, context)
            if isinstance(heard.outcome, Understood):
                clauses = without_positions(heard.outcome.clauses)
                heard = replace(heard, outcome=replace(heard.outcome, clauses=clauses))
            return replace(heard, lessons=pending.lessons_of(choice))
        if pending.lessons:
            return agreed(pending, meant, context)
        if pending.unfinished is not None:
            return self._completing_sentence(pending.unfinished, meant, context)
        if pending.open_time:
            plan = time_answered(meant, pending)
            if plan is None:
                return None
            self._now.write("answer", tree.text, str(plan))
            settled = resolve_and_confirm(pending.clauses, meant, context, self._now, plan=plan)
            return Heard(*settled, meant, is_answer=True)
        asked = zip(pending.clauses[pending.clause], pending.elements)
        elements = [known.frames[reading.unit.frame_name].element(name) for reading, name in asked]
        # "Right" may be a direction; any other yes names nothing: "that is what I want".
        named = {value for one in elements if one is not None for value in one.values}
        if elements and agreement(tree.text) and named.isdisjoint(word.said for word in tree.words):
            return None
        is_strict = policy.left_over_words in CAREFUL
        answered = answer(meant, pending, known, is_strict=is_strict)
        if answered is None:
            return None
        self._now.write("answer", tree.text, "; ".join(str(readings[0]) for readings in answered))
        # A yes counts only as the answer to a yes-no question: "right" may also be a direction.
        is_confirmed = not pending.elements and not pending.is_about_words
        settled = resolve_and_confirm(answered, meant, context, self._now, is_confirmed=is_confirmed, plan=pending.plan)
        return _begun(Heard(*settled, meant, is_answer=True), pending.beginning)

    def _completing_sentence(self, unfinished: DependencyTree, said: Sentence, context: Context) -> Heard:
        """Understand what is said behind an unfinished sentence; a sentence of its own if it does not finish that."""
        link = max(word.index for word in unfinished.words if word.upos != "PUNCT")
        whole = Sentence(continued(unfinished, link, said.tree), self._now.known.types)
        heard = self._with_beginning(whole, context)
        if not isinstance(heard.outcome, Understood):
            return self._attached_by_world(said, context)
        self._now.write("answer", said.tree.text, "finishes the sentence before")
        return heard

    def _continuing_question(self, said: Sentence, context: Context) -> Optional[Heard]:
        """Understand what is said for one answer to the question before: "if so, close it"; None for anything else."""
        if context.question is None or not answers_a_question(said):
            return None
        whole = Sentence(said_after(context.question.tree, said.tree), self._now.known.types)
        heard = self._plain_or_linked(whole, context)
        if isinstance(heard.outcome, Refusal):
            return None
        self._now.write("answer", said.tree.text, "goes on with the question before")
        return heard

    def _extending_last_command(self, said: Sentence, context: Context) -> Optional[Heard]:
        """Understand how long the last command goes on, said for itself: "follow Anna" - "for five minutes"; None for
        anything else."""
        last = context.last.tree if context.last is not None else None
        if last is None or not tells_how_long(said):
            return None
        whole = Sentence(lasting(last, said.tree), self._now.known.types)
        heard = self._plain_or_linked(whole, context)
        if not isinstance(heard.outcome, Understood):
            return None
        self._now.write("answer", said.tree.text, "is said of the command before")
        return replace(heard, outcome=replace(heard.outcome, clauses=without_positions(heard.outcome.clauses)))

    def _restructured(self, tree: DependencyTree, passes: Sequence[TreePass]) -> Union[Sentence, Tuple[Choice, ...]]:
        return restructured(tree, self._now.known, passes=passes, trace=self._trace)

    def _attached_by_world(self, sentence: Sentence, context: Context) -> Heard:
        """Understand a sentence that is not an answer; what the robot knows attaches the places in it."""
        if told := remark_readings(sentence, self._now.known, self._trace):
            return Heard(*resolve_and_confirm((told,), sentence, context, self._now), sentence)
        asked = embedded_question(sentence, context, self._now)
        if asked is not None:
            return asked
        behind_question = self._continuing_question(sentence, context)
        if behind_question is not None:
            return behind_question
        is_on = "attached_by_world" not in self._now.known.without
        attached = attached_by_world(sentence, self._now.known, context) if is_on else None
        if attached is None:
            heard = self._with_beginning(sentence, context)
            is_done = isinstance(heard.outcome, Understood)
            return heard if is_done else self._extending_last_command(sentence, context) or heard
        trace = Trace() if self._trace is not None else None
        heard = _Utterance(replace(self._now, trace=trace))._with_beginning(attached.sentence, context)
        plain = _Utterance(replace(self._now, trace=None))._with_beginning(sentence, context)
        best, before = ([read.kept[0] for read in one.clauses if read.kept] for one in (heard, plain))
        is_whole = len(best) == len(heard.clauses)
        if not is_whole or not is_better(attached, best, before, self._now.known):
            return self._with_beginning(sentence, context)
        self._now.write("attached_by_world", sentence.tree.text, attached.note)
        if trace is not None and self._trace is not None:
            self._trace.extend(trace.lines)
        if not attached.goals or not isinstance(heard.outcome, Understood):
            return heard
        # The robot may not know how the world is now: the thing may be where the person says.
        plan = heard.outcome.plan
        pending = Pending(without_positions(heard.outcome.clauses), 0, (), self._now.expires_s, plan=plan)
        return replace(heard, outcome=question_of_goal(attached), context=replace(heard.context, pending=pending))

    def _with_beginning(self, sentence: Sentence, context: Context) -> Heard:
        """Understand a sentence that is not an answer; it may say when it begins: "then go home"."""
        begun = beginning_of(sentence.tree)
        if begun is not None and any(
            begun.positions & time and not time <= begun.positions for time in sentence.tree.times
        ):
            begun = None  # "Next week" is a time; "afterwards" is none.
        bare = None if begun is None else without_beginning(sentence, begun, self._now.known)
        if begun is None or bare is None:
            return self._plain_or_linked(sentence, context)
        self._now.write("beginning", sentence.text(sorted(begun.positions)), begun.kind)
        heard = self._plain_or_linked(bare, context)
        named = heard.named | begun.positions
        if isinstance(heard.outcome, Question):
            kept = tuple(read.kept for read in heard.clauses)
            told = with_end_told(kept, sentence, sorted(begun.positions), self._now.known)
            if told != kept:
                heard = Heard(*resolve_and_confirm(told, bare, context, self._now), bare, heard.clauses)
        return _begun(replace(heard, named=named), begun.kind)

    def _plain_or_linked(self, sentence: Sentence, context: Context) -> Heard:
        """Understand a command; one that cannot be understood as it is may have conditions."""
        heard = understand_plain(sentence, context, self._now)
        if heard.is_small_talk or self._now.policy.left_over_words not in CAREFUL:
            return heard
        known, outcome = self._now.known, heard.outcome
        is_plain = isinstance(outcome, Understood)
        if isinstance(outcome, (Refusal, Question)):
            heard = understand_linked(sentence, context, self._now, outcome, find_joints(sentence, known)) or heard
        if not isinstance(heard.outcome, Understood):
            return heard
        best = [readings[0] for readings in heard.outcome.clauses]
        apart = self._items_apart(sentence, best, context)
        if apart is not None:
            return apart
        if is_plain:
            doubt = doubtful_message(sentence, known, best)
            if doubt is not None:
                return Heard(doubt, context, sentence)
            choices = whose_deed(sentence, known, best)
            if choices:
                return Heard(*ask_which(choices, context, self._now), sentence)
            news = told_when(sentence, known, best)
            if news.found:
                waited = Refusal("CONDITION", f'I do not understand what "{joint_words(sentence, news)}" means here.')
                return understand_linked(sentence, context, self._now, waited, news) or heard
            is_lost = has_lost_link(sentence, best)
            joints = find_joints(sentence, known) if is_lost else swallowed_joints(sentence, known, best)
            how = Joints() if joints.found else manners(sentence, known)
            if how.found or joints.found or is_lost:
                how = how if how.found else joints
                swallowed = Refusal("CONDITION", f'I do not understand what "{joint_words(sentence, how)}" means here.')
                return understand_linked(sentence, context, self._now, swallowed, how) or Heard(
                    swallowed, context, sentence
                )
        words = swallowed_words(sentence, known, best)
        if words:
            return Heard(Refusal("CONDITION", f'I do not understand what "{words}" means here.'), context, sentence)
        return heard

    def _items_apart(self, sentence: Sentence, best: Sequence[Reading], context: Context) -> Optional[Heard]:
        """Understand each item of a list for itself; None where the items are not handled in different ways."""
        apart = with_items_apart(sentence, best) if "mixed_lists" not in self._now.known.without else None
        if apart is None:
            return None
        trace = Trace() if self._trace is not None else None
        heard = _Utterance(replace(self._now, trace=trace))._plain_or_linked(apart, context)
        outcome = heard.outcome
        if not isinstance(outcome, Understood) or not are_handled_apart(best, [one[0] for one in outcome.clauses]):
            return None
        self._now.write("mixed_lists", sentence.tree.text, "divided. Its items are handled in different ways.")
        if trace is not None and self._trace is not None:
            self._trace.extend(trace.lines)
        return heard
