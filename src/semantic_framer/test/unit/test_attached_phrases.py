"""Phrases that the parser takes for another part of a command, and ways of doing something that are no places."""

from typing import Any

import pytest

from semantic_framer.framer import LeftOverWords, Policy, Question, Refusal, Understood


@pytest.mark.parametrize(
    ("text", "frame"),
    [
        # Buttons are pressed, and not moved.
        ("Push the button next to the door.", "pressing(entity=the button next to the door)"),
        ("Push the box next to the door.", "pushing(theme=the box, goal=the door)"),
        # A way and a goal.
        ("Drive down the hall to the second door.", "navigating_to_location(goal=the second door, path=the hall)"),
        ("Go down the hall.", "moving_along_path(path=the hall)"),
        ("Creep up to the fridge.", "navigating_to_location(goal=the fridge)"),
        # What is not wanted is set aside.
        ("Bring me tea instead of coffee.", "bringing(theme=tea, beneficiary=me)"),
        ("Instead of the mug bring me a glass.", "bringing(theme=a glass, beneficiary=me)"),
        ("Go to the kitchen instead of the office.", "navigating_to_location(goal=the kitchen)"),
        ("Go to the kitchen, not the office.", "navigating_to_location(goal=the kitchen)"),
        # One thing, and not two.
        ("Bring me anything but beer.", "bringing(theme=anything but beer, beneficiary=me)"),
        ("Bring me something to drink.", "bringing(theme=something to drink, beneficiary=me)"),
        ("Grab the second bottle from the left.", "taking(theme=the second bottle from the left)"),
        ("Put the left shoe next to the right one.", "placing(theme=the left shoe, goal=the right shoe)"),
        ("Open the second drawer from the top.", "opening_container(containing_object=the second drawer from the top)"),
        ("Turn the box upside down.", "rotating(theme=the box, direction=down)"),
        ("Do the dishes.", "washing_dishes(object=the dishes)"),
        ("Set the oven to 200 degrees.", "switching_device(device=the oven, operational_state=200 degrees)"),
        ("Take the red mug, not the white one, to my desk.", "bringing(theme=the red mug, goal=my desk)"),
        # What tells a thing apart is no second thing.
        ("Put a bowl with a tomato in it in the fridge.", "placing(theme=a bowl with a tomato in it, goal=the fridge)"),
        ("Place a mug with a knife in it in a sink.", "placing(theme=a mug with a knife in it, goal=a sink)"),
        ("Put the flowers in the vase with water in it.", "placing(theme=the flowers, goal=the vase with water in it)"),
        ("Stand in the square.", "navigating_to_location(goal=the square)"),
        # Spellings.
        ("Turn ninety degrees counter-clockwise.", "turning(direction=counterclockwise, angle=90, angle_unit=degrees)"),
    ],
)
def test_what_is_meant(understand: Any, text: str, frame: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood), outcome
    (readings,) = outcome.clauses
    said = ", ".join(f"{value.name}={value.text}" for value in readings[0].arguments if value.positions)
    assert f"{readings[0].unit.frame_name}({said})" == frame


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Drive in a square.", "in a square"),
        ("Wash the red shirt by hand.", "by hand"),
    ],
)
def test_a_way_of_doing_is_asked_about(understand: Any, text: str, words: str) -> None:
    outcome, _ = understand(text, policy=Policy(left_over_words=LeftOverWords.ASK))
    assert outcome == Question("LEFT_OVER_WORDS", f'I cannot do the "{words}" part. Shall I do the rest?')


def test_all_but_one_has_an_exception(understand: Any) -> None:
    outcome, _ = understand("Bring me anything but beer.")
    assert isinstance(outcome, Understood)
    theme = outcome.clauses[0][0].argument("theme")
    assert theme is not None and [one.text for one in theme.exceptions] == ["beer"] and not theme.members


@pytest.mark.parametrize(
    "text, left_out",
    [
        ("Bring me a cup, not the red one.", "the red cup"),
        ("Bring me a cup, but not a dirty one.", "a dirty cup"),
        ("Take all cups and not the red one.", "the red cup"),
        ("Bring me three cups, not the red ones.", "the red cups"),
    ],
)
def test_what_is_left_out_of_a_kind_is_an_exception(understand: Any, text: str, left_out: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood)
    theme = outcome.clauses[0][0].argument("theme")
    assert theme is not None and [one.text for one in theme.exceptions] == [left_out]
    assert not theme.modifiers and not theme.exceptions[0].is_negated


def test_what_is_told_is_not_done(understand: Any) -> None:
    outcome, _ = understand("You forgot the sugar.")
    assert isinstance(outcome, Refusal) and outcome.code == "REPORT"
