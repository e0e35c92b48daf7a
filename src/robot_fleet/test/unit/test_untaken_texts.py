"""Which texts nobody took while the node fleet did not run."""

from typing import List

import pytest

from roboframenet_testing import Clock
from robot_fleet.untaken_texts import UntakenTexts


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def texts(clock: Clock) -> UntakenTexts:
    return UntakenTexts(now=clock)


def taken(texts: UntakenTexts, *, before_s: float = 1e9) -> List[str]:
    return [said.command_id or said.text for said in texts.take(before_s=before_s)]


def test_equal_texts_are_counted(texts: UntakenTexts, clock: Clock) -> None:
    for _ in range(3):
        texts.hear("Turn left.")
    before_s = clock.now_s + 1.0
    clock.now_s += 2.0
    texts.hear("Turn left.")
    texts.hear_taken("text-1", "Turn left.")
    assert taken(texts, before_s=before_s) == ["Turn left."] * 3
    assert taken(texts) == []


def test_what_is_told_again_counts_once(texts: UntakenTexts) -> None:
    texts.hear("Turn left.")
    texts.hear("Turn left.")
    texts.hear_taken("text-1", "Turn left.")
    texts.hear_taken("text-1", "Turn left.")
    assert taken(texts) == ["Turn left."]


def test_the_sign_may_arrive_before_the_text(texts: UntakenTexts, clock: Clock) -> None:
    texts.hear_taken("text-1", "Turn left.")
    texts.hear("Turn left.")
    assert taken(texts) == []
    texts.hear_taken("text-2", "Turn left.")
    clock.now_s += 10.0
    texts.hear("Turn left.")
    assert taken(texts) == ["Turn left."]


def test_a_goal_is_known_by_its_id(texts: UntakenTexts) -> None:
    texts.hear("Turn left.")
    texts.hear("Turn left.", "/client-1")
    texts.hear("Turn left.", "/client-2")
    texts.hear_taken("/client-1", "Turn left.")
    assert taken(texts) == ["Turn left.", "/client-2"]
