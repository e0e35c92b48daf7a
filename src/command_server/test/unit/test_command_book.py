"""Every command is closed exactly once."""

import random

import pytest

from command_server.command_book import (
    RESTARTED,
    STAGES,
    CommandBook,
    CommandText,
    Ending,
    Outcome,
    refusal_of_text,
    stage_after,
    stamp_after,
)


class Clock:
    def __init__(self):
        self.now_s = 100.0

    def __call__(self):
        return self.now_s


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def book(clock):
    return CommandBook(dict.fromkeys(STAGES, 2.0), now=clock)


def make_command(name, stamp_ns=0):
    return CommandText(command_id=name, stamp_ns=stamp_ns, text=f"text of {name}")


def ending(name, outcome=Outcome.DONE):
    return Ending(command=make_command(name), outcome=outcome, stage="executor", code=outcome.name, sentence="x")


def test_first_final_event_wins_and_later_ones_are_dropped(book):
    book.open(make_command("a"))
    assert book.finish(ending("a")).outcome == Outcome.DONE
    assert book.finish(ending("a", Outcome.FAILED)) is None
    assert not book.open_commands


def test_ending_of_a_command_that_nobody_opened_is_dropped(book):
    assert book.finish(ending("stranger")) is None
    assert not book.progress("stranger", "executor")


def test_reply_carries_the_command_as_it_was_opened(book):
    book.open(make_command("a", stamp_ns=5))
    assert book.finish(ending("a")).command.stamp_ns == 5


def test_same_id_twice_is_an_error(book):
    book.open(make_command("a"))
    with pytest.raises(ValueError, match="'a'"):
        book.open(make_command("a"))


@pytest.mark.parametrize(
    "passed,silent",
    [([], STAGES[0]), (STAGES[:1], STAGES[1]), (STAGES[:2], STAGES[2]), (STAGES[:4], STAGES[4]), (STAGES, STAGES[4])],
)
def test_the_silent_stage_is_named(book, clock, passed, silent):
    book.open(make_command("a"))
    for stage in passed:
        clock.now_s += 1.5
        assert not book.condemn_silent(timeout_s=1.0)
        book.progress("a", stage)
    clock.now_s += 1.99
    assert not book.condemn_silent(timeout_s=1.0)
    clock.now_s += 0.02
    (entry,) = book.condemn_silent(timeout_s=1.0)
    assert entry.may_have_started == (silent == "executor")
    assert not book.condemn_silent(timeout_s=1.0)
    end = book.finish_condemned("a", "It stands.")
    assert (end.outcome, end.code, end.stage) == (Outcome.FAILED, "STAGE_SILENT", silent)
    assert end.sentence == f"{silent} did not answer within 2 s. It stands."
    assert book.finish_condemned("a") is None


def test_condemned_command_does_not_come_back_to_life(book, clock):
    book.open(make_command("a"))
    clock.now_s += 2.0
    book.condemn_silent(timeout_s=1.0)
    assert book.progress("a", "executor")
    assert not book.overdue_condemned()
    clock.now_s += 1.0
    assert book.overdue_condemned() == ["a"]


def test_command_that_was_done_before_it_was_cancelled_is_done(book, clock):
    book.open(make_command("a"))
    clock.now_s += 2.0
    book.condemn_silent(timeout_s=1.0)
    assert book.finish(ending("a", Outcome.DONE)).outcome == Outcome.DONE


def test_executor_that_stops_a_condemned_command_does_not_answer_it(book, clock):
    book.open(make_command("a"))
    clock.now_s += 2.0
    book.condemn_silent(timeout_s=1.0)
    assert book.finish(ending("a", Outcome.SUPERSEDED)) is None
    assert book.finish_condemned("a").code == "STAGE_SILENT"


def test_command_without_a_verdict_is_not_closed_as_cancelled(book):
    book.open(make_command("a"))
    assert book.finish_condemned("a") is None
    assert book.get("a") is not None


def test_nobody_is_silent_while_this_process_does_not_run(book, clock):
    book.open(make_command("a"))
    clock.now_s += 60.0
    book.postpone(60.0)
    assert not book.condemn_silent(timeout_s=1.0)
    clock.now_s += 2.0
    assert book.condemn_silent(timeout_s=1.0)


def test_executor_keeps_a_command_alive(book, clock):
    book.open(make_command("a"))
    for _ in range(50):
        clock.now_s += 1.0
        book.progress("a", "executor")
        assert not book.condemn_silent(timeout_s=1.0)
    assert book.get("a").is_with_executor


def test_late_event_of_an_earlier_stage_changes_nothing(book, clock):
    book.open(make_command("a"))
    book.progress("a", "arbitrator")
    before = book.get("a")
    clock.now_s += 1.0
    assert book.progress("a", "stanford_parser_ros")
    assert book.get("a") == before
    assert not before.is_with_executor


def test_event_of_a_stranger_does_not_prolong(book):
    book.open(make_command("a"))
    before = book.get("a")
    assert not book.progress("a", "somebody_else")
    assert book.get("a") == before


def test_stop_ends_what_was_said_before_it_and_nothing_later(book):
    for name, stamp_ns in (("before", 10), ("same", 20), ("later", 21)):
        book.open(make_command(name, stamp_ns))
    ends = book.finish_stopped(20)
    assert [end.command.command_id for end in ends] == ["before", "same"]
    assert {(end.outcome, end.code) for end in ends} == {(Outcome.SUPERSEDED, "STOPPED")}
    assert [entry.command.command_id for entry in book.open_commands] == ["later"]


def test_next_deadline(book, clock):
    assert book.next_deadline_s() is None
    book.open(make_command("a"))
    clock.now_s += 1.0
    book.open(make_command("b"))
    assert book.next_deadline_s() == 102.0


@pytest.mark.parametrize("text,code", [("", "EMPTY_TEXT"), (" \t\n", "EMPTY_TEXT"), ("x" * 11, "TEXT_TOO_LONG")])
def test_texts_that_are_no_commands(text, code):
    found, sentence = refusal_of_text(text, max_length=10)
    assert found == code and sentence


def test_text_of_the_greatest_length_passes():
    assert refusal_of_text("x" * 10, max_length=10) is None


def test_command_of_the_last_run_is_cancelled_and_answered(book, clock):
    book.adopt(make_command("a"), timeout_s=3.0)
    assert book.get("a").may_have_started
    clock.now_s += 2.9
    assert not book.condemn_silent(timeout_s=1.0)
    assert not book.overdue_condemned()
    clock.now_s += 0.2
    assert book.overdue_condemned() == ["a"]
    end = book.finish_condemned("a", "It stands.")
    assert (end.code, end.outcome) == ("RESTARTED", Outcome.FAILED)
    assert end.sentence == f"{RESTARTED.sentence} It stands."


def test_stage_after():
    assert [stage_after(stage) for stage in STAGES] == list(STAGES[1:]) + [STAGES[-1]]


def test_any_order_of_events_gives_one_reply_each(clock):
    for seed in range(200):
        lots = random.Random(seed)
        book = CommandBook(dict.fromkeys(STAGES, 2.0), now=clock)
        replies = []
        names = [f"c{index}" for index in range(5)]
        for stamp_ns, name in enumerate(names):
            book.open(make_command(name, stamp_ns))
        for _ in range(40):
            step, name = lots.randrange(4), lots.choice(names)
            if step == 0:
                end = book.finish(ending(name, lots.choice(list(Outcome))))
                replies += [end] if end else []
            elif step == 1:
                book.progress(name, lots.choice(STAGES))
            elif step == 2:
                clock.now_s += lots.random()
                book.condemn_silent(timeout_s=1.0)
                replies += filter(None, [book.finish_condemned(name)])
            elif lots.random() < 0.1:
                replies += book.finish_stopped(lots.randrange(5))
        clock.now_s += 10.0
        book.condemn_silent(timeout_s=1.0)
        replies += filter(None, [book.finish_condemned(entry.command.command_id) for entry in book.open_commands])
        assert sorted(end.command.command_id for end in replies) == names, f"seed {seed}"


@pytest.mark.parametrize(
    "arrival_ns,last_ns,stamp_ns",
    [(5, 0, 5), (5, 5, 6), (4, 5, 6), (0, 10_000_000_000, 0), (9_500_000_000, 10_000_000_000, 10_000_000_001)],
)
def test_stamps_of_commands_grow_unless_the_clock_is_set_back(arrival_ns, last_ns, stamp_ns):
    assert stamp_after(arrival_ns, last_ns) == stamp_ns
