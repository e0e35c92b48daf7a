"""The words beside a cry that nobody carries out."""

import pytest

from command_server.beside_cries import words_not_done


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("stop the dishwasher", ("the dishwasher",)),
        ("Stop the cart behind the blue line.", ("the cart behind the blue line",)),
        ("walk into the hall . go past the sofa . n stop .", ("walk into the hall", "go past the sofa")),
        ("Turn left. No, stop!", ("Turn left",)),
        ("stop, dance", ("dance",)),
        ("Stop the music and come back", ("the music",)),
        ("Everybody must stop the music.", ("the music",)),
        ("Dance. Stop!", ("Dance",)),
        ("abort the mission to fetch the mug", ("the mission to fetch the mug",)),
    ],
)
def test_words_that_may_ask_for_something_are_left(text, left):
    assert words_not_done(text) == left


@pytest.mark.parametrize(
    "text",
    [
        "Stop.",
        "Stop! Stop! Stop!",
        "stpo",
        "could you please stop right there",
        "Stop and come back.",
        "Cancel all orders.",
        "Stop, you will hit the lamp!",
        "Watch out! It is hot. Stop!",
        "stop following me",
        "cancel my last command",
        "don't move until I come back",
        "stop where you are",
        "stop as fast as you can",
        "Pepper, please stop!",
        "Stop, Rosie!",
        "The baby, stop!",
        "Stop! The baby!",
        "The baby is crying. Stop!",
        "Everybody must stop.",
        "Nobody must move.",
        "I want everybody to stop now.",
    ],
)
def test_nothing_is_left_of_a_stop_alone(text):
    assert words_not_done(text) == ()


def test_what_is_no_cry_leaves_nothing():
    assert words_not_done("Stop at the door.") == ()
