"""What the end of the program waits for."""

import pytest
import rospy

import smach
from smach_ros import SimpleActionState, util


def container(run_by_this_thread):
    class Running(smach.Container):
        asked = 0

        def is_running(self):
            self.asked += 1
            return True

        def is_run_by_this_thread(self):
            return run_by_this_thread

    return Running()


def test_wait_for_a_machine_that_does_not_end_has_a_deadline(monkeypatch):
    monkeypatch.setattr(util, "END_GRACE_S", 0.2)
    said = []
    monkeypatch.setattr(rospy, "logerr", said.append)
    stubborn = container(run_by_this_thread=False)
    util._wait_for_end(stubborn)
    assert stubborn.asked > 1 and len(said) == 1


def test_thread_that_runs_the_machine_does_not_wait_for_it():
    mine = container(run_by_this_thread=True)
    util._wait_for_end(mine)
    assert mine.asked == 0


def test_state_that_is_no_container_is_not_waited_for():
    util._wait_for_end(smach.State(["done"]))


class Moving(SimpleActionState):
    def __init__(self, looks):
        smach.State.__init__(self, ["done"])
        self.looks = looks

    def is_cancel_on_its_way(self):
        self.looks -= 1
        return self.looks > 0


@pytest.mark.parametrize(("looks", "errors"), [(0, 0), (3, 0), (1000, 1)])
def test_wait_for_the_cancels_of_all_goals_has_a_deadline(monkeypatch, looks, errors):
    monkeypatch.setattr(util, "CANCEL_GRACE_S", 0.3)
    said = []
    monkeypatch.setattr(rospy, "logerr", said.append)
    moving = Moving(looks)
    inner = smach.StateMachine(["done"])
    with inner:
        smach.StateMachine.add("MOVE", moving)
    outer = smach.Concurrence(["done"], "done")
    with outer:
        smach.Concurrence.add("INNER", inner)
    util._wait_for_cancels(outer)
    assert len(said) == errors
    assert errors or moving.looks <= 0
