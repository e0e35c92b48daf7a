"""Which texts nobody took while the node that takes them did not run."""

from typing import List

import pytest

from roboframenet_ros.untaken_texts import RosTimes, Taken, UntakenTexts
from roboframenet_testing import Clock


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def texts(clock: Clock) -> UntakenTexts:
    return UntakenTexts(now=clock)


def untaken(texts: UntakenTexts, *, before_s: float = 1e9) -> List[str]:
    return [said.command_id or said.text for said in texts.take(before_s=before_s)]


def test_texts_that_nobody_took_are_returned_once_and_in_order(texts: UntakenTexts) -> None:
    for text in ("Ping.", "Turn left.", "Ping."):
        texts.hear(text, ros_s=0.0)
    texts.hear_taken(Taken("text-1", 0.0, "Ping."))
    assert sorted(untaken(texts)) == ["Ping.", "Turn left."]
    assert untaken(texts) == []
    for text in ("first", "second", "third"):
        texts.hear(text, ros_s=0.0)
    assert untaken(texts) == ["first", "second", "third"]


def test_text_that_was_said_later_may_still_be_taken(texts: UntakenTexts, clock: Clock) -> None:
    texts.hear("before", ros_s=0.0)
    clock.now_s += 2.0
    texts.hear("after", ros_s=0.0)
    assert untaken(texts, before_s=clock.now_s - 1.0) == ["before"]
    texts.hear_taken(Taken("text-1", 0.0, "after"))
    assert untaken(texts) == []


def test_equal_texts_are_counted(texts: UntakenTexts, clock: Clock) -> None:
    for _ in range(3):
        texts.hear("Turn left.", ros_s=0.0)
    before_s = clock.now_s + 1.0
    clock.now_s += 2.0
    texts.hear("Turn left.", ros_s=0.0)
    texts.hear_taken(Taken("text-1", 0.0, "Turn left."))
    assert untaken(texts, before_s=before_s) == ["Turn left."] * 3
    assert untaken(texts) == []


def test_equal_texts_from_before_a_restart_stay_when_later_ones_are_taken_and_answered(
    texts: UntakenTexts, clock: Clock
) -> None:
    begin_s = clock.now_s
    for number in range(6):
        clock.now_s = begin_s + 0.4 * number
        texts.hear("Ping.", ros_s=0.0)
        # The first one is taken before the command server is killed, the last two after its start.
        if number in (0, 4, 5):
            texts.hear_taken(Taken(f"text-{number}", 0.0, "Ping."))
    for number in (0, 4, 5):
        texts.hear_taken(Taken(f"text-{number}", clock.now_s - begin_s - 0.4 * number, "Ping."))
    assert untaken(texts, before_s=begin_s + 1.4) == ["Ping."] * 3


def test_what_is_told_again_counts_once(texts: UntakenTexts) -> None:
    texts.hear("Turn left.", ros_s=0.0)
    texts.hear("Turn left.", ros_s=0.0)
    texts.hear_taken(Taken("text-1", 0.0, "Turn left."))
    texts.hear_taken(Taken("text-1", 0.0, "Turn left."))
    assert untaken(texts) == ["Turn left."]


def test_what_is_told_late_counts_for_the_text_of_its_time(texts: UntakenTexts, clock: Clock) -> None:
    texts.hear("Ping.", ros_s=0.0)
    clock.now_s += 4.0
    texts.hear("Ping.", ros_s=0.0)
    before_s = clock.now_s
    clock.now_s += 10.0
    texts.hear_taken(Taken("text-1", 14.1, "Ping."))
    assert untaken(texts, before_s=before_s) == []
    assert untaken(texts) == ["Ping."]


def test_sign_of_a_text_that_was_not_heard_here_counts_for_no_other(texts: UntakenTexts, clock: Clock) -> None:
    texts.hear("Ping.", ros_s=0.0)
    clock.now_s += 5.0
    texts.hear_taken(Taken("text-1", 0.0, "Ping."))
    texts.hear_taken(Taken("text-2", 40.0, "Ping."))
    assert untaken(texts) == ["Ping."]


def test_sign_may_come_before_its_text_but_not_long_before(texts: UntakenTexts, clock: Clock) -> None:
    texts.hear_taken(Taken("text-1", 0.0, "Ping."))
    texts.hear("Ping.", ros_s=0.0)
    texts.hear("Ping.", ros_s=0.0)
    texts.hear_taken(Taken("text-1", 0.0, "Ping."))
    assert untaken(texts) == ["Ping."]
    texts.hear_taken(Taken("text-2", 0.0, "Ping."))
    clock.now_s += 10.0
    texts.hear("Ping.", ros_s=0.0)
    assert untaken(texts) == ["Ping."]


def test_goal_is_known_by_its_id(texts: UntakenTexts, clock: Clock) -> None:
    texts.hear("Turn left.", ros_s=0.0)
    texts.hear("Turn left.", "/client-1", ros_s=0.0)
    texts.hear("Turn left.", "/client-2", ros_s=0.0)
    clock.now_s += 10.0
    texts.hear_taken(Taken("/client-1", 0.0, "Turn left."))
    texts.hear("Turn left.", "/client-1", ros_s=0.0)
    assert untaken(texts) == ["Turn left.", "/client-2"]


def test_long_text_that_was_cut_is_recognised(texts: UntakenTexts) -> None:
    texts.hear("a" * 5000, ros_s=0.0)
    texts.hear_taken(Taken("text-1", 0.0, "a" * 1000))
    assert untaken(texts) == []


def test_old_and_too_many_texts_are_dropped(clock: Clock) -> None:
    texts = UntakenTexts(now=clock, most=2)
    for text in "abc":
        texts.hear(text, ros_s=0.0)
    assert untaken(texts) == ["b", "c"]
    texts.hear("old", ros_s=0.0)
    clock.now_s += 61.0
    assert untaken(texts) == []


@pytest.mark.parametrize("rate", [1.0, 6.0, 0.5])
def test_answer_counts_for_the_text_of_its_time_at_each_rate_of_the_clock(
    texts: UntakenTexts, clock: Clock, rate: float
) -> None:
    begin_s = clock.now_s
    for _ in range(3):
        texts.hear("Ping.", ros_s=rate * clock.now_s)
        clock.now_s += 3.0
    # The second one is answered after seven seconds; its stamp is that of the command server, a little later.
    clock.now_s += 1.0
    stamp_s = rate * (begin_s + 3.1)
    texts.hear_answered("text-2", "Ping.", stamp_s=stamp_s, ros_s=rate * clock.now_s)
    assert [said.heard_s - begin_s for said in texts.take(before_s=1e9)] == [0.0, 6.0]


def test_answer_of_a_text_that_was_heard_while_the_clock_stood_counts_for_it(texts: UntakenTexts, clock: Clock) -> None:
    texts.hear("Ping.", ros_s=5.0)
    clock.now_s += 20.0
    texts.hear("Turn left.", ros_s=5.0)
    clock.now_s += 20.0
    texts.hear_answered("text-2", "Turn left.", stamp_s=5.0, ros_s=5.0)
    assert untaken(texts) == ["Ping."]


@pytest.mark.parametrize(
    "stamp_s, age_s",
    [(100.0, 10.0), (130.0, 5.0), (154.0, 1.0), (160.0, 0.0), (40.0, 20.0)],
)
def test_age_of_a_time_on_a_clock_that_runs_six_times_as_fast(clock: Clock, stamp_s: float, age_s: float) -> None:
    times = RosTimes(now=clock)
    times.note(100.0)
    clock.now_s += 10.0
    assert times.age_s(stamp_s, ros_s=160.0) == pytest.approx(age_s)


def test_age_of_a_time_that_a_clock_that_was_set_back_has_had_twice(clock: Clock) -> None:
    times = RosTimes(now=clock)
    for ros_s in (100.0, 110.0, 0.0, 10.0, 100.0, 105.0):
        times.note(ros_s)
        clock.now_s += 10.0
    assert times.age_s(102.5, ros_s=115.0) == pytest.approx(15.0)
    assert times.age_s(5.0, ros_s=115.0) == pytest.approx(35.0)


@pytest.mark.parametrize("text", ["Turn left.", "", "  two  blanks ", "a" * 500])
def test_sign_is_one_line_and_back(text: str) -> None:
    sign = Taken.of_line(Taken("text-1", 1.25, text).line())
    assert sign == Taken("text-1", 1.25, text[:200])


@pytest.mark.parametrize("line", ["", "text-1", "text-1 soon Ping."])
def test_what_is_no_sign_is_an_error(line: str) -> None:
    with pytest.raises(ValueError):
        Taken.of_line(line)
