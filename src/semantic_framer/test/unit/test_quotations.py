"""What is to be said is one argument, whatever it says; what stands around it counts as ever."""

from typing import Any, Dict

import pytest

from semantic_framer.framer import Refusal, Understood


def meant(outcome: Any) -> Any:
    assert isinstance(outcome, Understood), outcome
    return [
        {value.name: value.text for value in readings[0].arguments if value.positions} for readings in outcome.clauses
    ]


@pytest.mark.parametrize(
    "text, said",
    [
        ("say no thanks", {"message": "no thanks"}),
        ("say no, thanks", {"message": "no, thanks"}),
        ("say no thank you to Bob", {"message": "no thank you", "addressee": "Bob"}),
        ("say don't worry", {"message": "don't worry"}),
        ("say do not worry to Alice", {"message": "do not worry", "addressee": "Alice"}),
        ("shout don't move", {"message": "don't move"}),
        ("say never give up", {"message": "never give up"}),
        ("say sorry, I can't do that", {"message": "sorry, I can't do that"}),
        ("say there is no milk", {"message": "there is no milk"}),
        ("say hello and goodbye", {"message": "hello and goodbye"}),
        ("say hi and bye to the guests", {"message": "hi and bye", "addressee": "the guests"}),
        ("say hello to everyone in the room", {"message": "hello", "addressee": "everyone in the room"}),
        ("say turn left", {"message": "turn left"}),
        ("say please", {"message": "please"}),
        ("say hello please", {"message": "hello"}),
        ("say see you tomorrow", {"message": "see you tomorrow"}),
        ('say "I am not here"', {"message": "I am not here"}),
        ("tell her I will not come", {"addressee": "her", "message": "I will not come"}),
        ("tell Bob that I will not come", {"addressee": "Bob", "message": "I will not come"}),
        ("tell Bob not to come", {"addressee": "Bob", "message": "not to come"}),
        ("tell the kids to come to the table", {"addressee": "the kids", "message": "come to the table"}),
        ("tell my wife dinner is ready", {"addressee": "my wife", "message": "dinner is ready"}),
        ("tell her lunch is ready", {"addressee": "her", "message": "lunch is ready"}),
        ("tell Alice that dinner is ready", {"addressee": "Alice", "message": "dinner is ready"}),
        (
            "tell Bob I will be there in five minutes",
            {"addressee": "Bob", "message": "I will be there in five minutes"},
        ),
        ("tell me where it is", {"addressee": "me", "message": "where it is"}),
        ("tell me a joke", {"addressee": "me", "message": "a joke"}),
    ],
)
def test_quotation_is_one_argument(understand: Any, text: str, said: Dict[str, str]) -> None:
    assert meant(understand(text)[0]) == [said]
    (value,) = [value for value in understand(text)[0].clauses[0][0].arguments if value.name == "message"]
    assert value.members == ()


@pytest.mark.parametrize("text", ["say hello and turn left", "say hello, turn left", 'say "hello" and then turn left'])
def test_command_behind_a_quotation_is_done(understand: Any, text: str) -> None:
    assert meant(understand(text)[0]) == [{"message": "hello"}, {"direction": "left"}]


@pytest.mark.parametrize(
    "text, code",
    [
        ("don't say hello", "NEGATED"),
        ("do not say no", "NEGATED"),
        ("never say never", "NEGATED"),
        ("don't tell her I will come", "NEGATED"),
        ("say nothing", "NEGATED"),
        ("say nothing to Bob", "NEGATED"),
        ("say no more", "NEGATED"),
        ("say no word", "NEGATED"),
        ("tell nobody", "NEGATED"),
        ("tell no one the secret", "NEGATED"),
        ("tell Bob nothing", "NEGATED"),
        ("say hello a few times", "LEFT_OVER_WORDS"),
    ],
)
def test_what_stands_around_a_quotation_counts(understand: Any, text: str, code: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Refusal) and outcome.code == code


def test_answer_that_is_said_may_say_anything(understand: Any) -> None:
    question, context = understand("Say.")
    assert question.code == "MISSING_ELEMENT"
    assert meant(understand("don't worry", context)[0]) == [{"message": "don't worry"}]
