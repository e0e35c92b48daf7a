"""Restores two habits of the 2012 system by parameters: an argument is one word, and the robot asks nothing back.

These habits change what the framer passes on, not what it understands. Two other habits of 2012 are parameters as
well: the random policy of the arbitrator, and ``LeftOverWords.IGNORE``.
"""

import re
from dataclasses import replace
from enum import Enum
from typing import Dict, Optional, Tuple

from semantic_framer.values.dialogue import Context
from semantic_framer.values.outcome import Outcome, Question, Refusal, Understood
from semantic_framer.values.reading import Reading
from typed_arguments import TypedArgument
from utterance_passes.engine.trace import Trace


class Arguments(Enum):
    """Which words of a phrase become the argument of an element."""

    PHRASES = "phrases"  # the words that the lexical unit asks for
    SINGLE_WORDS = "single_words"  # the head word alone, as in 2012


class Questions(Enum):
    """What to do if the framer needs to know something first."""

    ASK = "ask"
    REFUSE = "refuse"  # as in 2012; the refusal quotes the question


def with_habits(
    outcome: Outcome, context: Context, *, arguments: Arguments, questions: Questions, trace: Optional[Trace] = None
) -> Tuple[Outcome, Context]:
    """Apply the habits to the outcome of an utterance and to the context to be remembered.

    Args:
        outcome: the outcome without habits
        context: the context to be remembered
        arguments: which words become arguments
        questions: what to do with a question
        trace: receives a line for a change; None for no trace
    """
    changed, context = _with_habits(outcome, context, arguments, questions)
    if trace is not None and changed != outcome:
        what = "arguments are single words" if isinstance(changed, Understood) else "refused. Nothing is asked."
        trace.add("behaviour_2012", after=what)
    return changed, context


def _with_habits(
    outcome: Outcome, context: Context, arguments: Arguments, questions: Questions
) -> Tuple[Outcome, Context]:
    if questions is Questions.REFUSE and isinstance(outcome, Question):
        sentence = f'I would have to ask "{outcome.sentence}", and I am set to ask nothing. I do nothing.'
        return Refusal(outcome.code, sentence), replace(context, pending=None)
    if arguments is Arguments.SINGLE_WORDS and isinstance(outcome, Understood):
        return _in_single_words(outcome, context)
    return outcome, context


def _in_single_words(understood: Understood, context: Context) -> Tuple[Understood, Context]:
    head_of: Dict[str, str] = {}
    for readings in understood.clauses:
        for reading in readings:
            for value in reading.arguments:
                if _is_phrase(value) and _is_said(value):
                    head_of.setdefault(value.text, value.head)

    def shortened(value: TypedArgument) -> TypedArgument:
        if not _is_phrase(value):
            return value
        # The phrase has already replaced its pronoun, so the argument is the head of that phrase.
        word = value.head if _is_said(value) else head_of.get(value.text, value.text)
        return replace(value, text=word, conjunction="", members=())

    def with_words(reading: Reading) -> Reading:
        return replace(reading, arguments=tuple(shortened(value) for value in reading.arguments))

    clauses = tuple(tuple(with_words(reading) for reading in readings) for readings in understood.clauses)
    things = tuple(replace(one, text=head_of.get(one.text, one.text)) for one in context.things)
    place = context.place and replace(context.place, text=head_of.get(context.place.text, context.place.text))
    remembered = replace(context, things=things, place=place)
    return replace(understood, clauses=clauses), remembered


def _is_phrase(value: TypedArgument) -> bool:
    """Whether words of the utterance fill the element; amounts keep their unit, and defaults keep all words."""
    return bool(value.positions) and value.measure is None


def _is_said(value: TypedArgument) -> bool:
    """Whether the argument contains its own head word; the argument of a resolved pronoun does not."""
    return re.search(rf"(?<!\w){re.escape(value.head)}(?!\w)", value.text) is not None
