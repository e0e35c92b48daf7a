#!/usr/bin/python3
"""Navigation as its clients see it: round obstacles, preempted, walled in."""

import math
import os
import sys
import unittest

import actionlib
import rospy
import rostest
import yaml
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped, Twist
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import OccupancyGrid, Odometry

from roboframenet_testing import wait_until

DEADLINE_S = 60.0
PLACES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "config", "places.yaml")


class TestMoveBaseSim(unittest.TestCase):
    """Goals to two robots: one in a flat, one walled in."""

    @classmethod
    def setUpClass(cls):
        """Connect to both."""
        cls.odometry, cls.amcl_pose, cls.map, cls.last_command = None, None, None, None
        cls.subscribers = [
            rospy.Subscriber("odom", Odometry, lambda message: setattr(cls, "odometry", message), queue_size=1),
            rospy.Subscriber(
                "amcl_pose", PoseWithCovarianceStamped, lambda message: setattr(cls, "amcl_pose", message), queue_size=1
            ),
            rospy.Subscriber("map", OccupancyGrid, lambda message: setattr(cls, "map", message), queue_size=1),
            rospy.Subscriber(
                "cmd_vel",
                Twist,
                lambda message: setattr(cls, "last_command", (message.linear.x, message.angular.z)),
                queue_size=100,
            ),
        ]
        cls.client = actionlib.ActionClient("move_base", MoveBaseAction)
        cls.walled_in = actionlib.ActionClient("walled_in/move_base", MoveBaseAction)
        for client in (cls.client, cls.walled_in):
            wait_until(lambda client=client: client.wait_for_server(rospy.Duration(1.0)))
        wait_until(lambda: cls.odometry is not None and cls.amcl_pose is not None)
        with open(PLACES, encoding="utf-8") as file:
            cls.places = yaml.safe_load(file)

    def go(self, x_m, y_m, yaw_rad=0.0, *, client=None, frame="map", feedback_cb=None):
        """Send a goal."""
        pose = PoseStamped()
        pose.header.frame_id = frame
        pose.pose.position.x, pose.pose.position.y = x_m, y_m
        pose.pose.orientation.z, pose.pose.orientation.w = math.sin(yaw_rad / 2.0), math.cos(yaw_rad / 2.0)
        return (client or self.client).send_goal(MoveBaseGoal(target_pose=pose), feedback_cb=feedback_cb)

    def outcome(self, handle):
        """Wait for the end, and return state and text."""
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        return handle.get_terminal_state(), handle.get_goal_status_text()

    def test_goes_round_walls_and_the_kitchen_table(self):
        """The table at the kitchen's door is in the way of the place behind it."""
        feedback = []
        place = self.places["table"]
        handle = self.go(
            place["x"],
            place["y"],
            place["heading"],
            feedback_cb=lambda _, message: feedback.append(message.base_position.pose.position.x),
        )
        self.assertEqual((GoalStatus.SUCCEEDED, "the goal is reached"), self.outcome(handle))
        position = self.odometry.pose.pose.position
        self.assertLess(math.hypot(position.x - place["x"], position.y - place["y"]), 0.1)
        wait_until(lambda: self.last_command == (0.0, 0.0))
        wait_until(lambda: abs(self.amcl_pose.pose.pose.position.x - place["x"]) < 0.1)
        self.assertTrue(feedback)

    def test_cancel_in_mid_way_stops_the_robot(self):
        """PREEMPTED, and zero velocity."""
        place = self.places["office"]
        handle = self.go(place["x"], place["y"])
        wait_until(lambda: abs(self.odometry.twist.twist.linear.x) > 0.1)
        handle.cancel()
        self.assertEqual(GoalStatus.PREEMPTED, self.outcome(handle)[0])
        wait_until(lambda: self.last_command == (0.0, 0.0))
        wait_until(lambda: self.odometry.twist.twist.linear.x == 0.0)

    def test_goals_that_cannot_be_are_aborted_with_the_reason(self):
        """In a wall, outside, in another frame."""
        for x_m, y_m, frame, words in (
            (2.0, -3.0, "map", "stand in an obstacle"),
            (50.0, 0.0, "map", "outside"),
            (math.nan, 0.0, "map", "finite"),
            (0.0, 0.0, "moon", '"moon"'),
        ):
            state, text = self.outcome(self.go(x_m, y_m, frame=frame))
            self.assertEqual(GoalStatus.ABORTED, state, text)
            self.assertIn(words, text)

    def test_walled_in_robot_aborts(self):
        """No door."""
        state, text = self.outcome(self.go(4.0, 4.0, client=self.walled_in))
        self.assertEqual(GoalStatus.ABORTED, state, text)
        self.assertIn("walled in", text)

    def test_map_has_the_walls(self):
        """The latched map is the room."""
        wait_until(lambda: self.map is not None)
        info = self.map.info
        self.assertEqual((240, 160), (info.width, info.height))
        column = int((-2.0 - info.origin.position.x) / info.resolution)
        row = int((-3.0 - info.origin.position.y) / info.resolution)
        self.assertEqual(100, self.map.data[row * info.width + column])
        self.assertEqual(0, self.map.data[int(4.0 / info.resolution) * info.width + int(6.0 / info.resolution)])


if __name__ == "__main__":
    rospy.init_node("move_base_sim_test")
    rostest.rosrun("roboframenet_sim", "move_base_sim_test", TestMoveBaseSim, sys.argv)
