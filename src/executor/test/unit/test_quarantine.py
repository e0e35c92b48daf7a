"""Servers that hang: out of use, and not for ever."""

from executor.quarantine import Quarantine
from roboframenet_testing import Clock


def make(duration_s: float = 60.0):
    clock = Clock()
    return Quarantine(duration_s=duration_s, now=clock), clock


def test_server_that_owes_a_goal_is_out_of_use_and_others_are_not() -> None:
    quarantine, _ = make()
    quarantine.put("turn", "goal_1", "was silent for 5 s")
    assert quarantine.refusal("turn") == "is out of use until it ends its last goal: it was silent for 5 s"
    assert quarantine.refusal("walk") == ""


def test_it_is_used_again_when_the_goal_has_ended() -> None:
    quarantine, _ = make()
    quarantine.put("turn", "goal_1", "was silent")
    quarantine.hear_end("turn", "goal_0")
    quarantine.hear_end("walk", "goal_1")
    assert quarantine.refusal("turn")
    quarantine.hear_end("turn", "goal_1")
    assert quarantine.refusal("turn") == ""


def test_it_is_tried_again_after_a_time() -> None:
    quarantine, clock = make()
    quarantine.put("turn", "goal_1", "was silent")
    clock.now_s += 59.9
    assert quarantine.refusal("turn")
    clock.now_s += 0.1
    assert quarantine.refusal("turn") == ""


def test_no_quarantine() -> None:
    quarantine, _ = make(duration_s=0.0)
    quarantine.put("turn", "goal_1", "was silent")
    assert quarantine.refusal("turn") == ""
