"""Which utterances take back what was said before them."""

import pytest

from command_server.taking_back import takes_back, tells_to_go_on


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


@pytest.mark.parametrize(
    "text",
    [
        "no, keep going",
        "No, continue.",
        "no go on",
        "no no, go on!",
        "nope, carry on",
        "nah, keep going please",
        "no, just keep moving",
        "no, resume",
        "sorry, go on",
        "no, I said keep going",
        "no, you can continue now",
        "no, why don't you go on",
        "no, as you were",
        "no, keep going like that, thank you",
        "no keep following me",
        "no, keep on turning left",
        "no, continue driving to the kitchen",
        "actually, keep going",
    ],
)
def test_telling_to_go_on_takes_nothing_back(text):
    assert tells_to_go_on(text)
    assert not takes_back(text)


@pytest.mark.parametrize(
    "text",
    [
        "no, keep left",
        "no, keep your distance",
        "no, keep nothing",
        "no, continue to the garage",
        "no, go on to the garage",
        "no, continue right",
        "no, go on there",
        "no, keep going but not there",
        "no, keep following me, not him",
        "no, keep turning and come back",
        "no, keep going, no",
        "no, don't keep going",
        "don't go on",
        "no, do not continue",
        "no, you must not proceed",
        "not going on",
        "no, go ahead and turn right",
    ],
)
def test_going_on_elsewhere_or_not_at_all_takes_back(text):
    assert not tells_to_go_on(text)
    assert takes_back(text)


@pytest.mark.parametrize("text", ["", "no", "no, ...", "keep", "no, keep", "go to the kitchen", "going"])
def test_other_utterances_do_not_tell_to_go_on(text):
    assert not tells_to_go_on(text)


def test_long_text_is_read_from_its_beginning():
    assert takes_back("no, " + "go to the garage and " * 10_000)
