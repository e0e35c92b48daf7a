"""Which utterances take the short way."""

import pytest

from command_server.stop_words import is_stop


@pytest.mark.parametrize(
    "text",
    [
        "Stop.",
        "stop",
        "halt",
        "STOP!!",
        "please stop",
        "robot, stop",
        "stop now",
        "freeze",
        "stop moving",
        "emergency stop",
        "abort",
        "no stop",
        "No! Stop!",
        "stop stop stop",
        "  stop  ",
        "Stop!\n",
        "Halt!",
        "Freeze, robot!",
        "stop right there",
        "stop right now",
        "Stop it.",
        "stop that",
        "stop everything",
        "stop, please",
        "hey robot, stop",
        "Stop the robot.",
        "STOP STOP STOP STOP STOP STOP STOP STOP STOP STOP STOP STOP STOP STOP",
        "e-stop",
        "E-Stop!",
        "stop turning",
        "Stop following me.",
        "stop driving forward",
        "robot stop moving now",
        "Stop where you are.",
        "stop at once",
        "Whoa!",
        "I said stop",
        "stand still",
        "Don't move!",
        "Do not move.",
        "don\u2019t move",
        "oh no stop",
        "\uff33top",
        "okay stop",
        "stop here",
        "Stop...",
        "abort abort abort",
        "stop! halt!",
        "Just stop.",
        "Stop going to the kitchen.",
        "stop the music",
        "Stop and go to the kitchen.",
        "stop turning and go to the kitchen",
        "stop the",
        "Stop following me, then turn left.",
        "abort the mission to fetch the mug",
    ],
)
def test_stops(text):
    assert is_stop(text)


@pytest.mark.parametrize(
    "text",
    [
        "stop at the kitchen",
        "don't stop",
        "Do not stop.",
        "stop by the office",
        "bus stop",
        "go to the bus stop",
        "",
        "   ",
        "...",
        "never stop",
        "stop at",
        "Move forward 3 feet.",
        "Go to the stop sign.",
        "unstoppable",
        "stopping",
        "stopped",
        "now",
        "please",
        "no",
        "stop moving when you see me",
        "move until I say stop",
        "stop 5 feet from the wall",
        "tell him to stop",
        "halting",
        "don't stop moving",
        "do not stop turning",
        "can't stop",
        "freeze the picture",
        "Turn left and stop.",
        "Say stop.",
    ],
)
def test_other_utterances_go_the_long_way(text):
    assert not is_stop(text)


def test_stop_of_any_length_is_still_a_stop():
    assert is_stop("stop " * 500)
    assert not is_stop("now " * 500)
