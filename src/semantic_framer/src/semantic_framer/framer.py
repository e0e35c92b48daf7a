"""Understands a parsed utterance: the result is clauses of readings, a refusal, or a question."""

from dataclasses import replace
from typing import FrozenSet, Mapping, Optional, Sequence, Tuple, Union

from semantic_framer.amending import Change, change_of, last_command
from semantic_framer.answers import answer, time_answered
from semantic_framer.beginnings import beginning_of, without_beginning
from semantic_framer.choices import choices_of_amounts, choices_of_clauses, chosen
from semantic_framer.clause_links import Joints, find_joints
from semantic_framer.clause_plan import answers_in_a_loop, without_unused
from semantic_framer.dialogue import Context, Pending, is_no
from semantic_framer.found_clauses import found_clauses
from semantic_framer.framed_lexicon import FramedLexicon
from semantic_framer.lexicon import Lexicon
from semantic_framer.linked_clauses import NoStructure, Open
from semantic_framer.linked_plan import linked_plan
from semantic_framer.linked_sentence import (
    TELLING,
    asked_first,
    doubtful_message,
    joint_words,
    manners,
    swallowed_joints,
    unknown_link,
    with_open_time,
    without_joints,
)
from semantic_framer.mood_file import UtteranceKind
from semantic_framer.named_persons import with_persons
from semantic_framer.objections import against_what_runs
from semantic_framer.outcome import (
    CAREFUL,
    CORRECTION,
    DECLINED,
    MEANING_ONLY,
    PROHIBITION,
    QUESTION,
    REPORT,
    TALK,
    Alternatives,
    LeftOverWords,
    Outcome,
    Policy,
    Question,
    Refusal,
    Understood,
)
from semantic_framer.questions import question_readings, remark_readings
from semantic_framer.reading import Reading
from semantic_framer.readings import ClauseReadings, Heard, as_wish, readings_of_clause
from semantic_framer.sentence import Sentence
from semantic_framer.sentence_verdicts import (
    REST_VERDICTS,
    SENTENCE_VERDICTS,
    SentenceVerdict,
    words_outside,
)
from semantic_framer.settling import Now, ask_which, resolve_and_confirm, without_positions
from semantic_framer.small_talk import answer_small_talk, small_talk_of
from semantic_framer.utterance_kind import KindVerdict
from semantic_framer.verdicts import Case, case_of
from semantic_framer.world_attachment import attached_by_world, is_better, question_of_goal
from semantic_frames.frame import SemanticFrame
from utterance_passes.running import run_tree_passes
from utterance_passes.table import FRAMER_TREE_PASSES, REPHRASING_PASSES
from utterance_passes.trace import Trace
from utterance_passes.tree import DependencyTree
from utterance_passes.tree_edits import NotATree
from utterance_passes.utterance_pass import Choice, TreePass, Uncertain
from word_classes import word_class

_WANTING = word_class("wanting_verbs")

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
    without: FrozenSet[str] = frozenset(),
    trace: Optional[Trace] = None,
) -> Heard:
    """Understand an utterance.

    Args:
        tree: its parse
        known: lexical units and frames
        context: what the framer remembers of earlier utterances
        policy: how careful the framer is
        now_s: time on the caller's clock, seconds; it decides when questions expire
        said_s: stamp of the command, seconds; it decides which commands a fragment ("again") may repeat
        without: names of passes to switch off, which shows what a pass does
        trace: receives a line from every rule that changes or settles something; None for no trace
    """
    context = context.at(now_s).fresh(said_s, policy.fragment_timeout_s)
    heard = _Hearing(Now(known, policy, now_s, trace), without).hear(tree, context)
    outcome = heard.outcome if heard.is_small_talk else against_what_runs(heard.outcome, tree)
    heard = replace(heard, context=replace(heard.context, last=last_command(outcome, heard.context.last, said_s)))
    if trace is not None:
        if not isinstance(outcome, Understood) and outcome != heard.outcome:
            is_against = outcome.code in (PROHIBITION, CORRECTION)
            reason = "It is said against something that runs." if is_against else "It forbids nothing."
            trace.add("against_what_runs", after=f"{outcome.code}. {reason}")
        if not isinstance(outcome, Understood) and outcome.code == CORRECTION:
            trace.add("utterance_kind", after=str(KindVerdict(UtteranceKind.CORRECTION, "against_what_runs")))
        name = "understood" if isinstance(outcome, Understood) else f"{outcome.code}: {outcome.sentence}"
        trace.add("outcome", after=name)
    return replace(heard, outcome=outcome)


def restructured(
    tree: DependencyTree,
    known: FramedLexicon,
    *,
    passes: Sequence[TreePass] = FRAMER_TREE_PASSES,
    without: FrozenSet[str] = frozenset(),
    trace: Optional[Trace] = None,
) -> Union[Sentence, Tuple[Choice, ...]]:
    """Run the passes on a tree.

    Returns:
        the sentence; or the readings to choose from, if the correction is ambiguous
    """
    try:
        return Sentence(run_tree_passes(tree, known, passes, without=without, trace=trace), known.types)
    except Uncertain as uncertain:
        if trace is not None:
            trace.add("corrections", after=f"asked: {uncertain}" if uncertain.choices else "all is taken back")
        return uncertain.choices


class _Hearing:
    """Understands one utterance."""

    def __init__(self, now: Now, without: FrozenSet[str]) -> None:
        self._now = now
        self._without = without
        self._trace = now.trace

    def hear(self, tree: DependencyTree, context: Context) -> Heard:
        """Take an utterance as an answer to the open question, if it is one, or as a command."""
        meant = self._restructured(tree, FRAMER_TREE_PASSES)
        pending = context.pending
        context = replace(context, pending=None)
        if not isinstance(meant, Sentence):
            # This does not answer the earlier question.
            return Heard(*ask_which(meant, context, self._now))
        if pending is None:
            return self._read_in_world(meant, context)
        if is_no(tree.text):
            self._now.write("answer", tree.text, "a no to the question before")
            return Heard(Refusal(DECLINED, "All right, I do nothing."), context, meant)
        known, policy = self._now.known, self._now.policy
        if pending.readings:
            choice = chosen(meant, pending.readings, known)
            if choice is None:
                return self._read_in_world(meant, context)
            self._now.write("answer", tree.text, f'chooses "{choice.text}"')
            picked = self._restructured(choice.tree, REPHRASING_PASSES)
            if not isinstance(picked, Sentence):
                return Heard(*ask_which(picked, context, self._now))
            heard = self._read(picked, context)
            if isinstance(heard.outcome, Understood):
                clauses = without_positions(heard.outcome.clauses)
                heard = replace(heard, outcome=replace(heard.outcome, clauses=clauses))
            return heard
        if pending.open_time:
            plan = time_answered(meant, pending)
            if plan is None:
                return self._read_in_world(meant, context)
            self._now.write("answer", tree.text, str(plan))
            return Heard(*resolve_and_confirm(pending.clauses, meant, context, self._now, plan=plan), meant)
        is_strict = policy.left_over_words in CAREFUL
        answered = answer(meant, pending, known, is_strict=is_strict)
        if answered is None:
            return self._read_in_world(meant, context)
        self._now.write("answer", tree.text, "; ".join(str(readings[0]) for readings in answered))
        # A yes counts only as the answer to a yes-no question: "right" may also be a direction.
        is_confirmed = not pending.elements and not pending.is_about_words
        settled = resolve_and_confirm(answered, meant, context, self._now, is_confirmed=is_confirmed, plan=pending.plan)
        heard = Heard(*settled, meant)
        if isinstance(heard.outcome, Understood):
            return replace(heard, outcome=replace(heard.outcome, beginning=pending.beginning))
        return heard

    def _restructured(self, tree: DependencyTree, passes: Sequence[TreePass]) -> Union[Sentence, Tuple[Choice, ...]]:
        return restructured(tree, self._now.known, passes=passes, without=self._without, trace=self._trace)

    def _read_in_world(self, sentence: Sentence, context: Context) -> Heard:
        """Understand a sentence that is not an answer; what the robot knows attaches the places in it."""
        if told := remark_readings(sentence, self._now.known, self._trace):
            return Heard(*resolve_and_confirm((told,), sentence, context, self._now), sentence)
        attached = attached_by_world(sentence, self._now.known, context)
        if attached is None:
            return self._read(sentence, context)
        trace = Trace() if self._trace is not None else None
        heard = _Hearing(replace(self._now, trace=trace), self._without)._read(attached.sentence, context)
        plain = _Hearing(replace(self._now, trace=None), self._without)._read(sentence, context)
        best, before = ([read.kept[0] for read in one.clauses if read.kept] for one in (heard, plain))
        is_whole = len(best) == len(heard.clauses)
        if not is_whole or not is_better(attached, best, before, self._now.known):
            return self._read(sentence, context)
        self._now.write("attached_by_world", sentence.tree.text, attached.note)
        if trace is not None and self._trace is not None:
            self._trace.extend(trace.lines)
        if not attached.goals or not isinstance(heard.outcome, Understood):
            return heard
        # The robot may not know how the world is now: the thing may be where the person says.
        plan = heard.outcome.plan
        pending = Pending(without_positions(heard.outcome.clauses), 0, (), self._now.expires_s, plan=plan)
        return replace(heard, outcome=question_of_goal(attached), context=replace(heard.context, pending=pending))

    def _read(self, sentence: Sentence, context: Context) -> Heard:
        """Understand a sentence that is not an answer; it may say when it begins: "then go home"."""
        begun = beginning_of(sentence.tree)
        if begun is not None and any(
            begun.positions & time and not time <= begun.positions for time in sentence.tree.times
        ):
            begun = None  # "Next week" is a time; "afterwards" is none.
        bare = None if begun is None else without_beginning(sentence, begun, self._now.known)
        if begun is None or bare is None:
            return self._read_command(sentence, context)
        self._now.write("beginning", sentence.text(sorted(begun.positions)), begun.kind)
        heard = self._read_command(bare, context)
        if isinstance(heard.outcome, Understood):
            return replace(heard, outcome=replace(heard.outcome, beginning=begun.kind))
        pending = heard.context.pending
        if pending is not None:
            pending = replace(pending, beginning=begun.kind)
        return replace(heard, context=replace(heard.context, pending=pending))

    def _read_command(self, sentence: Sentence, context: Context) -> Heard:
        """Understand a command; one that cannot be understood as it is may have conditions."""
        heard = self._read_plainly(sentence, context)
        if heard.is_small_talk or self._now.policy.left_over_words not in CAREFUL:
            return heard
        known, outcome = self._now.known, heard.outcome
        if isinstance(outcome, Understood):
            best = [readings[0] for readings in outcome.clauses]
            doubt = doubtful_message(sentence, known, best)
            if doubt is not None:
                return Heard(doubt, context, sentence)
            joints = swallowed_joints(sentence, known, best)
            swallowed = Refusal("CONDITION", f'I do not understand how "{joint_words(sentence, joints)}" is meant.')
            refused = Heard(swallowed, context, sentence)
            how = Joints() if joints.found else manners(sentence, known)
            if how.found:
                swallowed = Refusal("CONDITION", f'I do not understand how "{joint_words(sentence, how)}" is meant.')
                return self._linked(sentence, context, swallowed, how) or Heard(swallowed, context, sentence)
            return self._linked(sentence, context, swallowed, joints) or refused if joints.found else heard
        return self._linked(sentence, context, outcome, find_joints(sentence, known)) or heard

    def _linked(
        self, sentence: Sentence, context: Context, before: Union[Refusal, Question], joints: Joints
    ) -> Optional[Heard]:
        """Understand a sentence whose deeds are joined by conditions and times; None if it is none.

        Args:
            sentence: the sentence
            context: what the framer remembers
            before: why the sentence cannot be understood as it is
            joints: what joins its deeds
        """
        unknown = unknown_link(sentence, joints, before)
        refused = Heard(unknown, context, sentence) if unknown is not None else None
        if refused is not None and joints.open_time is not None:
            return self._with_open_time(sentence, before, joints, refused)
        if not joints.found:
            return refused
        try:
            left = without_joints(sentence, joints, self._now.known)
        except NotATree:
            return None
        if left is None:
            question = Question("MISSING_ELEMENT", f"What should I do {joint_words(sentence, joints)}?")
            return None if before.code in (QUESTION, TALK) else Heard(question, context, sentence)
        for joint in joints.found:
            self._now.write("links", sentence.text(sorted(joint.positions)), joint.kind.value)
        bare = Sentence(left, self._now.known.types)
        case = case_of(bare, found_clauses(bare, self._now.known, self._trace), self._now.known, self._now.policy)
        clauses = self._deeds(case)
        if isinstance(clauses, Refusal):
            return Heard(clauses, context, sentence) if clauses.code in TELLING and refused is None else refused
        clauses = tuple(replace(read, kept=self._deeds_first(read.kept)) for read in clauses)
        best = [read.kept[0] for read in clauses]
        is_open = choices_of_clauses(bare, [read.clause for read in clauses], self._now.known) or choices_of_amounts(
            bare, best, self._now.known
        )
        if is_open or not all(case.kind_of(read.clause).acts for read in clauses):
            return refused
        try:
            deeds = [(read.clause, read.kept) for read in clauses]
            kept, plan = without_unused(*linked_plan(sentence, self._now.known, deeds, joints.found))
            kept = with_persons(kept, self._now.known.frames)
            if answers_in_a_loop(plan, kept, self._now.known.frames):
                raise NoStructure("what is answered at once does not go on")
        except Open as question_of:
            return Heard(Question("AMBIGUOUS", str(question_of)), context, sentence)
        except NoStructure as reason:
            self._now.write("links", sentence.tree.text, f"refused. {reason}")
            return refused
        self._now.write("plan", sentence.tree.text, str(plan))
        outcome, after = resolve_and_confirm(kept, bare, context, self._now, plan=plan)
        doubt = asked_first(sentence, joints, plan) if isinstance(outcome, Understood) else None
        if doubt is not None:
            self._now.write("links", sentence.tree.text, f"asked. {doubt.sentence}")
            pending = Pending(without_positions(kept), 0, (), self._now.expires_s, plan=plan, is_about_words=True)
            outcome, after = doubt, replace(context, pending=pending)
        return Heard(outcome, after, sentence, clauses)

    def _with_open_time(
        self, sentence: Sentence, before: Union[Refusal, Question], joints: Joints, refused: Heard
    ) -> Heard:
        """Ask for a time ("At what time tomorrow?"), and remember what is to be done then."""
        whole, words = with_open_time(sentence, joints)
        heard = self._linked(sentence, refused.context, before, whole)
        if heard is None or not isinstance(heard.outcome, Understood) or heard.outcome.plan is None:
            return refused
        clauses = without_positions(heard.outcome.clauses)
        pending = Pending(clauses, 0, (), self._now.expires_s, plan=heard.outcome.plan, open_time=words)
        return replace(heard, outcome=refused.outcome, context=replace(heard.context, pending=pending))

    def _deeds_first(self, readings: Tuple[Reading, ...]) -> Tuple[Reading, ...]:
        """Return the readings that act, if one does: "proceed until ..." is no answer to what waits."""
        frames = self._now.known.frames
        return tuple(reading for reading in readings if not frames[reading.unit.frame_name].is_question) or readings

    def _read_plainly(self, sentence: Sentence, context: Context) -> Heard:
        """Understand a sentence without conditions: small talk, a change of the last command, or a command."""
        talk = small_talk_of(sentence.tree)
        if talk is not None:
            kind = KindVerdict(UtteranceKind.TALK, talk.name)
            self._now.write("utterance_kind", sentence.tree.text, str(kind))
            return Heard(answer_small_talk(talk), context, sentence, is_small_talk=True)
        change = change_of(sentence, context, self._now.known) if self._now.policy.fragment_timeout_s else None
        if change is not None:
            self._now.write("fragment", sentence.tree.text, change.note)
            return Heard(*self._changed(change, sentence, context), sentence)
        known, policy = self._now.known, self._now.policy
        case = case_of(sentence, found_clauses(sentence, known, self._trace), known, policy)
        if self._trace is not None:
            for clause, kind in zip(case.clauses, case.kinds):
                self._trace.add("utterance_kind", case.text_of(clause), after=str(kind), positions=clause.positions)
        asked = question_readings(case)
        if asked:
            self._now.write("question", str(asked[0]), f'answered, by "{asked[0].verb}"')
            return Heard(*resolve_and_confirm((asked,), sentence, context, self._now), sentence)
        refusal = self._refusal(SENTENCE_VERDICTS, case)
        if refusal is not None:
            return Heard(refusal, context, sentence)
        clauses = self._readings(case)
        refusal = self._rest_refusal(case, clauses)
        if refusal is not None:
            return Heard(refusal, context, sentence, clauses)
        best = [read.kept[0] for read in clauses]
        choices = choices_of_clauses(sentence, [read.clause for read in clauses], known) or choices_of_amounts(
            sentence, best, known
        )
        if choices:
            offered = " or ".join(choice.text for choice in choices)
            self._now.write("choices", offered, "asked. The person left it open.")
            return Heard(*ask_which(choices, context, self._now), sentence, clauses)
        kept = tuple(read.kept for read in clauses)
        outcome, context = resolve_and_confirm(kept, sentence, context, self._now)
        words = words_outside(sentence, case.clauses)
        if isinstance(outcome, Understood) and words and policy.left_over_words is LeftOverWords.WARN:
            ignored = " ".join(sentence.word(index).form for index in words)
            outcome = replace(outcome, warning=f"{outcome.warning or 'ignored:'} {ignored}")
        return Heard(outcome, context, sentence, clauses)

    def _changed(self, change: Change, sentence: Sentence, context: Context) -> Tuple[Outcome, Context]:
        """Carry out a changed command, or ask first."""
        if change.outcome is not None:
            return change.outcome, context
        if not change.wants_yes:
            return resolve_and_confirm(change.clauses, sentence, context, self._now)
        act = change.clauses[0][0].clause_text
        self._now.write("confirm", act, "asked. The amount would be done again.")
        pending = Pending(change.clauses, 0, (), self._now.expires_s)
        return Question("CONFIRM", f'Shall I do this: "{act}"? Say yes or no.'), replace(context, pending=pending)

    def _readings(self, case: Case) -> Tuple[ClauseReadings, ...]:
        """Read each clause except the clauses that only tell something."""
        found = []
        has_order = any(word.form.lower() == "then" for word in case.sentence.tree.words)
        for clause, kind in zip(case.clauses, case.kinds):
            is_read = kind.is_read or clause.is_negated
            read = readings_of_clause(case, clause, self._trace) if is_read else None
            is_told = read is None or (read.refusal is not None and read.refusal.code == REPORT)
            if read is not None and not (is_told and case.is_background(clause)):
                found.append(as_wish(read) if clause.lemma in _WANTING and not has_order else read)
            elif self._trace is not None:
                self._trace.add("told", case.text_of(clause), after="no step", positions=clause.positions)
        return tuple(found)

    def _deeds(self, case: Case) -> Union[Refusal, Tuple[ClauseReadings, ...]]:
        """Return the readings of the clauses of a sentence, or why it is refused."""
        refusal = self._refusal(SENTENCE_VERDICTS, case)
        if refusal is not None:
            return refusal
        clauses = self._readings(case)
        return self._rest_refusal(case, clauses) or clauses

    def _rest_refusal(self, case: Case, clauses: Tuple[ClauseReadings, ...]) -> Optional[Refusal]:
        refused = next((read.refusal for read in clauses if read.refusal), None)
        return refused or self._refusal(REST_VERDICTS, case)

    def _refusal(self, verdicts: Sequence[SentenceVerdict], case: Case) -> Optional[Refusal]:
        for verdict in verdicts:
            refusal = verdict.refuse(case)
            if refusal is not None:
                if self._trace is not None:
                    self._trace.add(verdict.name, after=f"refused. {verdict.reason}")
                return refusal
        return None
