"""What the robot says."""

import datetime
import sys

import pytest

from utter.sound_process import run_bounded
from utter.speech import NothingToSay, spoken_text, told_fact, told_statement

NOON = datetime.datetime(2026, 11, 21, 12, 0)


@pytest.mark.parametrize(
    "message, addressee, said",
    [
        ("hello", "the class", "Hello, class."),
        ("hello", "", "Hello."),
        ("good morning", "me", "Good morning."),
        ("who is there?", "", "Who is there?"),
        ("hello", "Roger", "Hello, Roger."),
    ],
)
def test_spoken_text(message: str, addressee: str, said: str) -> None:
    assert spoken_text(message, addressee) == said


@pytest.mark.parametrize("message", ["", "  ", "x" * 501])
def test_spoken_text_refuses(message: str) -> None:
    with pytest.raises(NothingToSay):
        spoken_text(message)


def test_told_fact_reads_the_clock() -> None:
    assert told_fact("the time", NOON) == "It is 12:00."


@pytest.mark.parametrize(
    "addressee, said", [("Anna", "Anna, it is 12:00."), ("me", "It is 12:00."), ("the guests", "Guests, it is 12:00.")]
)
def test_told_fact_names_who_is_told(addressee: str, said: str) -> None:
    assert told_fact("the time", NOON, addressee) == said


@pytest.mark.parametrize(
    "message, addressee, said",
    [
        ("dinner is ready", "Anna", "Anna, I was asked to tell you: dinner is ready."),
        ("I am late", "the guests", "Guests, I was asked to tell you: I am late."),
        ("I see Bob", "me", "I see Bob."),
        ("Bob has left", "Anna", "Anna, I was asked to tell you: Bob has left."),
    ],
)
def test_statement_is_told_for_somebody(message: str, addressee: str, said: str) -> None:
    assert told_statement(message, addressee) == said


def test_the_robot_tells_what_it_finds_for_itself() -> None:
    assert told_statement("I see Bob", "Anna", is_own=True) == "Anna, I see Bob."


def test_told_fact_says_what_it_does_not_know() -> None:
    with pytest.raises(NothingToSay, match="the weather"):
        told_fact("the weather", NOON)


def test_run_bounded_runs_to_the_end() -> None:
    assert run_bounded([sys.executable, "-c", ""], timeout_s=20, is_wanted=lambda: True)


def test_run_bounded_ends_what_is_no_longer_wanted() -> None:
    assert not run_bounded([sys.executable, "-c", "import time; time.sleep(60)"], timeout_s=50, is_wanted=lambda: False)


def test_run_bounded_ends_at_the_deadline() -> None:
    assert not run_bounded([sys.executable, "-c", "import time; time.sleep(60)"], timeout_s=0.2, is_wanted=lambda: True)


def test_run_bounded_survives_a_missing_program() -> None:
    assert not run_bounded(["no-such-program"], timeout_s=1, is_wanted=lambda: True)
