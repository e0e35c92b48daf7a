"""One cry that comes on two ways."""

import pytest

from stop_server.heard_once import HeardOnce


class Clock:
    def __init__(self):
        self.now_s = 0.0

    def __call__(self):
        return self.now_s


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def heard(clock):
    return HeardOnce(now=clock)


def test_a_goal_counts_once_whichever_way_is_first(heard):
    assert heard.hears("Stop.", is_goal=True, command_id="a")
    assert not heard.is_told("Stop.", is_goal=True, command_id="a")
    assert heard.is_told("Stop.", is_goal=True, command_id="b")
    assert not heard.hears("Stop.", is_goal=True, command_id="b")


def test_a_goal_that_this_node_missed_is_new(heard):
    assert heard.hears("Stop.", is_goal=True, command_id="a")
    assert heard.is_told("Stop.", is_goal=True, command_id="b")


def test_each_of_two_equal_texts_counts(heard):
    assert heard.hears("Stop.", is_goal=False)
    assert heard.hears("Stop.", is_goal=False)
    assert not heard.is_told("Stop.", is_goal=False, command_id="text-1")
    assert not heard.is_told("Stop.", is_goal=False, command_id="text-2")
    assert heard.is_told("Stop.", is_goal=False, command_id="text-3")


def test_a_goal_without_an_id_is_no_text(heard):
    assert heard.hears("Stop.", is_goal=True)
    assert heard.is_told("Stop.", is_goal=False, command_id="text-1")
    assert not heard.is_told("Stop.", is_goal=True, command_id="made-by-actionlib")
    assert heard.is_told("Halt.", is_goal=True, command_id="made-too")
    assert not heard.hears("Halt.", is_goal=True)


def test_what_a_dead_command_server_never_told_is_forgotten(heard, clock):
    heard.hears("Stop.", is_goal=False)
    heard.forget()
    assert heard.is_told("Stop.", is_goal=False, command_id="text-1")
    heard.hears("Halt.", is_goal=False)
    clock.now_s = 61.0
    assert heard.is_told("Halt.", is_goal=False, command_id="text-2")
