"""Limits of a whole command."""

from executor import goal_tracking as tracking
from executor.goal_tracking import Goal, GoalDeadlines, GoalStatusCode
from executor.patience import Patience
from roboframenet_testing import Clock

DEADLINES = GoalDeadlines(execution_s=3600.0)


def absent() -> Goal:
    return tracking.fail_unsent("away", DEADLINES, "is not running", now_s=0.0)


def silent() -> Goal:
    goal = tracking.hear_status(tracking.send("mute", DEADLINES, now_s=0.0), GoalStatusCode.ACTIVE, now_s=1.0)
    goal = tracking.tick(goal, now_s=6.0).goal
    return tracking.tick(goal, now_s=11.0).goal


def aborted() -> Goal:
    goal = tracking.hear_status(tracking.send("busy", DEADLINES, now_s=0.0), GoalStatusCode.ACTIVE, now_s=1.0)
    return tracking.hear_result(goal, GoalStatusCode.ABORTED, success=False, text="", now_s=600.0)


def test_servers_that_are_not_there_are_tried_for_a_while_only() -> None:
    clock = Clock()
    patience = Patience(command_s=7200.0, search_s=30.0, now=clock)
    tried = 0
    while not patience.refusal():
        tried += 1
        clock.now_s += 5.0
        patience.spend(absent(), 5.0)
    assert tried == 6
    assert patience.refusal() == "was not tried: servers that do not work took 30 s"


def test_time_of_servers_that_fall_silent_counts_and_that_of_servers_that_work_does_not() -> None:
    patience = Patience(command_s=7200.0, search_s=30.0, now=Clock())
    patience.spend(aborted(), 600.0)
    assert patience.refusal() == ""
    patience.spend(silent(), 30.0)
    assert patience.refusal()


def test_goal_ends_with_its_command() -> None:
    clock = Clock()
    patience = Patience(command_s=7200.0, search_s=30.0, now=clock)
    assert patience.deadlines(DEADLINES).execution_s == 3600.0
    clock.now_s += 7000.0
    assert patience.deadlines(DEADLINES).execution_s == 200.0
    clock.now_s += 200.0
    assert patience.refusal() == "was not tried: the command may take 7200 s"
