#!/usr/bin/python3
"""Robots that simulators offer, by the names of their topics: ``simulators_test.py ROBOT``."""

import math
import sys
import unittest
from typing import Dict, List, Tuple

import rospy
import rostest
from geometry_msgs.msg import PoseWithCovarianceStamped, Twist
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import Reply
from turtlesim.msg import Pose
from turtlesim.srv import TeleportAbsolute

from roboframenet_rostest import say, wait_for_pipeline
from roboframenet_testing import wait_until

NEAR = 0.05


def yaw_of(message: Odometry) -> float:
    rotation = message.pose.pose.orientation
    return 2.0 * math.atan2(rotation.z, rotation.w)


def turned(before_rad: float, after_rad: float) -> float:
    return math.remainder(after_rad - before_rad, math.tau)


class Turtlesim(unittest.TestCase):
    """What the turtle does is read from its own topic."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.poses: List[Pose] = []
        cls.velocities: List[Twist] = []
        cls.subscribers = [
            rospy.Subscriber("turtle1/pose", Pose, cls.poses.append),
            rospy.Subscriber("turtle1/cmd_vel", Twist, cls.velocities.append),
        ]
        wait_for_pipeline(["moving_forward", "turning", "saying"])
        wait_until(lambda: bool(cls.poses))

    def move(self, text: str) -> Tuple[float, float]:
        """Say a sentence; returns how far the turtle came, and by what angle it turned."""
        before = self.poses[-1]
        reply = say(text)
        self.assertEqual(Reply.DONE, reply.outcome, reply.sentence)
        after = self.poses[-1]
        return math.hypot(after.x - before.x, after.y - before.y), turned(before.theta, after.theta)

    def test_1_motions(self) -> None:
        distance_m, _ = self.move("Move forward one metre.")
        self.assertAlmostEqual(1.0, distance_m, delta=NEAR)
        _, angle_rad = self.move("Turn left 90 degrees.")
        self.assertAlmostEqual(math.pi / 2.0, angle_rad, delta=NEAR)
        self.assertEqual(Reply.DONE, say("Say hello.").outcome)

    def test_2_too_far_is_told(self) -> None:
        """The field ends: the turtle stands at its edge, and the reply says that it does not move."""
        rospy.ServiceProxy("turtle1/teleport_absolute", TeleportAbsolute)(x=11.0, y=5.0, theta=0.0)
        wait_until(lambda: self.poses[-1].x > 10.9)
        reply = say("Move forward two metres.")
        self.assertEqual(Reply.FAILED, reply.outcome, reply.sentence)
        self.assertAlmostEqual(11.09, self.poses[-1].x, delta=NEAR)

    def test_3_a_stop_reaches_the_topic_of_the_turtle(self) -> None:
        self.velocities.clear()
        reply = say("Stop.")
        self.assertEqual(Reply.DONE, reply.outcome, reply.sentence)
        wait_until(lambda: any(one.linear.x == 0.0 and one.angular.z == 0.0 for one in self.velocities))


class Turtlebot3(unittest.TestCase):
    """What the robot does is read from its odometry."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.last: Dict[str, Odometry] = {}
        cls.fastest: List[float] = [0.0]
        cls.subscribers = [
            rospy.Subscriber("odom", Odometry, lambda message: cls.last.update(odom=message)),
            rospy.Subscriber("cmd_vel", Twist, lambda message: cls.fastest.append(abs(message.linear.x))),
        ]
        wait_for_pipeline(["moving_forward", "turning", "navigating_to_location", "naming_location"])
        wait_until(lambda: "odom" in cls.last)
        rospy.wait_for_message("amcl_pose", PoseWithCovarianceStamped, 60.0)

    def where(self) -> Tuple[float, float, float]:
        position = self.last["odom"].pose.pose.position
        return position.x, position.y, yaw_of(self.last["odom"])

    def do(self, text: str) -> None:
        reply = say(text)
        self.assertEqual(Reply.DONE, reply.outcome, reply.sentence)

    def test_1_names(self) -> None:
        self.assertEqual(
            ("odom", "base_footprint"), (self.last["odom"].header.frame_id, self.last["odom"].child_frame_id)
        )

    def test_2_motions(self) -> None:
        x_m, y_m, yaw_rad = self.where()
        self.do("Move forward half a metre quickly.")
        self.assertAlmostEqual(0.5, math.hypot(self.where()[0] - x_m, self.where()[1] - y_m), delta=NEAR)
        # No faster than a Burger can.
        self.assertLessEqual(max(self.fastest), 0.22)
        self.do("Turn right 45 degrees.")
        self.assertAlmostEqual(-math.pi / 4.0, turned(yaw_rad, self.where()[2]), delta=NEAR)

    def test_3_places_by_driving_and_back_by_move_base(self) -> None:
        here_m = self.where()
        self.do("This is the pantry.")
        self.do("Move backward half a metre.")
        self.do("Go to the pantry.")
        there_m = self.where()
        self.assertLess(math.hypot(there_m[0] - here_m[0], there_m[1] - here_m[1]), 0.2)


if __name__ == "__main__":
    rospy.init_node("simulators_test")
    case = {"Turtlesim": Turtlesim, "Turtlebot3": Turtlebot3}[sys.argv[1]]
    rostest.rosrun("roboframenet_tests", sys.argv[1].lower(), case, sys.argv)
