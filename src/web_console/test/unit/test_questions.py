"""Answers as buttons. The questions are those of the framer and the registrar."""

import pytest

from web_console.questions import question_of

NAMES = {"where": ("kitchen", "office")}


@pytest.mark.parametrize(
    ("code", "sentence", "answers"),
    [
        ("CONFIRM", 'Shall I really do this: "open drawer"? Say yes or no.', ("Yes", "No")),
        ("LEFT_OVER_WORDS", 'I cannot take "slowly" into account. Shall I go on without it?', ("Yes", "No")),
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
    asked = question_of(code, sentence, NAMES)
    assert asked.sentence == sentence
    assert asked.answers == answers


def test_there_are_not_too_many_answers():
    names = {"where": tuple(f"room {number}" for number in range(100))}
    assert len(question_of("MISSING_ELEMENT", "Where should I go?", names).answers) == 8
