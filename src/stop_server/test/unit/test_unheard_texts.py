"""Which texts nobody took."""

from roboframenet_testing import Clock
from stop_server.unheard_texts import UnheardTexts


def test_texts_that_nobody_took_are_returned_once_and_in_order() -> None:
    clock = Clock()
    texts = UnheardTexts(now=clock)
    for text in ("Ping.", "Turn left.", "Ping."):
        texts.hear(text)
    texts.hear_taken("Ping.")
    assert texts.take_unheard(before_s=101.0) == ("Turn left.", "Ping.")
    assert texts.take_unheard(before_s=101.0) == ()


def test_text_that_was_said_later_may_still_be_taken() -> None:
    clock = Clock()
    texts = UnheardTexts(now=clock)
    texts.hear("before")
    clock.now_s = 102.0
    texts.hear("after")
    assert texts.take_unheard(before_s=101.0) == ("before",)
    texts.hear_taken("after")
    assert texts.take_unheard(before_s=200.0) == ()


def test_sign_may_come_before_its_text_but_not_long_before() -> None:
    clock = Clock()
    texts = UnheardTexts(now=clock)
    texts.hear_taken("Ping.")
    texts.hear("Ping.")
    assert texts.take_unheard(before_s=200.0) == ()
    texts.hear_taken("Ping.")
    clock.now_s += 10.0
    texts.hear("Ping.")
    assert texts.take_unheard(before_s=200.0) == ("Ping.",)


def test_long_text_that_was_cut_is_recognised() -> None:
    texts = UnheardTexts(now=Clock())
    texts.hear("a" * 5000)
    texts.hear_taken("a" * 1000)
    assert texts.take_unheard(before_s=200.0) == ()


def test_old_and_too_many_texts_are_dropped() -> None:
    clock = Clock()
    texts = UnheardTexts(now=clock, max_kept=2)
    for text in "abc":
        texts.hear(text)
    assert texts.take_unheard(before_s=200.0) == ("b", "c")
    texts.hear("old")
    clock.now_s += 61.0
    assert texts.take_unheard(before_s=1000.0) == ()
