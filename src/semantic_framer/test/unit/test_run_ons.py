"""Commands that are said one after the other without a mark: both are done, or neither is."""

from typing import Any, Tuple

import pytest

from semantic_framer.framer import Understood

#: With the frames of the commands.
TWO_COMMANDS = {
    "open the cupboard close the drawer": ("opening_container", "closing_container"),
    "switch off the radio turn on the fan": ("switching_device", "switching_device"),
    "turn left move forward two metres": ("turning", "moving"),
    "go to the kitchen take the cup": ("navigating_to_location", "taking"),
    "pick up the mug bring it to me": ("taking", "bringing"),
    "turn left go to the office wait there": ("turning", "navigating_to_location", "waiting"),
    "open the box close it": ("opening_container", "closing"),
    "go to the office wait": ("navigating_to_location", "waiting"),
    "go forward three feet stop turn left": ("moving", "stopping", "turning"),
    "turn right turn left": ("turning", "turning"),
    "take the mug to the kitchen put it in the sink": ("bringing", "placing"),
    "open the fridge take the milk close the fridge": ("opening", "taking", "closing"),
    "put the cup on the table open the window": ("placing", "opening"),
    "bring me the book switch on the lamp": ("bringing", "switching_device"),
    "bring Anna the pen close the door": ("bringing", "closing"),
    "grab the bottle give it to Anna": ("taking", "giving"),
    "move back two feet turn left": ("moving", "turning"),
    "leave the kitchen enter the hall": ("departing", "arriving"),
    "turn on the light in the kitchen close the window": ("switching_device", "closing"),
    "clean the table wash the dishes": ("cleaning", "washing_dishes"),
    "go outside close the gate": ("navigating_to_location", "closing"),
    "wait here follow me": ("waiting", "following"),
    "switch the light on close the door": ("switching_device", "closing"),
}


@pytest.mark.parametrize("text, done", TWO_COMMANDS.items())
def test_each_command_is_a_clause(understand: Any, text: str, done: Tuple[str, ...]) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood)
    assert tuple(readings[0].unit.frame_name for readings in outcome.clauses) == done


@pytest.mark.parametrize(
    "text",
    [
        "go to room 3 polish the table",
        "go to room 3 knock on the door",
        "take the cup water the plants",
        "put the red cup in the sink the blue cup on the table",
        "take the mug polish the table",
    ],
)
def test_nothing_is_done_where_one_of_them_is_not_understood(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    assert not isinstance(outcome, Understood)


@pytest.mark.parametrize(
    "text, argument",
    [
        ("bring me the turn signal", "the turn signal"),
        ("take the open box", "the open box"),
        ("find the stop sign", "the stop sign"),
        ("clean the drop leaf table", "the drop leaf table"),
        ("bring me the light switch", "the light switch"),
        ("find the clean towel", "the clean towel"),
        ("take the cook book", "the cook book"),
        ("go to the show room", "the show room"),
        ("put the place mat on the shelf", "the place mat"),
        ("bring me half the milk", "half the milk"),
    ],
)
def test_a_noun_is_not_cut(understand: Any, text: str, argument: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood) and len(outcome.clauses) == 1
    assert argument in {value.text for value in outcome.clauses[0][0].arguments}
