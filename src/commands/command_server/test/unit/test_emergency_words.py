"""Which words engage the emergency stop, and which release it."""

import pytest

from command_server.emergency_words import is_emergency_stop, is_release, may_release
from command_server.stop_words import is_stop


@pytest.mark.parametrize(
    "text",
    [
        "Emergency stop.",
        "EMERGENCY STOP!!!",
        "emergency halt",
        "e-stop",
        "E stop now!",
        "estop",
        "Robot, emergency stop!",
        "Alpha, emergency stop.",
        "Hit the emergency stop!",
        "Engage the emergency stop.",
        "Please activate the emergency stop.",
        "Emergency stop and come back.",
    ],
)
def test_these_engage_it_and_are_cries(text):
    assert is_emergency_stop(text)
    assert is_stop(text)
    assert not is_release(text)


@pytest.mark.parametrize(
    "text",
    [
        "Stop.",
        "Emergency!",
        "Where is the emergency stop?",
        "Go to the emergency stop.",
        "Is the e-stop engaged?",
    ],
)
def test_these_do_not(text):
    assert not is_emergency_stop(text)


@pytest.mark.parametrize(
    "text",
    [
        "Release the emergency stop.",
        "release the emergency stop",
        "Please release the e-stop!",
        "OK, reset the estop now.",
        "Unlock the emergency stop.",
        "Robot, disengage the emergency stop, please.",
    ],
)
def test_these_release_it_and_are_no_cries(text):
    assert is_release(text)
    assert not is_stop(text)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "Go on.",
        "Release the brake.",
        "Release the emergency stop?",
        "Do not release the emergency stop.",
        "Never release the emergency stop.",
        "Release the emergency stop when I say so.",
        "Release the emergency stop in two minutes.",
        "Release the emergency stop and turn left.",
        "Should I release the emergency stop?",
        "I will release the emergency stop.",
        'Say "release the emergency stop".',
        "Stop. Release the emergency stop.",
        "Cancel the emergency stop.",
        'The emergency stop has held since 10:00:00. To release it, say "release the emergency stop".',
    ],
)
def test_these_do_not_release_it(text):
    assert not is_release(text)


@pytest.mark.parametrize("text", ["Alpha, release the emergency stop.", "Turn left and reset the e-stop, Beta."])
def test_a_name_or_more_words_may_still_release_that_of_another_robot(text):
    assert may_release(text)
    assert not is_release(text)


def test_other_words_may_not():
    assert not may_release("Alpha, emergency stop.")
