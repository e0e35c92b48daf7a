"""Understands a sentence without conditions: small talk, a question, a change of the last command, or a command."""

from dataclasses import replace
from typing import Optional, Sequence, Tuple

from semantic_framer.asking.choices import choices_left_open
from semantic_framer.asking.settling import Now, ask_which, resolve_and_confirm
from semantic_framer.changing.fragment_changes import Change, change_of
from semantic_framer.changing.things_asked_for import as_said, asked_for
from semantic_framer.clauses.deeds import deeds_of, words_told
from semantic_framer.clauses.found_clauses import found_clauses
from semantic_framer.clauses.readings import Heard
from semantic_framer.clauses.state_questions import state_question
from semantic_framer.judging.said_words import positions_named
from semantic_framer.judging.sentence_verdicts import words_outside
from semantic_framer.judging.verdicts import Case, case_of
from semantic_framer.kinds.mood_file import UtteranceKind
from semantic_framer.kinds.utterance_kind import KindVerdict
from semantic_framer.queries.deed_questions import (
    ability_question,
    asking_features,
    deed_question,
    embedded_features,
    is_told_to_speaker,
    told_features,
)
from semantic_framer.queries.questions import question_readings
from semantic_framer.queries.shaped_clauses import own_question
from semantic_framer.referring.persons_spoken_of import persons_told
from semantic_framer.referring.references import thing_told
from semantic_framer.sentences.small_talk import answer_small_talk, small_talk_of
from semantic_framer.values.dialogue import Context, Pending
from semantic_framer.values.outcome import (
    PROHIBITION,
    REPORT,
    TALK,
    LeftOverWords,
    Outcome,
    Question,
    Refusal,
    Understood,
)
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from utterance_passes.phrases.clauses import Clause, find_clauses
from word_classes import agreement, word_class

#: FrameNet's name of seeing and hearing.
_SEEING = "Perception_experience"
_HEARERS = word_class("hearers")
_NO_QUESTION = "I have no open question."


def understand_plain(sentence: Sentence, context: Context, now: Now) -> Heard:
    """Understand a sentence that has no conditions.

    Args:
        sentence: the sentence
        context: what the framer remembers of earlier utterances
        now: the circumstances of the utterance
    """
    talk = small_talk_of(sentence.tree)
    if talk is not None:
        kind = KindVerdict(UtteranceKind.TALK, talk.name)
        now.write("utterance_kind", sentence.tree.text, str(kind))
        return Heard(answer_small_talk(talk), context, sentence, is_small_talk=True)
    clauses_of_tree = find_clauses(sentence.tree, now.known)
    if _answers_nothing(sentence, now):
        kind = KindVerdict(UtteranceKind.TALK, "agreements")
        now.write("utterance_kind", sentence.tree.text, str(kind))
        return Heard(Refusal(TALK, _NO_QUESTION), context, sentence, is_small_talk=True)
    change = None
    if now.policy.fragment_timeout_s and "fragment" not in now.known.without:
        change = change_of(sentence, clauses_of_tree, context, now.known)
    if change is not None:
        now.write("fragment", sentence.tree.text, change.note)
        return Heard(*_changed(change, sentence, context, now), sentence, named=change.positions)
    is_on = "things_asked_for" not in now.known.without
    wanted = asked_for(sentence, clauses_of_tree, now.known) if is_on else None
    if wanted is not None:
        now.write("things_asked_for", sentence.tree.text, wanted.tree.text)
        heard = understand_plain(wanted, context, now)
        if isinstance(heard.outcome, Understood):
            return replace(heard, outcome=as_said(heard.outcome), sentence=sentence)
        return heard
    known, policy = now.known, now.policy
    case = case_of(sentence, found_clauses(sentence, clauses_of_tree, known, now.trace), known, policy)
    if now.trace is not None:
        for clause, kind in zip(case.clauses, case.kinds):
            now.trace.add("utterance_kind", case.text_of(clause), after=str(kind), positions=clause.positions)
    asked = _asked(case, context)
    if asked:
        return _answered(asked, sentence, context, now)
    refusal, clauses = deeds_of(case, now.trace)
    if refusal is not None:
        # "Bob wants a beer." "Bring him one.": it may be spoken of further.
        is_told = refusal.code in (REPORT, TALK, PROHIBITION)
        return Heard(refusal, _told(sentence, case.clauses, context) if is_told else context, sentence, clauses)
    choices = choices_left_open(sentence, [(read.clause, read.kept[0]) for read in clauses], known)
    if choices:
        offered = " or ".join(choice.text for choice in choices)
        now.write("choices", offered, "asked. The person left it open.")
        return Heard(*ask_which(choices, context, now), sentence, clauses)
    kept = tuple(read.kept for read in clauses)
    read_ones = [read.clause for read in clauses]
    told = [clause for clause in case.clauses if clause not in read_ones]
    context = _told(sentence, told, context)
    outcome, context = resolve_and_confirm(kept, sentence, context, now)
    words = words_outside(sentence, case.clauses)
    if isinstance(outcome, Understood) and words and policy.left_over_words is LeftOverWords.WARN:
        ignored = " ".join(sentence.word(index).form for index in words)
        outcome = replace(outcome, warning=f"{outcome.warning or 'ignored:'} {ignored}")
    wished = positions_named(read.kept[0] for read in clauses if read.kept[0].is_wish)
    return Heard(outcome, context, sentence, clauses, named=words_told(case, clauses) | wished)


def _asked(case: Case, context: Context) -> Tuple[Reading, ...]:
    """Return the readings of what a sentence asks; none if it asks nothing that can be answered."""
    inside, told = embedded_features(case), told_features(case)
    found: Tuple[Reading, ...] = ()
    if inside is not None:
        found = own_question(case, inside) or state_question(case, inside) or deed_question(case, inside, context)
    if told is not None:
        found = found or own_question(case, told) or deed_question(case, told, context)
    if found:
        return found
    whole = asking_features(case)
    found = own_question(case, whole) if whole is not None else ()
    found = found or question_readings(case) or ability_question(case, context)
    # A pattern that holds each word knows best: "how many orders do you have".
    if whole is None or (found and not found[0].arguments):
        return found
    # "Was it closed *by you*" asks for a deed, "was it closed" for a state.
    by_somebody = deed_question(case, whole, context) if whole.is_passive and whole.agent and not found else ()
    found = by_somebody or state_question(case, whole) or found
    # "Can you see to the washing" asks for it to be done.
    return found or (deed_question(case, whole, context) if not case.acts else ())


def embedded_question(sentence: Sentence, context: Context, now: Now) -> Optional[Heard]:
    """Understand a sentence that tells nobody, but asks: "tell me whether you closed the door"; None for others."""
    said = sentence.unquoted
    if said is None or not is_told_to_speaker(sentence, now.known):
        return None
    case = case_of(said, find_clauses(said.tree, now.known), now.known, now.policy)
    features = told_features(case)
    asked = own_question(case, features) or deed_question(case, features, context) if features is not None else ()
    return _answered(asked, said, context, now) if asked else None


def _answered(asked: Tuple[Reading, ...], sentence: Sentence, context: Context, now: Now) -> Heard:
    now.write("question", str(asked[0]), f'answered, by "{asked[0].verb}"')
    # A question is read only with all of its words.
    named = frozenset(word.index for word in sentence.tree.words)
    return Heard(*resolve_and_confirm((asked,), sentence, context, now), sentence, named=named)


def _answers_nothing(sentence: Sentence, now: Now) -> bool:
    """Whether an utterance is a yes, and no command ("go ahead"); a no may be said against something that runs."""
    words = [word for word in sentence.tree.words if word.upos != "PUNCT"]
    is_command = bool(words) and bool(now.known.verbs_beginning_with(words[0].said))
    return not is_command and agreement(sentence.tree.text) is True


def _told(sentence: Sentence, told: Sequence[Clause], context: Context) -> Context:
    """Remember the thing and the persons that clauses tell something about."""
    thing = thing_told(sentence, told)
    return (context.with_thing(thing) if thing is not None else context).with_persons(persons_told(sentence, told))


def _changed(change: Change, sentence: Sentence, context: Context, now: Now) -> Tuple[Outcome, Context]:
    """Carry out a changed command, or ask first."""
    if change.outcome is not None:
        return change.outcome, context
    if not change.wants_yes:
        return resolve_and_confirm(change.clauses, sentence, context, now)
    act = change.clauses[0][0].clause_text
    now.write("confirm", act, "asked. It is said as a question, or the amount would be done again.")
    pending = Pending(change.clauses, 0, (), now.expires_s)
    return Question("CONFIRM", f'Shall I do this: "{act}"? Say yes or no.'), replace(context, pending=pending)
