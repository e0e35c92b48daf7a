#!/usr/bin/python3
"""The goal that a killed executor left is cancelled, whoever else listens to the cancels of its server."""

import unittest
from typing import List

import rospy
import rostest
from actionlib_msgs.msg import GoalID

from executor.ros_running_goals import RunningGoals
from roboframenet_testing import wait_until


class RunningGoalsTest(unittest.TestCase):
    def test_a_server_that_connects_after_another_listener_gets_the_cancels(self) -> None:
        killed = RunningGoals("~running_goals")
        for goal_id in ("first", "second"):
            killed.note("moving", goal_id)
        RunningGoals("~running_goals").start()
        heard: List[str] = []
        listener = rospy.Subscriber("moving/cancel", GoalID, lambda cancel: heard.append(cancel.id))
        wait_until(lambda: {"first", "second"} <= set(heard))
        # A subscriber of its own connection: rospy shares that of one topic.
        listener.unregister()
        at_server: List[str] = []
        server = rospy.Subscriber("moving/cancel", GoalID, lambda cancel: at_server.append(cancel.id))
        wait_until(lambda: {"first", "second"} <= set(at_server))
        server.unregister()


if __name__ == "__main__":
    rospy.init_node("test_running_goals")
    rostest.rosrun("executor", "running_goals", RunningGoalsTest)
