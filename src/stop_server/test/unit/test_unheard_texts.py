"""Which texts nobody took."""

from roboframenet_testing import Clock
from stop_server.unheard_texts import UnheardTexts


def test_texts_that_nobody_took_are_returned_once_and_in_order() -> None:
    clock = Clock()
    texts = UnheardTexts(now=clock)
    for text in ("Ping.", "Turn left.", "Ping."):
        texts.hear(text, stamp_ns=0)
    texts.hear_taken("Ping.")
    assert texts.take_unheard(before_s=101.0) == ("Ping.", "Turn left.")
    assert texts.take_unheard(before_s=101.0) == ()


def test_text_that_was_said_later_may_still_be_taken() -> None:
    clock = Clock()
    texts = UnheardTexts(now=clock)
    texts.hear("before", stamp_ns=0)
    clock.now_s = 102.0
    texts.hear("after", stamp_ns=0)
    assert texts.take_unheard(before_s=101.0) == ("before",)
    texts.hear_taken("after")
    assert texts.take_unheard(before_s=200.0) == ()


def test_sign_may_come_before_its_text_but_not_long_before() -> None:
    clock = Clock()
    texts = UnheardTexts(now=clock)
    texts.hear_taken("Ping.")
    texts.hear("Ping.", stamp_ns=0)
    assert texts.take_unheard(before_s=200.0) == ()
    texts.hear_taken("Ping.")
    clock.now_s += 10.0
    texts.hear("Ping.", stamp_ns=0)
    assert texts.take_unheard(before_s=200.0) == ("Ping.",)


def test_long_text_that_was_cut_is_recognised() -> None:
    texts = UnheardTexts(now=Clock())
    texts.hear("a" * 5000, stamp_ns=0)
    texts.hear_taken("a" * 1000)
    assert texts.take_unheard(before_s=200.0) == ()


def test_old_and_too_many_texts_are_dropped() -> None:
    clock = Clock()
    texts = UnheardTexts(now=clock, max_kept=2)
    for text in "abc":
        texts.hear(text, stamp_ns=0)
    assert texts.take_unheard(before_s=200.0) == ("b", "c")
    texts.hear("old", stamp_ns=0)
    clock.now_s += 61.0
    assert texts.take_unheard(before_s=1000.0) == ()


def test_equal_texts_from_before_a_restart_stay_unheard_when_later_ones_are_taken_and_answered():
    now_s = 100.0
    texts = UnheardTexts(now=lambda: now_s)
    stamps = [int(1e9 * tenth / 10.0) for tenth in range(0, 24, 4)]
    for number, stamp_ns in enumerate(stamps):
        now_s = 100.0 + stamp_ns / 1e9
        texts.hear("Ping.", stamp_ns=stamp_ns)
        # The first one is taken before the command server is killed, the last two after its start.
        if number in (0, 4, 5):
            texts.hear_taken("Ping.")
    for number in (0, 4, 5):
        texts.hear_reply("Ping.", stamp_ns=stamps[number] + 3_000_000)
    assert texts.take_unheard(before_s=101.4) == ("Ping.",) * 3


def test_reply_to_a_text_that_was_not_told_as_taken_counts_for_the_one_said_at_its_time():
    texts = UnheardTexts(now=lambda: 100.0)
    for second in (1, 5):
        texts.hear("Ping.", stamp_ns=second * 10**9)
    texts.hear_reply("Ping.", stamp_ns=5 * 10**9 + 3_000_000)
    texts.hear_reply("Ping.", stamp_ns=9 * 10**9)
    assert texts.take_unheard(before_s=101.0) == ("Ping.",)


def test_text_that_is_told_as_taken_first_is_not_unheard():
    texts = UnheardTexts(now=lambda: 100.0)
    texts.hear_taken("Ping.")
    texts.hear("Ping.", stamp_ns=10**9)
    texts.hear("Ping.", stamp_ns=10**9)
    texts.hear_reply("Ping.", stamp_ns=10**9)
    assert texts.take_unheard(before_s=101.0) == ("Ping.",)
