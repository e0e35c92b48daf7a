"""Which utterances take back what was said before them."""

import pytest

from command_server.taking_back import takes_back


@pytest.mark.parametrize(
    "text",
    [
        "no, go to the garage",
        "No! Go to the garage!",
        "NO GO TO THE GARAGE",
        "oh no, the garage",
        "hey robot, nope, turn right",
        "nah please turn right",
        "wrong, turn right",
        "wrong way, turn around",
        "not there, go to the garage",
        "not the kitchen. Go to the garage.",
        "oops, I meant the garage",
        "sorry, go to the garage",
        "actually, please go to the garage",
        "I said go to the garage",
        "that's wrong, go to the garage",
        "that isn't right, go to the garage",
        "you're not going to the garage",
        "I don't want that, go to the garage",
        "the other way, turn right",
        "instead, go to the garage",
        "go to the garage instead",
        "turn right, I mean",
        "don't go to the kitchen",
        "never turn left",
    ],
)
def test_correction_takes_back(text):
    assert takes_back(text)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "...",
        "go to the garage",
        "go to the garage, not the kitchen",
        "bring me tea instead of coffee",
        "no problem, go to the garage",
        "no thanks",
        "not yet",
        "not bad, turn right",
        "no, don't stop",
        "don't ever stop",
        "sorry",
        "oh, sorry!",
        "actually",
        "do the dishes",
        "no, you must not stop",
        "nobody is in the garage",
        "know the garage",
        "notice the garage",
        "say no",
        "turn right no left",
        "the other mug is in the kitchen",
    ],
)
def test_what_is_no_correction_takes_nothing_back(text):
    assert not takes_back(text)


def test_long_text_is_read_from_its_beginning():
    assert takes_back("no, " + "go to the garage and " * 10_000)
