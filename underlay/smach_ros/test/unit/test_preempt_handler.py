"""What the end of the program waits for."""

import rospy

import smach
from smach_ros import util


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
