"""Who is called, and what is said to it."""

import pytest

from voice_recognition.agreement import Heard, Verdict
from voice_recognition.calling import Calls, understood

CALLS = Calls(["robot", "Rosie", "robot_2"])


@pytest.mark.parametrize(
    ("text", "behind"),
    [
        ("Robot, go to the kitchen.", "go to the kitchen."),
        ("robot go to the kitchen", "go to the kitchen"),
        ("Hey Rosie! Where is Bob?", "Where is Bob?"),
        ("Okay, robot 2, turn left.", "turn left."),
        ("Rosie?", ""),
        ("Go to the kitchen, Robot.", None),
        ("Robots are taking our jobs.", None),
        ("Rosie's cup is red.", None),
        ("Hello there.", None),
        ("", None),
    ],
)
def test_a_call_stands_at_the_front(text: str, behind) -> None:
    assert CALLS.behind(text) == behind


def test_nobody_is_called_without_a_name() -> None:
    assert Calls().behind("Robot, go.") is None and Calls([" ", ""]).names == ()
    assert CALLS.words == {"robot", "rosie", "2"}


def test_what_was_heard_tells_who_is_called() -> None:
    event = understood(Heard(Verdict.LIKELY, (), (), ("rosie", "come", "here")), CALLS)
    assert event.is_called and not event.is_call_only
    assert understood(Heard(Verdict.NOTHING, (), (), ("hey", "rosie")), CALLS).is_call_only
    assert not understood(Heard(Verdict.NOTHING), CALLS).is_called
