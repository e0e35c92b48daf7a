"""Stops that were answered elsewhere."""
import pytest

from stop_server.other_answers import OtherAnswers


class Clock:
    def __init__(self):
        self.now_s = 100.0

    def __call__(self):
        return self.now_s


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def others(clock):
    return OtherAnswers(now=clock)


def test_each_answer_counts_for_one_stop_with_its_words(clock, others):
    others.note("text-1", "Stop.")
    assert not others.take("", "Halt!", heard_s=clock.now_s)
    assert others.take("", "Stop.", heard_s=clock.now_s)
    assert not others.take("", "Stop.", heard_s=clock.now_s)


def test_stop_that_came_as_a_goal_is_known_by_its_id(clock, others):
    others.note("goal-1", "Stop.")
    assert not others.take("goal-2", "Stop.", heard_s=clock.now_s)
    assert others.take("goal-1", "Stop.", heard_s=clock.now_s)


@pytest.mark.parametrize("after_s, is_meant", [(-2.0, True), (0.2, True), (0.3, False)])
def test_answer_from_before_the_stop_is_for_another_one(clock, others, after_s, is_meant):
    others.note("text-1", "Stop.")
    assert others.take("", "Stop.", heard_s=clock.now_s + after_s) == is_meant


def test_answers_are_forgotten(clock, others):
    others.note("text-1", "Stop.")
    heard_s = clock.now_s
    clock.now_s += 31.0
    assert not others.take("", "Stop.", heard_s=heard_s)
