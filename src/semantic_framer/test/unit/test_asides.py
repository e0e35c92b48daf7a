"""What is only said around a command changes nothing of it; what changes it is no aside."""

import itertools
from typing import Any, Dict

import pytest

from semantic_framer.framer import Outcome, Question, Refusal, Understood

OPENINGS = (
    "why don't you {}",
    "how about you {}",
    "I was wondering if you could {}",
    "do me a favour and {}",
    "if you don't mind, {}",
    "would it be possible for you to {}",
    "I think you should {}",
    "hurry up and {}",
    "don't forget to {}",
    "make sure to {}",
    "would you be so kind as to {}",
    "it would be great if you could {}",
    "as soon as you can, {}",
    "right now {}",
    "alright, let's {}",
    "um could you maybe {}",
    "could you please possibly {}",
    "help me {}",
    "robot, would you be able to {}",
)
ENDINGS = (
    "{} if you don't mind",
    "{}, if you can",
    "{} right away",
    "{} at once",
    "{} as soon as possible",
    "{}, would you",
    "{} for me",
    "{}, thank you very much",
)
ACTIONS: Dict[str, Dict[str, str]] = {
    "turn left": {"direction": "left"},
    "go to the kitchen": {"goal": "the kitchen"},
    "close the door": {"container_portal": "the door"},
    "put the box on the table": {"theme": "the box", "goal": "the table"},
    "follow me to the garden": {"cotheme": "me", "goal": "the garden"},
}


def meant(outcome: Outcome) -> Dict[str, str]:
    if not isinstance(outcome, Understood):
        return {"code": outcome.code}
    (readings,) = outcome.clauses
    return {value.name: value.text for value in readings[0].arguments if value.positions and value.text != "you"}


def test_formulas_change_nothing(understand: Any) -> None:
    said = {
        pattern.format(action): arguments
        for pattern, (action, arguments) in itertools.product(OPENINGS + ENDINGS, ACTIONS.items())
    }
    found = {text: meant(understand(text)[0]) for text in said}
    assert {text: arguments for text, arguments in found.items() if arguments != said[text]} == {}


@pytest.mark.parametrize(
    "text, code",
    [
        ("why don't you not turn left", "QUESTION"),
        ("I was wondering if you could not turn left", "NEGATED"),
        ("don't turn left right now", "NEGATED"),
        ("if you can open the door, go to the kitchen", "CONDITION"),
        ("close the door right after lunch", "CONDITION"),
        ("when do you turn left", "QUESTION"),
    ],
)
def test_what_changes_a_command_is_no_aside(understand: Any, text: str, code: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Refusal) and outcome.code == code


@pytest.mark.parametrize("text", ["turn right now", "turn to the right now"])
def test_direction_is_no_aside(understand: Any, text: str) -> None:
    assert meant(understand(text)[0]) == {"direction": "right"}


def test_aside_alone_is_no_command(understand: Any) -> None:
    for text in ("right away", "if you don't mind", "thank you very much", "do me a favour"):
        assert isinstance(understand(text)[0], (Refusal, Question))
