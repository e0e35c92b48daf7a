"""Servers that are missing are waited for once, all at the same time."""

from executor.absences import Absences
from roboframenet_testing import Clock

WAIT_S = 5.0


def test_all_that_are_missing_share_one_wait() -> None:
    clock = Clock()
    absences = Absences(now=clock)
    absences.note({"first", "second"})
    assert absences.left_s("first", WAIT_S) == WAIT_S
    clock.now_s += WAIT_S
    absences.note({"first", "second", "third"})
    assert [absences.left_s(name, WAIT_S) for name in ("first", "second", "third")] == [0.0, 0.0, WAIT_S]


def test_server_of_which_nothing_is_known_is_waited_for() -> None:
    absences = Absences(now=Clock())
    assert not absences.is_missing("unknown")
    assert absences.left_s("unknown", WAIT_S) == WAIT_S


def test_server_that_was_seen_again_is_waited_for_again() -> None:
    clock = Clock()
    absences = Absences(now=clock)
    absences.note({"one"})
    clock.now_s += 60.0
    absences.forget(["one", "another"])
    assert not absences.is_missing("one")
    absences.note({"one"})
    clock.now_s += 1.0
    assert absences.is_missing("one")
    assert absences.left_s("one", WAIT_S) == WAIT_S - 1.0
