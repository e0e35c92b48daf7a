"""Times of the clock in words: what each means, what must be asked, and what is none."""

import pytest

from utterance_passes.phrases.clock_times import clock_time_at

DAY_S = 86_400.0
TODAY, TOMORROW = {"offset_s": 1.0}, {"offset_s": DAY_S}
DAILY, WEEKLY = {"period_s": DAY_S}, {"period_s": 7 * DAY_S}


@pytest.mark.parametrize(
    ("words", "value", "others"),
    [
        ("at eight", "T08:00/T20:00", {}),
        ("at 8", "T08:00/T20:00", {}),
        ("at twelve", "T00:00/T12:00", {}),
        ("at 8 o'clock", "T08:00/T20:00", {}),
        ("eight o'clock", "T08:00/T20:00", {}),
        ("at noon", "T12:00", {}),
        ("at midnight", "T00:00", {}),
        ("at 8:30 pm", "T20:30", {}),
        ("at 8:30pm", "T20:30", {}),
        ("8 p.m.", "T20:00", {}),
        ("at 12 am", "T00:00", {}),
        ("at 12 pm", "T12:00", {}),
        ("at 20:00", "T20:00", {}),
        ("at 18 30", "T18:30", {}),
        ("at 08 15", "T08:15", {}),
        ("at seven forty - five", "T07:45/T19:45", {}),
        ("at seven forty five", "T07:45/T19:45", {}),
        ("at twenty forty five", "T20:45", {}),
        ("at six oh five", "T06:05/T18:05", {}),
        ("at 9am", "T09:00", {}),
        ("at 08:15", "T08:15", {}),
        ("at 8:15", "T08:15/T20:15", {}),
        ("at fifteen", "T15:00", {}),
        ("at eight thirty", "T08:30/T20:30", {}),
        ("at half past eight", "T08:30/T20:30", {}),
        ("at quarter past eight in the evening", "T20:15", {}),
        ("at a quarter to nine", "T08:45/T20:45", {}),
        ("at ten minutes to one", "T00:50/T12:50", {}),
        ("at ten past noon", "T12:10", {}),
        ("at five to midnight", "T23:55", {}),
        ("at eight in the morning", "T08:00", {}),
        ("in the morning at eight", "T08:00", {}),
        ("at three in the afternoon", "T15:00", {}),
        ("at ten at night", "T22:00", {}),
        ("at two at night", "T02:00", {}),
        ("today at eight", "T08:00/T20:00", TODAY),
        ("tonight at eight", "T20:00", TODAY),
        ("at eight tonight", "T20:00", TODAY),
        ("this evening at eight", "T20:00", TODAY),
        ("at nine this morning", "T09:00", TODAY),
        ("tomorrow at nine", "T09:00", TOMORROW),
        ("at nine tomorrow", "T09:00", TOMORROW),
        ("tomorrow morning at six", "T06:00", TOMORROW),
        ("tomorrow at noon", "T12:00", TOMORROW),
        ("tomorrow at 15:30", "T15:30", TOMORROW),
        ("on monday at nine", "XXXX-WXX-1T09:00", {}),
        ("at nine on sunday", "XXXX-WXX-7T09:00", {}),
        ("every day at seven", "T07:00", DAILY),
        ("at seven every day", "T07:00", DAILY),
        ("daily at noon", "T12:00", DAILY),
        ("every morning at nine", "T09:00", DAILY),
        ("every evening at half past six", "T18:30", DAILY),
        ("every night at ten", "T22:00", DAILY),
        ("every monday at eight", "XXXX-WXX-1T08:00", WEEKLY),
        ("on mondays at eight", "XXXX-WXX-1T08:00", WEEKLY),
        ("every friday evening at six", "XXXX-WXX-5T18:00", WEEKLY),
        ("every weekday at seven", "XXXX-WXX-12345T07:00", DAILY),
        ("on weekdays at seven", "XXXX-WXX-12345T07:00", DAILY),
    ],
)
def test_time_of_the_clock(words, value, others):
    found = clock_time_at(words.split())
    assert found is not None
    assert found.when is not None, found.question
    assert (found.when.words, found.when.value) == (words, value)
    assert {name: getattr(found.when, name) for name in ("offset_s", "period_s") if getattr(found.when, name)} == others
    assert found.length == len(words.split())


@pytest.mark.parametrize(
    ("words", "question"),
    [
        ("tomorrow", "At what time tomorrow?"),
        ("tonight", "At what time tonight?"),
        ("every morning", "At what time every morning?"),
        ("on monday", "At what time on monday?"),
        ("tomorrow at three", "At 3:00 or at 15:00?"),
        ("every day at half past five", "At 5:30 or at 17:30?"),
    ],
)
def test_time_that_is_open_is_asked_about(words, question):
    found = clock_time_at(words.split())
    assert found is not None
    assert found.when is None
    assert found.question.startswith(question)


@pytest.mark.parametrize(
    "words",
    [
        "eight",
        "at the door",
        "five metres",
        "in five minutes",
        "every ten minutes",
        "at",
        "25:00",
        "at 8:75",
        "in the hall",
    ],
)
def test_other_words_are_no_time(words):
    assert clock_time_at(words.split()) is None


def test_time_ends_where_other_words_begin():
    found = clock_time_at("at eight go to the kitchen".split())
    assert found is not None
    assert found.length == 2


@pytest.mark.parametrize(
    ("words", "length"),
    [
        ("around noon", 2),
        ("at about six", 3),
        ("about half past six and go", 4),
        ("around at noon", 0),
        ("about six", 0),
    ],
)
def test_time_that_is_not_meant_exactly(words: str, length: int) -> None:
    found = clock_time_at(words.split())
    assert (found.length if found is not None else 0) == length
