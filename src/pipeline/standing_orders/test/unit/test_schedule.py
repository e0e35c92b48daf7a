"""Times of the clock and spans of time: what is due when, in time zones that change."""

from datetime import datetime, time

import pytest
from dateutil import tz
from hypothesis import given
from hypothesis import strategies as st

from standing_orders.schedule import (
    After,
    Daily,
    Every,
    NoSchedule,
    Once,
    moved,
    next_due_s,
    schedule_of,
    utc_s,
    zone_of,
)
from typed_arguments import TimeExpression

BERLIN = zone_of("Europe/Berlin")
DAY_S = 86_400.0


def at(text: str, zone=BERLIN) -> float:
    return utc_s(datetime.fromisoformat(text), zone)


#: A Sunday.
NOW_S = at("2026-11-22T10:00")


def time_of(value="", **others) -> TimeExpression:
    return TimeExpression("time", "then", value=value, **others)


@pytest.mark.parametrize(
    ("when", "schedule"),
    [
        (time_of("T20:00"), Once(datetime(2026, 11, 22, 20))),
        (time_of("T08:00"), Once(datetime(2026, 11, 23, 8))),
        (time_of("T08:00/T20:00"), Once(datetime(2026, 11, 22, 20))),
        (time_of("T10:00/T22:00"), Once(datetime(2026, 11, 22, 22))),
        (time_of("T11:30/T23:30"), Once(datetime(2026, 11, 22, 11, 30))),
        (time_of("T09:00", offset_s=DAY_S), Once(datetime(2026, 11, 23, 9))),
        (time_of("2026-12-24T18:00"), Once(datetime(2026, 12, 24, 18))),
        (time_of("XXXX-WXX-1T09:00"), Once(datetime(2026, 11, 23, 9))),
        (time_of("XXXX-WXX-7T09:00"), Once(datetime(2026, 11, 29, 9))),
        (time_of("XXXX-WXX-7T11:00"), Once(datetime(2026, 11, 22, 11))),
        (time_of("PT5M", offset_s=300.0), After(NOW_S + 300.0)),
        (time_of("PT10M", period_s=600.0), Every(NOW_S + 600.0, 600.0)),
        (time_of("T07:00", period_s=DAY_S), Daily(time(7))),
        (time_of("XXXX-WXX-1T07:00", period_s=7 * DAY_S), Daily(time(7), (0,))),
        (time_of("XXXX-WXX-12345T07:00", period_s=DAY_S), Daily(time(7), (0, 1, 2, 3, 4))),
    ],
)
def test_schedule_of_what_was_said(when, schedule):
    assert schedule_of(when, NOW_S, BERLIN) == schedule


@pytest.mark.parametrize(
    ("when", "reason"),
    [
        (time_of("2026-11-21T09:00"), "That is over: it is 10:00 now."),
        (time_of("T09:00", offset_s=-DAY_S), "That is over"),
        (time_of("2030-01-01T09:00"), "too far away"),
        (time_of("PT5M", offset_s=1e9), "too far away"),
        (time_of("PT5M", offset_s=-300.0), "I do not understand"),
        (time_of("PT1S", period_s=1.0), "more often than every 10 seconds"),
        (time_of("T25:00"), "I do not understand"),
        (time_of("T07:00", period_s=7 * DAY_S), "I do not understand"),
        (time_of(""), "I do not understand"),
    ],
)
def test_what_is_no_schedule_is_refused(when, reason):
    with pytest.raises(NoSchedule, match=reason):
        schedule_of(when, NOW_S, BERLIN)


@pytest.mark.parametrize(
    ("schedule", "after", "due"),
    [
        (Daily(time(7)), "2026-11-22T06:59", "2026-11-22T07:00"),
        (Daily(time(7)), "2026-11-22T07:00", "2026-11-23T07:00"),
        (Daily(time(7), (0, 2)), "2026-11-23T07:00", "2026-11-25T07:00"),
        (Daily(time(7), (2,)), "2026-11-25T07:00", "2026-12-02T07:00"),
        # The clock goes forward: 2:30 does not exist, and the night is an hour shorter.
        (Daily(time(2, 30)), "2026-03-28T12:00", "2026-03-29T03:30"),
        (Daily(time(7)), "2026-03-28T07:00", "2026-03-29T07:00"),
        # The clock goes back: the first 2:30 is meant, and it comes only once.
        (Daily(time(2, 30)), "2026-10-24T12:00", "2026-10-25T02:30"),
        (Daily(time(2, 30)), "2026-10-25T02:30", "2026-10-26T02:30"),
        (Once(datetime(2026, 11, 22, 20)), "2026-11-22T10:00", "2026-11-22T20:00"),
    ],
)
def test_next_time_of_the_clock(schedule, after, due):
    assert next_due_s(schedule, at(after), BERLIN) == at(due)


def test_same_clock_in_another_zone_is_another_moment():
    once = Once(datetime(2026, 11, 22, 20))
    assert next_due_s(once, NOW_S, zone_of("America/New_York")) == next_due_s(once, NOW_S, BERLIN) + 6 * 3600.0
    assert next_due_s(once, at("2026-11-22T20:00"), BERLIN) is None


@given(st.floats(0.0, 4e9), st.integers(0, 86_399), st.sampled_from(["Europe/Berlin", "Asia/Kolkata", "Pacific/Apia"]))
def test_daily_order_is_due_within_two_days_at_its_time(after_s, second, name):
    daily = Daily(time(second // 3600, second // 60 % 60, second % 60))
    due_s = next_due_s(daily, after_s, zone_of(name))
    # Apia left out a day, and clocks are set by an hour.
    assert after_s < due_s <= after_s + 2 * DAY_S + 3600.0
    shown = datetime.fromtimestamp(due_s, zone_of(name)).replace(tzinfo=None)
    assert tz.resolve_imaginary(datetime.combine(shown, daily.at).replace(tzinfo=zone_of(name))).hour == shown.hour


@given(st.floats(10.0, 1e6), st.floats(0.0, 1e8))
def test_period_goes_on_in_its_rhythm(period_s, away_s):
    due_s = next_due_s(Every(1e9, period_s), 1e9 + away_s, BERLIN)
    assert 1e9 + away_s < due_s <= 1e9 + away_s + period_s * (1 + 1e-6)


def test_span_of_time_moves_with_the_clock_and_a_time_of_the_clock_does_not():
    assert moved(After(100.0), 50.0) == After(150.0)
    assert moved(Every(100.0, 10.0), -50.0) == Every(50.0, 10.0)
    assert moved(Daily(time(7)), 50.0) == Daily(time(7))


def test_unknown_zone_is_an_error():
    with pytest.raises(ValueError, match="no time zone is called 'Nowhere'"):
        zone_of("Nowhere")
