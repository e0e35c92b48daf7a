"""One word for each argument, and no question back: two habits of 2012."""

import pytest

from semantic_framer.behaviour_2012 import Arguments, Questions, with_habits
from semantic_framer.framer import LeftOverWords, Policy, Refusal, Understood
from semantic_framer.values.dialogue import Context

AS_IN_2012 = Policy(left_over_words=LeftOverWords.IGNORE)


@pytest.fixture
def understand_as_in_2012(understand):
    def call(text, context=Context()):
        outcome, context = understand(text, context=context, policy=AS_IN_2012)
        return with_habits(outcome, context, arguments=Arguments.SINGLE_WORDS, questions=Questions.REFUSE)

    return call


def best(outcome):
    """Frames of the best readings, with what was said."""
    assert isinstance(outcome, Understood), outcome
    return [
        (readings[0].unit.frame_name, {value.name: value.text for value in readings[0].arguments if value.positions})
        for readings in outcome.clauses
    ]


@pytest.mark.parametrize(
    "text, frame_name, arguments",
    [
        ("Go to Roger's office.", "navigating_to_location", {"goal": "office"}),
        ("Take the red mug on the table.", "taking", {"theme": "mug"}),
        ("Bring the mug and the plate to the kitchen.", "bringing", {"theme": "mug", "goal": "kitchen"}),
        ("Say hello to the class.", "saying", {"message": "hello", "addressee": "class"}),
        ("Turn left 120 degrees.", "turning", {"direction": "left", "angle": "120", "angle_unit": "degrees"}),
        ("Wait for five minutes.", "waiting", {"duration": "5 minutes"}),
        ("Follow me.", "following", {"cotheme": "me"}),
    ],
)
def test_an_argument_is_the_head_word(understand_as_in_2012, text, frame_name, arguments):
    outcome, _ = understand_as_in_2012(text)
    assert best(outcome) == [(frame_name, arguments)]


def test_one_word_is_no_list(understand_as_in_2012):
    outcome, _ = understand_as_in_2012("Bring the mug and the plate to the kitchen.")
    assert {(value.members, value.conjunction) for value in outcome.clauses[0][0].arguments} == {((), "")}


def test_a_pronoun_stands_for_one_word(understand_as_in_2012):
    outcome, context = understand_as_in_2012("Take the red mug and bring it to the old kitchen.")
    assert best(outcome) == [("taking", {"theme": "mug"}), ("bringing", {"theme": "mug", "goal": "kitchen"})]
    outcome, _ = understand_as_in_2012("Drop it.", context)
    assert [arguments for _, arguments in best(outcome)] == [{"theme": "mug"}]


def test_unused_words_are_ignored(understand_as_in_2012):
    outcome, _ = understand_as_in_2012("Turn left 120 degrees with a hammer.")
    assert best(outcome) == [("turning", {"direction": "left", "angle": "120", "angle_unit": "degrees"})]


@pytest.mark.parametrize(
    "text, code, asked", [("Move forward.", "MISSING_ELEMENT", "three feet"), ("Take it.", "AMBIGUOUS", '"it"')]
)
def test_a_question_becomes_a_refusal_that_nothing_answers(understand_as_in_2012, text, code, asked):
    outcome, context = understand_as_in_2012(text)
    assert isinstance(outcome, Refusal) and outcome.code == code and asked in outcome.sentence
    assert context.pending is None
    answered, _ = understand_as_in_2012("three feet", context)
    assert isinstance(answered, Refusal)


def test_what_must_not_be_done_is_refused_as_ever(understand_as_in_2012):
    assert [understand_as_in_2012(text)[0].code for text in ("Don't turn left.", "Turn left when I say so.")] == [
        "NEGATED",
        "CONDITION",
    ]


def test_without_the_habits_nothing_changes(understand):
    for text in ("Go to Roger's office.", "Move forward."):
        outcome, context = understand(text)
        same = with_habits(outcome, context, arguments=Arguments.PHRASES, questions=Questions.ASK)
        assert same == (outcome, context)
