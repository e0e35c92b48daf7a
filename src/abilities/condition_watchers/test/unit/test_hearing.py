"""Conditions on what is said and on the clock."""

from datetime import datetime

import pytest

from condition_watchers.hearing import MOMENT_S, Saying, Sayings, clock_shows
from condition_watchers.places import is_near
from typed_arguments import TimeExpression, TypedArgument


def said(*sayings: Saying) -> Sayings:
    heard = Sayings()
    for saying in sayings:
        heard.hear(saying)
    return heard


@pytest.mark.parametrize(
    "speaker, message, now_s, expected",
    [
        ("I", "hello", 10.1, True),
        ("somebody", "", 10.1, True),
        ("Alice", "hello", 10.1, True),
        ("Bob", "hello", 10.1, False),
        ("", "Hello, robot", 10.1, True),
        ("I", "hell", 10.1, False),
        ("I", "goodbye", 10.1, False),
        ("I", "hello", 10.1 + MOMENT_S, False),
    ],
)
def test_what_was_just_said(speaker: str, message: str, now_s: float, expected: bool) -> None:
    heard = said(Saying("Alice", "Hello robot!", 10.0, 1.0))
    found = heard.match(TypedArgument(text=speaker), TypedArgument(text=message), now_s=now_s)
    assert (found is not None) is expected


def test_the_last_of_two_counts() -> None:
    heard = said(Saying("", "hello", 10.0, 1.0), Saying("", "hello", 10.2, 2.0))
    found = heard.match(TypedArgument(), TypedArgument(text="hello"), now_s=10.3)
    assert found is not None and found.stamp_s == 2.0


@pytest.mark.parametrize(
    "time, expected",
    [
        (TimeExpression("time", value="T08:00"), True),
        (TimeExpression("time", value="T08"), True),
        (TimeExpression("time", value="T08:01"), False),
        (TimeExpression("time", value="T20:00"), False),
        (TimeExpression("time", begin_s=datetime(2026, 5, 4, 8, 0, 1).timestamp(), end_s=4e9), True),
        (TimeExpression("time", begin_s=datetime(2026, 5, 4, 8, 1).timestamp(), end_s=4e9), False),
        (TimeExpression("time", begin_s=datetime(2026, 5, 4, 7, 59).timestamp(), end_s=4e9), False),
    ],
)
def test_clock_shows_a_minute(time: TimeExpression, expected: bool) -> None:
    assert clock_shows(TypedArgument("time", "then", time=time), datetime(2026, 5, 4, 8, 0, 30)) is expected


@pytest.mark.parametrize(
    "text, hour, expected",
    [
        ("eight", 8, True),
        ("eight", 20, True),
        ("8", 20, True),
        ("eight", 9, False),
        ("20", 20, True),
        ("20", 8, False),
        ("twelve", 0, True),
        ("noon", 12, True),
        ("noon", 0, False),
        ("midnight", 0, True),
    ],
)
def test_hours_in_words(text: str, hour: int, expected: bool) -> None:
    assert clock_shows(TypedArgument("time", text), datetime(2026, 5, 4, hour, 0, 59)) is expected
    assert clock_shows(TypedArgument("time", text), datetime(2026, 5, 4, hour, 1, 0)) is False


@pytest.mark.parametrize("text, time", [("soon", None), ("", None), ("99", None), ("5 s", TimeExpression("duration"))])
def test_what_is_no_moment_cannot_be_told(text: str, time: TimeExpression) -> None:
    with pytest.raises(ValueError, match="no time of the day"):
        clock_shows(TypedArgument("time", text, time=time), datetime(2026, 5, 4, 8, 0, 30))


def test_places_have_a_size() -> None:
    assert is_near((0.0, 0.0), (0.3, 0.4), 0.5)
    assert not is_near((0.0, 0.0), (0.3, 0.5), 0.5)


@pytest.mark.parametrize(
    "side, hour, expected",
    [("after", 21, False), ("after", 22, True), ("after", 23, True), ("before", 21, True), ("before", 22, False)],
)
def test_after_and_before_a_time_of_this_day(side: str, hour: int, expected: bool) -> None:
    said = TypedArgument("time", "ten pm", time=TimeExpression("time", value="T22:00"))
    assert clock_shows(said, datetime(2026, 5, 4, hour, 30), side=side) is expected


def test_a_time_without_its_half_of_the_day() -> None:
    said = TypedArgument("time", "ten", time=TimeExpression("time", value="T10:00/T22:00"))
    assert clock_shows(said, datetime(2026, 5, 4, 22, 0, 30))
    assert clock_shows(said, datetime(2026, 5, 4, 23), side="after")
    assert clock_shows(said, datetime(2026, 5, 4, 9), side="before")
    with pytest.raises(ValueError, match="in the morning or in the evening"):
        clock_shows(said, datetime(2026, 5, 4, 15), side="after")
