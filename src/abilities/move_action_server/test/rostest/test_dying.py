#!/usr/bin/python3
"""Whoever dies in mid-motion: the base stops, and the goal ends if there is somebody left to end it."""

import os
import signal
import sys
import unittest
import xmlrpc.client

import actionlib
import rosgraph
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import (
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
)

from roboframenet_testing import wait_until

DEADLINE_S = 60.0


def kill(node_name, signal_number):
    """Send a signal to the process of a node."""
    uri = rosgraph.Master(rospy.get_name()).lookupNode(rospy.resolve_name(node_name))
    process_id = xmlrpc.client.ServerProxy(uri).getPid(rospy.get_name())[2]
    os.kill(process_id, signal_number)


class TestDying(unittest.TestCase):
    """The move server, the robot and a commander die."""

    @classmethod
    def setUpClass(cls):
        """Have one client: a server that comes back while a publisher comes and goes never connects to it."""
        cls.client = actionlib.ActionClient("moving_forward", FilledSemanticFrameAction)

    def setUp(self):
        """Wait for a base that stands and a server that can be asked."""
        self.speed, self.samples, self.last_command = None, 0, None
        self.odometry = rospy.Subscriber("odom", Odometry, self.on_odometry, queue_size=1)
        self.commands = rospy.Subscriber("cmd_vel", Twist, self.on_command, queue_size=100)
        self.assertTrue(self.client.wait_for_server(rospy.Duration(DEADLINE_S)))
        wait_until(lambda: self.speed == 0.0)

    def tearDown(self):
        """Let go of the topics: the next test has its own."""
        self.odometry.unregister()
        self.commands.unregister()

    def on_odometry(self, message):
        """Take odometry."""
        self.speed = abs(message.twist.twist.linear.x)
        self.samples += 1

    def on_command(self, message):
        """Remember the last velocity command."""
        self.last_command = (message.linear.x, message.angular.z)

    def move(self):
        """Send a long way, and wait until the base moves."""
        frame = FilledSemanticFrame(
            name="moving_forward",
            frame_elements=[
                FilledFrameElement(name="distance", argument="18"),
                FilledFrameElement(name="distance_unit", argument="metres"),
            ],
        )
        handle = self.client.send_goal(FilledSemanticFrameGoal(frame=frame))
        wait_until(lambda: self.speed > 0.1, message=lambda: self.last_command)
        return handle

    def test_base_stops_when_the_server_is_killed(self):
        """Nobody says stop: the command timeout of the base does it."""
        self.move()
        kill("move_action_server", signal.SIGKILL)
        wait_until(lambda: self.speed == 0.0)

    def test_server_that_is_shut_down_says_stop(self):
        """Zero velocity is the last command."""
        self.move()
        kill("move_action_server", signal.SIGINT)
        wait_until(lambda: self.last_command == (0.0, 0.0))
        wait_until(lambda: self.speed == 0.0)

    def test_goal_is_aborted_when_odometry_is_lost(self):
        """The robot is gone: the goal ends with the reason."""
        handle = self.move()
        kill("turtlebot_sim", signal.SIGKILL)
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual(GoalStatus.ABORTED, handle.get_terminal_state())
        self.assertIn("odometry is lost", handle.get_goal_status_text())
        wait_until(lambda: self.last_command == (0.0, 0.0))


if __name__ == "__main__":
    rospy.init_node("dying_test")
    rostest.rosrun("move_action_server", "dying_test", TestDying, sys.argv)
