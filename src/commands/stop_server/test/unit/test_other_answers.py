"""Stops that were answered elsewhere."""

import pytest

from roboframenet_testing import Clock
from stop_server.other_answers import OtherAnswers


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def others(clock):
    return OtherAnswers(now=clock)


SECOND_NS = 1_000_000_000
SAID_NS = 50 * SECOND_NS


def take(others, command_id="", text="Stop.", *, after_ns=0, is_just_awake=False):
    return others.take(command_id, text, stamp_ns=SAID_NS + after_ns, is_just_awake=is_just_awake)


def test_each_answer_counts_for_one_stop_with_its_words(others):
    others.note("text-1", "Stop.", stamp_ns=SAID_NS)
    assert not take(others, text="Halt!")
    assert take(others)
    assert not take(others)


def test_stop_that_came_as_a_goal_is_known_by_its_id(others):
    others.note("goal-1", "Stop.", stamp_ns=SAID_NS)
    assert not take(others, "goal-2")
    assert take(others, "goal-1", after_ns=9 * SECOND_NS)


@pytest.mark.parametrize(
    "after_ns, is_just_awake, is_meant",
    [
        (SECOND_NS // 3, False, True),
        (-SECOND_NS // 3, False, True),
        (2 * SECOND_NS, False, False),
        (2 * SECOND_NS, True, True),
    ],
)
def test_answer_to_another_utterance_counts_only_for_a_server_that_was_suspended(
    others, after_ns, is_just_awake, is_meant
):
    others.note("text-1", "Stop.", stamp_ns=SAID_NS)
    assert take(others, after_ns=after_ns, is_just_awake=is_just_awake) == is_meant


def test_answers_are_forgotten(clock, others):
    others.note("text-1", "Stop.", stamp_ns=SAID_NS)
    clock.now_s += 31.0
    assert not take(others)
