"""A goal is an orphan when its client listened to its server, and does so no more."""

from typing import Set

import pytest

from roboframenet_ros.orphaned_goals import OrphanWatch


@pytest.fixture
def listening() -> Set[str]:
    return {"/executor"}


@pytest.fixture
def watch(listening: Set[str]) -> OrphanWatch:
    return OrphanWatch(lambda client: client in listening)


def test_goal_of_a_client_that_dies_is_an_orphan(watch: OrphanWatch, listening: Set[str]) -> None:
    watch.note("one", "/executor")
    watch.note("two", "/page")
    assert watch.orphans(["one", "two"]) == []
    listening.clear()
    assert watch.orphans(["one", "two"]) == ["one"]
    # Until it is over, whoever asks.
    assert watch.orphans(["one", "two"]) == ["one"]


def test_goal_of_who_never_listens_is_none(watch: OrphanWatch) -> None:
    watch.note("one", "/rostopic")
    assert watch.orphans(["one"]) == watch.orphans(["one"]) == []


def test_client_that_listens_late_is_seen(watch: OrphanWatch, listening: Set[str]) -> None:
    watch.note("one", "/late")
    assert watch.orphans(["one"]) == []
    listening.add("/late")
    assert watch.orphans(["one"]) == []
    listening.remove("/late")
    assert watch.orphans(["one"]) == ["one"]


def test_client_that_left_between_two_goals_may_come_back(watch: OrphanWatch, listening: Set[str]) -> None:
    watch.note("one", "/executor")
    assert watch.orphans(["one"]) == []
    assert watch.orphans([]) == []
    listening.clear()
    watch.note("two", "/executor")
    assert watch.orphans(["two"]) == []
    listening.add("/executor")
    assert watch.orphans(["two"]) == []


def test_goals_of_nobody_are_none(watch: OrphanWatch) -> None:
    assert watch.orphans(["unknown"]) == []
