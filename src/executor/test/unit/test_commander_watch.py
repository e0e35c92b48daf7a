"""A commander is lost when it was there, and stays away."""

import pytest

from executor.commander_watch import CommanderWatch
from roboframenet_testing import Clock


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def watch(clock):
    return CommanderWatch(clock)


def test_who_was_never_there_is_not_lost(watch, clock):
    for _ in range(5):
        assert not watch.is_lost(False)
        clock.now_s += 10.0


def test_who_dies_is_lost_once(watch, clock):
    assert not watch.is_lost(True)
    assert not watch.is_lost(False)
    clock.now_s += 0.5
    assert watch.is_lost(False)
    clock.now_s += 10.0
    assert not watch.is_lost(False)


def test_who_is_back_at_once_is_not_lost(watch, clock):
    assert not watch.is_lost(True)
    assert not watch.is_lost(False)
    clock.now_s += 0.1
    assert not watch.is_lost(True)
    clock.now_s += 10.0
    assert not watch.is_lost(False)


def test_who_comes_back_may_be_lost_again(watch, clock):
    for _ in range(2):
        assert not watch.is_lost(True)
        assert not watch.is_lost(False)
        clock.now_s += 0.5
        assert watch.is_lost(False)
