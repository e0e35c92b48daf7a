"""Stops and their reports meet in any order."""
import pytest

from command_server.stop_book import StopBook


class Clock:
    now_s = 0.0

    def __call__(self):
        return self.now_s


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def book(clock):
    return StopBook(timeout_s=1.0, now=clock)


def test_report_answers_the_stop_that_came_before(book, clock):
    assert book.hear_stop("mine", "stop", is_action=False) is None
    assert book.hear_report("theirs", "stop").command_id == "mine"
    clock.now_s = 5.0
    assert not book.take_overdue()


def test_report_may_come_first(book):
    assert book.hear_report("goal", "stop") is None
    assert book.hear_stop("goal", "stop", is_action=True) == "goal"


def test_goal_takes_only_the_report_with_its_id(book):
    assert book.hear_report("other", "stop") is None
    assert book.hear_stop("goal", "stop", is_action=True) is None


def test_each_of_many_stops_takes_one_report(book, clock):
    for index in range(50):
        book.hear_stop(f"mine{index}", "stop", is_action=False)
    for index in range(49):
        assert book.hear_report(f"theirs{index}", "stop") is not None
    clock.now_s = 2.0
    assert [stop.command_id for stop in book.take_overdue()] == ["mine49"]
    assert not book.take_overdue()


def test_old_report_does_not_answer_a_new_stop(book, clock):
    book.hear_report("theirs", "stop")
    clock.now_s = 1.5
    assert not book.take_overdue()
    assert book.hear_stop("mine", "stop", is_action=False) is None


def test_goal_without_an_id_of_its_own_is_matched_by_its_words(book):
    book.hear_stop("made_up_here", "stop", is_action=True)
    assert book.hear_report("made_up_there", "stop").command_id == "made_up_here"
