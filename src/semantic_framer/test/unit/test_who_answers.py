"""A question is answered by the person who was asked, or by anybody at the page."""

from typing import Any, Callable

import pytest

from semantic_framer.clauses.readings import Heard
from semantic_framer.framer import Question, Understood, hear
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import Context

Hear = Callable[..., Heard]


@pytest.fixture
def say(parser: Any, lexicon: Any, frames: Any) -> Hear:
    verbs = frozenset(verb.split()[0] for verb in lexicon.verbs)

    def call(text: str, speaker: str, context: Context = Context(), **options: Any) -> Heard:
        known = FramedLexicon(lexicon, frames, speaker=speaker)
        return hear(parser.parse(text, verbs), known, context=context, **options)

    return call


@pytest.mark.parametrize(
    "asked, answers, is_at_page, is_answer",
    [
        ("anna", "anna", False, True),
        ("anna", "bob", False, False),
        ("anna", "bob", True, True),
        ("anna", "", False, True),
        ("", "bob", False, True),
    ],
)
def test_who_answers(say: Hear, asked: str, answers: str, is_at_page: bool, is_answer: bool) -> None:
    question = say("Close the door for ten seconds.", asked)
    assert isinstance(question.outcome, Question)
    answer = say("Yes.", answers, question.context, is_at_page=is_at_page)
    assert isinstance(answer.outcome, Understood) is is_answer
    if not is_answer:
        assert isinstance(say("Yes.", asked, answer.context).outcome, Understood)


def test_command_of_another_person_leaves_the_question_open(say: Hear) -> None:
    question = say("Close the door for ten seconds.", "anna")
    other = say("Turn left.", "bob", question.context)
    assert isinstance(other.outcome, Understood) and other.outcome.clauses[0][0].unit.frame_name == "turning"
    assert isinstance(say("Yes.", "anna", other.context).outcome, Understood)


def test_question_at_the_page_is_answered_by_anybody(say: Hear) -> None:
    question = say("Close the door for ten seconds.", "anna", is_at_page=True)
    assert isinstance(say("Yes.", "bob", question.context).outcome, Understood)
