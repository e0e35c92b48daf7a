"""What a fragment leads to: the changed command, a question, or a refusal; and which command the next one changes."""

from dataclasses import dataclass, replace
from typing import FrozenSet, Optional, Sequence

from roboframenet_ros.spoken_text import join_with_or
from semantic_framer.changing.amending import Clauses, amended
from semantic_framer.changing.fragment_phrases import measured
from semantic_framer.changing.paces import PACES
from semantic_framer.clauses.fragments import Fragment, fragment_of
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import Context, LastCommand
from semantic_framer.values.fragment_kind import FragmentKind
from semantic_framer.values.outcome import (
    CORRECTION,
    DECLINED,
    QUESTION,
    REPORT,
    TALK,
    WISH,
    Outcome,
    Question,
    Refusal,
    Understood,
)
from semantic_framer.values.sentence import Sentence
from typed_arguments import Source
from utterance_passes.phrases.clauses import Clause
from utterance_passes.trees.tree import DependencyTree
from word_classes import word_class

_NEGATIONS = word_class("negations")
#: After these refusals, a fragment still means the command before: no other command was said.
_NO_COMMANDS = frozenset([TALK, QUESTION, REPORT, WISH, DECLINED, CORRECTION, "NO_VERB"])
#: Replies quote an utterance without these final marks.
_MARKS = " .!?,"


def last_command(
    outcome: Outcome, before: Optional[LastCommand], said_s: float, tree: Optional[DependencyTree]
) -> Optional[LastCommand]:
    """Return the command that the next fragment may change or repeat.

    A command that was refused or asked about leaves none: the fragment could mean it, and not the command before.

    Args:
        outcome: of this utterance
        before: the last command before it
        said_s: stamp of this utterance, seconds
        tree: of this utterance, if it is a sentence
    """
    if isinstance(outcome, Understood):
        # A command with conditions is not repeated without them.
        return LastCommand(outcome.clauses, said_s, tree) if outcome.plan is None else None
    return before if isinstance(outcome, Refusal) and outcome.code in _NO_COMMANDS else None


@dataclass(frozen=True)
class Change:
    """What a fragment leads to.

    Attributes:
        note: says in the trace what was done
        outcome: why nothing is done; None if the changed command is carried out
        clauses: readings of the changed command; empty with an outcome
        wants_yes: whether the person must first say yes
        positions: of all words of the utterance with the fragment
    """

    note: str
    outcome: Optional[Outcome] = None
    clauses: Clauses = ()
    wants_yes: bool = False
    positions: FrozenSet[int] = frozenset()


def change_of(sentence: Sentence, parsed: Sequence[Clause], context: Context, known: FramedLexicon) -> Optional[Change]:
    """Apply a fragment to the last command.

    Args:
        sentence: the utterance
        parsed: its clauses
        context: what the framer remembers
        known: lexical units and frames
    Returns:
        the change; None if the utterance is to be read as a command
    """
    is_question = _is_question(context.last, known)
    fragment = fragment_of(sentence, parsed, known, is_asked=is_question)
    if fragment is None:
        return None
    said = sentence.tree.text.strip(_MARKS)
    unclear = Question("AMBIGUOUS", f'What do you mean by "{said}"? Say it in a whole sentence.')
    if context.last is None:
        # "Not so fast" is said to whatever runs.
        if not fragment.needs_command or sentence.word(fragment.positions[0]).said in _NEGATIONS:
            return None
        return Change("asked. No command was said before it.", unclear)
    before = "; ".join(str(readings[0]) for readings in context.last.clauses)
    one_more = _one_more(fragment, context.last) if fragment.kind is FragmentKind.ONE_MORE else fragment
    if one_more is None:
        return Change(f"asked. It may say how often or how much {before}.", unclear)
    fragment = one_more
    found = amended(fragment, sentence, context.last, known)
    if len(found) > 1:
        options = [f'"{clauses[0][0].clause_text}"' for clauses in found]
        question = Question("AMBIGUOUS", f"Which do you mean: {join_with_or(options)}? Say it in a whole sentence.")
        return Change(f"asked. Several clauses of {before} have such an element.", question)
    if not found:
        if not fragment.needs_command:
            return None
        reason = f'I do not know what "{said}" means after my last command.'
        if fragment.kind in PACES:
            reason = f"I cannot do that {PACES[fragment.kind]}."
        refusal = Refusal("NO_VERB", reason)
        return Change(f"refused. It says nothing about {before}.", refusal)
    clauses = found[0]
    after = "; ".join(str(readings[0]) for readings in clauses)
    note = f"{fragment.kind.value}: {before} -> {after}"
    # A fragment is read from end to end.
    words = frozenset(word.index for word in sentence.tree.words)
    is_doubtful = (fragment.is_asked and not is_question) or _is_manner_of_amount(fragment, clauses, known)
    return Change(note, clauses=clauses, wants_yes=is_doubtful, positions=words)


def _one_more(fragment: Fragment, last: LastCommand) -> Optional[Fragment]:
    """Return "one more" as a repetition, or as one more of the things that were counted: "bring me two cups"; None if
    it may mean either: "turn left 90 degrees", "turn around twice"."""
    best = [readings[0] for readings in last.clauses]
    said = [one for reading in best for one in reading.arguments if one.source is not Source.DEFAULT]
    if any(one.measure is not None for one in said) or any(reading.control.count > 1 for reading in best):
        return None
    is_counted = any((one.count or 0) > 1 for one in said)
    if is_counted:
        return replace(fragment, positions=fragment.positions[:1])
    return replace(fragment, kind=FragmentKind.REPEAT)


def _is_question(last: Optional[LastCommand], known: FramedLexicon) -> bool:
    """Whether the last command asked something."""
    names = [readings[0].unit.frame_name for readings in last.clauses] if last is not None else []
    return any(name in known.frames and known.frames[name].is_question for name in names)


def _is_manner_of_amount(fragment: Fragment, clauses: Clauses, known: FramedLexicon) -> bool:
    """Whether a fragment says only how to do something that has an amount: "faster" after "move forward two metres"."""
    reading = clauses[0][0]
    frame = known.frames[reading.unit.frame_name]
    if fragment.kind in PACES:
        return bool(measured(reading, frame))
    if fragment.kind is not FragmentKind.ELEMENTS:
        return False
    said = {argument.name for argument in reading.arguments if argument.positions}
    core = {element.name for element in frame.frame_elements if element.is_core}
    return not said & core and any(argument.measure is not None for argument in reading.arguments)
