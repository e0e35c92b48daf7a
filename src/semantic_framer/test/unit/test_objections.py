"""What is said against something that runs: the refusal's code says so, and what was not understood runs nothing."""

import re
from typing import Any

import pytest

from semantic_framer.changing.objections import KINDS, shipped_objections
from semantic_framer.framer import Question, Refusal, Understood
from semantic_framer.values.dialogue import Context
from utterance_passes.trees.formula_file import Formula

PROHIBITIONS = (
    "don't follow me",
    "Do not follow me!",
    "dont follow me",
    "don't you follow me",
    "never go there",
    "please don't go to the kitchen",
    "no, don't turn left",
    "robot, do not open the door",
    "don't go in there",
    "you must not follow me",
    "you shouldn't go there",
    "you can't go in there",
    "you don't have to follow me",
    "I don't want you to follow me",
    "nobody told you to turn left",
    "don't touch that",
    "don't go any faster",
    "no more turning left",
    "don't shout, run or jump",
    "don't move, speak and turn",
    "don't bring anything but water",
    "could you not follow me",
    "can you please not turn left",
)
CORRECTIONS = (
    "no",
    "No!",
    "nope",
    "wrong",
    "no, the office",
    "no the office",
    "no, not there",
    "not there",
    "Not to the kitchen!",
    "not that one",
    "not so fast",
    "no, I meant forward",
    "no I meant the other door",
    "I meant the office",
    "I said left",
    "no, right",
    "no turn right",
    "wrong way",
    "that's the wrong door",
    "that's wrong",
    "you're going the wrong way",
    "no no the other one",
    "the other one",
    "the other way",
    "sorry, the office",
    "actually the office",
    "the office instead",
    "left, not right",
    "that's not the kitchen",
    "that is not what I meant",
    "no, to the office",
    "forget going there",
    "no, jump to the moon",
    "don't go to the kitchen, sing to the moon",
    "I don't want to go there",
)
COMMANDS = {
    "no, turn right": "turning",
    "No! Turn right.": "turning",
    "no, go to the office": "navigating_to_location",
    "no wait, turn right": "turning",
    "I meant turn right": "turning",
    "no, I said turn right": "turning",
    "no no, follow me": "following",
    "wrong, turn right": "turning",
    "no just turn right": "turning",
    "no please turn right": "turning",
    "Don't go to the kitchen, go to the office.": "navigating_to_location",
    "Don't turn left. Turn right.": "turning",
    "please don't run, walk to the kitchen": "navigating_to_location",
    "don't wait for me, go to the kitchen": "navigating_to_location",
    "don't go to the kitchen but to the office": "navigating_to_location",
}
NEITHER = (
    "don't stop",
    "Do not stop!",
    "don't ever stop",
    "don't worry",
    "don't hurry",
    "don't wait",
    "don't stop turning",
    "I don't know",
    "I don't know where Anna is",
    "Anna does not like tea",
    "no one is here",
    "you did not turn left",
    "are you sure there is no way in",
    "why does the moon not shine",
    "no problem",
    "no thanks",
    "no idea",
    "not bad",
    "the office",
    "hello",
    "Colorless green ideas sleep furiously.",
)


_SHIPPED = [(kind, formula) for kind in KINDS for formula in shipped_objections()[kind]]
#: The code of a refusal behind which a pattern of a kind was found; empty for none.
CODES = {
    "corrections": "CORRECTION",
    "clear_corrections": "CORRECTION",
    "contrasts": "CORRECTION",
    "no_objections": "",
    "going_on": "",
    "forbidding": "NEGATED",
    "forbidden_deeds": "NEGATED",
    "asking": "",
    "reporting": "",
}


def divided(text: str) -> str:
    """A text as the parser divides it: "do n't go , please"."""
    return re.sub(r"(n't|'\w+|,)", r" \1", text.lower().replace("n't", " n't")).replace("  ", " ")


@pytest.mark.parametrize("kind, formula", _SHIPPED, ids=lambda value: getattr(value, "example", value))
def test_an_example_is_of_its_own_pattern(kind: str, formula: Formula) -> None:
    matching = [one for one in shipped_objections()[kind] if one.pattern.fullmatch(divided(formula.example))]
    assert matching == [formula]


@pytest.mark.parametrize("kind, formula", _SHIPPED, ids=lambda value: getattr(value, "example", value))
def test_an_example_is_what_its_kind_says(understand: Any, kind: str, formula: Formula) -> None:
    outcome, _ = understand(formula.example)
    assert isinstance(outcome, Refusal)
    assert (outcome.code if outcome.code in ("NEGATED", "CORRECTION") else "") == CODES[kind]


@pytest.mark.parametrize("text", PROHIBITIONS)
def test_prohibition(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Refusal) and outcome.code == "NEGATED"
    assert outcome.sentence.startswith("I am not doing that.")


@pytest.mark.parametrize("text", CORRECTIONS)
def test_correction_that_cannot_be_carried_out(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Refusal) and outcome.code == "CORRECTION"


@pytest.mark.parametrize("text, frame", COMMANDS.items())
def test_whole_command_in_a_correction_is_one(understand: Any, text: str, frame: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood)
    assert [readings[0].unit.frame_name for readings in outcome.clauses] == [frame]


@pytest.mark.parametrize("text", NEITHER)
def test_other_refusals_are_against_nothing(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Refusal) and outcome.code not in ("NEGATED", "CORRECTION")


def test_command_in_a_correction_that_lacks_something_is_asked_about(understand: Any) -> None:
    outcome, context = understand("no, turn")
    assert isinstance(outcome, Question) and outcome.code == "CORRECTION"
    answer, _ = understand("right", context)
    assert isinstance(answer, Understood)


def test_no_to_a_question_is_against_nothing_that_runs(understand: Any) -> None:
    _, context = understand("turn")
    assert context != Context()
    outcome, _ = understand("no", context)
    assert isinstance(outcome, Refusal) and outcome.code == "DECLINED"
