"""Settles a fragment: carries out the changed command, asks, or leaves the utterance to be read as a command."""

from dataclasses import replace
from typing import Optional, Tuple

from semantic_framer.amending import Clauses, amended
from semantic_framer.dialogue import Context, LastCommand, Pending
from semantic_framer.fragments import Fragment, FragmentKind, fragment_of
from semantic_framer.outcome import (
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
    join_with_or,
)
from semantic_framer.sentence import Sentence
from semantic_framer.settling import Now, resolve_and_confirm

#: After these refusals, a fragment still means the command before: no other command was said.
_NO_COMMANDS = frozenset([TALK, QUESTION, REPORT, WISH, DECLINED, CORRECTION, "NO_VERB"])
#: Replies quote an utterance without these final marks.
_MARKS = " .!?,"


def last_command(outcome: Outcome, before: Optional[LastCommand], said_s: float) -> Optional[LastCommand]:
    """Return the command that the next fragment may change or repeat.

    A command that was refused or asked about leaves none: the fragment could mean it, and not the command before.

    Args:
        outcome: of this utterance
        before: the last command before it
        said_s: stamp of this utterance, seconds
    """
    if isinstance(outcome, Understood):
        return LastCommand(outcome.clauses, said_s)
    return before if isinstance(outcome, Refusal) and outcome.code in _NO_COMMANDS else None


def settle_fragment(sentence: Sentence, context: Context, now: Now) -> Optional[Tuple[Outcome, Context]]:
    """Apply a fragment to the last command.

    Args:
        sentence: the utterance
        context: what the framer remembers
        now: the circumstances of the utterance
    Returns:
        the outcome, and what to remember; None if the utterance is to be read as a command
    """
    if not now.policy.fragment_timeout_s:
        return None
    fragment = fragment_of(sentence, now.known)
    if fragment is None:
        return None
    said = sentence.tree.text.strip(_MARKS)
    if context.last is None:
        if not fragment.needs_command:
            return None
        now.write("fragment", said, "asked. No command was said before it.")
        return Question("AMBIGUOUS", f'What do you mean by "{said}"? Say it in a whole sentence.'), context
    before = "; ".join(str(readings[0]) for readings in context.last.clauses)
    found = amended(fragment, sentence, context.last, now.known)
    if len(found) > 1:
        now.write("fragment", said, f"asked. Several clauses of {before} have such an element.")
        return _which(found, context)
    if not found:
        if not fragment.needs_command:
            return None
        now.write("fragment", said, f"refused. It says nothing about {before}.")
        return Refusal("NO_VERB", f'I do not know what "{said}" means after my last command.'), context
    clauses = found[0]
    after = "; ".join(str(readings[0]) for readings in clauses)
    now.write("fragment", said, f"{fragment.kind.value}: {before} -> {after}")
    if _is_manner_of_amount(fragment, clauses, now):
        acts = clauses[0][0].clause_text
        now.write("confirm", acts, "asked. The amount would be done again.")
        pending = Pending(clauses, 0, (), now.expires_s)
        asked = Question("CONFIRM", f'Shall I do this: "{acts}"? Say yes or no.')
        return asked, replace(context, pending=pending)
    return resolve_and_confirm(clauses, sentence, context, now)


def _which(found: Tuple[Clauses, ...], context: Context) -> Tuple[Outcome, Context]:
    options = [f'"{clauses[0][0].clause_text}"' for clauses in found]
    return Question("AMBIGUOUS", f"Which do you mean: {join_with_or(options)}? Say it in a whole sentence."), context


def _is_manner_of_amount(fragment: Fragment, clauses: Clauses, now: Now) -> bool:
    """Whether a fragment says only how to do something that has an amount: "faster" after "move forward two metres"."""
    if fragment.kind is not FragmentKind.ELEMENTS:
        return False
    reading = clauses[0][0]
    frame = now.known.frames[reading.unit.frame_name]
    said = {argument.name for argument in reading.arguments if argument.positions}
    core = {element.name for element in frame.frame_elements if element.is_core}
    return not said & core and any(argument.measure is not None for argument in reading.arguments)
