"""Stops and what the stop server says of them meet in any order."""

import pytest

from command_server.stop_book import StopBook


class Clock:
    now_s = 100.0

    def __call__(self):
        return self.now_s


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def book(clock):
    return StopBook(timeout_s=1.0, now=clock)


def say(book, command_id="mine", *, is_action=False, heard_s=None):
    return book.hear_stop(command_id, "stop", stamp_ns=7, is_action=is_action, heard_s=heard_s)


def overdue(book):
    """Carry out what is silent, and see what is overdue."""
    book.take_silent(brake_s=0.0)
    return [stop.command_id for stop in book.take_overdue()]


def test_reply_answers_the_stop_that_came_before(book, clock):
    assert say(book) is None
    assert book.hear_reply("theirs", "stop").command_id == "mine"
    clock.now_s += 5.0
    assert not overdue(book)


def test_reply_may_come_first(book):
    assert book.hear_reply("goal", "stop") is None
    assert say(book, "goal", is_action=True) == "goal"


def test_goal_takes_only_the_reply_with_its_id(book):
    assert book.hear_reply("other", "stop") is None
    assert say(book, "goal", is_action=True) is None


def test_each_of_many_stops_takes_one_reply(book, clock):
    for index in range(50):
        say(book, f"mine{index}")
    for index in range(49):
        assert book.hear_reply(f"theirs{index}", "stop") is not None
    clock.now_s += 2.0
    assert overdue(book) == ["mine49"]
    assert not overdue(book)


def test_old_reply_does_not_answer_a_new_stop(book, clock):
    book.hear_reply("theirs", "stop")
    clock.now_s += 0.6
    assert say(book) is None


def test_reply_is_early_by_the_time_at_which_the_stop_was_heard(book, clock):
    book.hear_reply("theirs", "stop")
    clock.now_s += 0.6
    assert say(book, heard_s=clock.now_s - 0.5) == "theirs"


def test_late_reply_to_a_stop_that_was_answered_here_does_not_answer_the_next_one(book, clock):
    say(book, "first")
    clock.now_s += 1.0
    assert overdue(book) == ["first"]
    assert book.hear_reply("late", "stop") is None
    assert say(book, "second") is None
    clock.now_s += 1.0
    assert overdue(book) == ["second"]


def test_late_reply_while_the_next_stop_waits_answers_one_of_them(book, clock):
    say(book, "first")
    clock.now_s += 1.0
    assert overdue(book) == ["first"]
    say(book, "second")
    assert book.hear_reply("late", "stop").command_id == "second"
    assert book.hear_reply("later", "stop") is None  # the two stops have had three answers: none is kept
    assert say(book, "third") is None


def silent(book, *, brake_s=0.5):
    return [stop.command_id for stop in book.take_silent(brake_s=brake_s)]


def test_stop_without_a_report_is_carried_out_here_once(book, clock):
    say(book)
    assert not silent(book)
    assert book.next_deadline_s() == pytest.approx(100.15)
    clock.now_s += 0.2
    (stop,) = book.take_silent(brake_s=0.5)
    assert (stop.command_id, stop.stamp_ns) == ("mine", 7)
    assert not silent(book)
    assert book.next_deadline_s() == pytest.approx(101.0)
    clock.now_s += 0.9
    assert overdue(book) == ["mine"]


@pytest.mark.parametrize("is_early", [True, False])
def test_report_confirms_and_gives_time_for_the_reply(book, clock, is_early):
    if is_early:
        assert book.hear_report("theirs", "stop") is None
        say(book)
    else:
        say(book)
        clock.now_s += 0.1
        assert book.hear_report("theirs", "stop").command_id == "mine"
    clock.now_s += 0.95
    assert not silent(book)
    assert not book.take_overdue()


def test_report_without_a_reply_is_carried_out_here_before_it_is_answered(book, clock):
    say(book)
    book.hear_report("theirs", "stop")
    clock.now_s += 1.0
    assert silent(book, brake_s=0.5) == ["mine"]
    clock.now_s += 0.4
    assert not book.take_overdue()
    clock.now_s += 0.2
    assert [stop.command_id for stop in book.take_overdue()] == ["mine"]


def test_report_of_a_stop_that_is_carried_out_here_names_it(book, clock):
    say(book)
    clock.now_s += 0.2
    assert silent(book) == ["mine"]
    assert book.hear_report("theirs", "stop").command_id == "mine"
    clock.now_s += 0.9
    assert not overdue(book)
    clock.now_s += 0.2
    assert silent(book) == ["mine"]  # the stop server has died meanwhile


def test_reports_confirm_one_stop_each(book, clock):
    say(book, "first")
    say(book, "second")
    book.hear_report("theirs", "stop")
    clock.now_s += 0.2
    assert silent(book) == ["second"]


def test_stop_server_is_not_blamed_while_this_process_does_not_run(book, clock):
    say(book)
    clock.now_s += 60.0
    book.postpone(60.0)
    assert not overdue(book)


def test_goal_without_an_id_of_its_own_is_matched_by_its_words(book):
    say(book, "made_up_here", is_action=True)
    assert book.hear_reply("made_up_there", "stop").command_id == "made_up_here"
