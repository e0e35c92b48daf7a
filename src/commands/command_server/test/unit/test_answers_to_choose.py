"""Answers to choose from. The questions are those of the framer and the registrar."""

import pytest

from command_server.answers import answers_to, closed_answers

NAMES = {"where": ("kitchen", "office")}


@pytest.mark.parametrize(
    ("code", "sentence", "answers"),
    [
        ("CONFIRM", 'Shall I really do this: "open drawer"? Say yes or no.', ("Yes", "No")),
        ("LEFT_OVER_WORDS", 'I cannot do the "slowly" part. Shall I do the rest?', ("Yes", "No")),
        ("AMBIGUOUS", 'Do you mean "turn left"?', ("Yes", "No")),
        ("AMBIGUOUS", 'Which do you mean: "turn left" or "go back"?', ("turn left", "go back")),
        ("AMBIGUOUS", "Which one: the mug, the plate or the cup?", ("the mug", "the plate", "the cup")),
        ("AMBIGUOUS", "Which one: the mug or the plate?", ("the mug", "the plate")),
        ("AMBIGUOUS", 'What do you mean by "it"?', ()),
        ("MISSING_ELEMENT", 'At whom should I wave? For instance: "Alice".', ("Alice",)),
        ("MISSING_ELEMENT", 'How far? For instance: "a metre". Or: To whom? For instance: "Bob".', ("a metre", "Bob")),
        ("MISSING_ELEMENT", 'Where should I go? For instance: "the office".', ("the office", "kitchen", "office")),
        ("MISSING_ELEMENT", "What is the theme?", ()),
        ("CORRECTION", 'Where? For instance: "left".', ("left", "kitchen", "office")),
    ],
)
def test_answers(code, sentence, answers):
    assert answers_to(code, sentence, NAMES) == answers
    # An example is no choice: another answer must not be heard as it.
    is_closed = code != "MISSING_ELEMENT" and not sentence.startswith("Where")
    assert closed_answers(code, sentence) == (answers if is_closed else ())


@pytest.mark.parametrize(
    ("sentence", "answers"),
    [
        ("Which mug, the red one or the blue one?", ("the red one", "the blue one")),
        (
            "Which mug, the red one of Anna in the hall or the blue one?",
            ("the red one of Anna in the hall", "the blue one"),
        ),
        (
            "Which door, the kitchen door, the hall door, the attic door or another one? I know of 9.",
            ("the kitchen door", "the hall door", "the attic door"),
        ),
    ],
)
def test_named_things_can_be_chosen_and_others_be_said(sentence, answers):
    assert answers_to("AMBIGUOUS", sentence, {}) == answers
    assert closed_answers("AMBIGUOUS", sentence) == ()


def test_there_are_not_too_many_answers():
    names = {"where": tuple(f"room {number}" for number in range(100))}
    assert len(answers_to("MISSING_ELEMENT", "Where should I go?", names)) == 8
