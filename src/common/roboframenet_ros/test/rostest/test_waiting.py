#!/usr/bin/python3
"""Waits on simulated time, before the first message of a clock: the ROS time is 0, and stands."""

import unittest

import actionlib
import rospy
from actionlib.msg import TestAction
from std_msgs.msg import String

from roboframenet_ros.ros_quiet_action_server import QuietActionServer
from roboframenet_ros.ros_waiting import wait_for_action_server, wait_for_message

DEADLINE_S = 60.0


class WaitingTest(unittest.TestCase):
    """No clock is published."""

    def test_server_is_found_by_both_kinds_of_clients(self) -> None:
        server = QuietActionServer("there", TestAction, lambda goal: None, auto_start=False)
        server.start()
        for kind in (actionlib.ActionClient, actionlib.SimpleActionClient):
            self.assertTrue(wait_for_action_server(kind("there", TestAction), DEADLINE_S))

    def test_server_that_is_missing_ends_the_wait(self) -> None:
        self.assertFalse(wait_for_action_server(actionlib.ActionClient("missing", TestAction), 0.3))

    def test_message_is_returned_and_a_missing_one_told(self) -> None:
        publisher = rospy.Publisher("latched", String, queue_size=1, latch=True)
        publisher.publish(String(data="word"))
        self.assertEqual(wait_for_message("latched", String, DEADLINE_S).data, "word")
        with self.assertRaises(rospy.ROSException):
            wait_for_message("silent", String, 0.3)


if __name__ == "__main__":
    import rostest

    rospy.init_node("test_waiting")
    rostest.rosrun("roboframenet_ros", "test_waiting", WaitingTest)
