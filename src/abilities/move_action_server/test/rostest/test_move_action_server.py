#!/usr/bin/python3
"""Goals as the executor sends them, to the real node, measured by the odometry of a simulated base."""

import math
import sys
import threading
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from dynamic_reconfigure.client import Client
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
FINAL = (
    GoalStatus.SUCCEEDED,
    GoalStatus.ABORTED,
    GoalStatus.PREEMPTED,
    GoalStatus.REJECTED,
    GoalStatus.RECALLED,
    GoalStatus.LOST,
)


class Goal:
    """One goal, watched by its handle."""

    def __init__(self, client, frame_name, arguments):
        frame = FilledSemanticFrame(
            name=frame_name,
            frame_elements=[FilledFrameElement(name=name, argument=argument) for name, argument in arguments.items()],
        )
        self.handle = client.send_goal(FilledSemanticFrameGoal(frame=frame))

    def is_final(self):
        """Tell whether the goal has ended."""
        return (
            self.handle.get_terminal_state() in FINAL
            if self.handle.get_comm_state() == actionlib.CommState.DONE
            else False
        )

    def outcome(self):
        """Wait for the end, and return the state and the text."""
        wait_until(self.is_final, message="the goal has not ended")
        return self.handle.get_terminal_state(), self.handle.get_goal_status_text()


class TestMoveActionServer(unittest.TestCase):
    """Motions, preemption, refusals."""

    @classmethod
    def setUpClass(cls):
        """Connect to the four servers and to the base."""
        cls.lock = threading.Lock()
        cls.turned_rad, cls.position, cls.speed, cls.yaw_rad = 0.0, (0.0, 0.0), 0.0, None
        cls.last_command = None
        cls.fastest_command = 0.0
        cls.odometry = rospy.Subscriber("odom", Odometry, cls.on_odometry, queue_size=1)
        cls.commands = rospy.Subscriber("cmd_vel", Twist, cls.on_command, queue_size=100)
        cls.clients = {}
        for name in ("moving_forward", "moving_backward", "turning", "turning_to_direction"):
            cls.clients[name] = actionlib.ActionClient(name, FilledSemanticFrameAction)
            assert cls.clients[name].wait_for_server(rospy.Duration(DEADLINE_S)), name
        wait_until(lambda: cls.yaw_rad is not None)

    @classmethod
    def on_odometry(cls, message):
        """Take odometry, and count whole turns."""
        rotation = message.pose.pose.orientation
        yaw_rad = 2.0 * math.atan2(rotation.z, rotation.w)
        with cls.lock:
            if cls.yaw_rad is not None:
                cls.turned_rad += math.remainder(yaw_rad - cls.yaw_rad, 2.0 * math.pi)
            cls.yaw_rad = yaw_rad
            cls.position = (message.pose.pose.position.x, message.pose.pose.position.y)
            cls.speed = max(abs(message.twist.twist.linear.x), abs(message.twist.twist.angular.z))

    @classmethod
    def on_command(cls, message):
        """Remember the last velocity command."""
        cls.last_command = (message.linear.x, message.angular.z)
        cls.fastest_command = max(cls.fastest_command, abs(message.linear.x))

    def start(self, frame_name, **arguments):
        """Send a goal."""
        return Goal(self.clients[frame_name], frame_name, arguments)

    def assert_stands(self):
        """The base was told to stop, and does."""
        wait_until(lambda: self.last_command == (0.0, 0.0))
        wait_until(lambda: self.speed == 0.0)

    def assert_turns(self, wanted_rad, **arguments):
        """A turn ends within two per cent."""
        before_rad = self.turned_rad
        state, text = self.start("turning", **arguments).outcome()
        self.assertEqual(GoalStatus.SUCCEEDED, state, text)
        self.assert_stands()
        self.assertLessEqual(abs(self.turned_rad - before_rad - wanted_rad), 0.02 * abs(wanted_rad))

    def assert_moves(self, frame_name, wanted_m, **arguments):
        """A way along the nose ends within two per cent."""
        (x_m, y_m), yaw_rad = self.position, self.yaw_rad
        state, text = self.start(frame_name, **arguments).outcome()
        self.assertEqual(GoalStatus.SUCCEEDED, state, text)
        self.assert_stands()
        along_m = (self.position[0] - x_m) * math.cos(yaw_rad) + (self.position[1] - y_m) * math.sin(yaw_rad)
        self.assertLessEqual(abs(along_m - wanted_m), 0.02 * abs(wanted_m))

    def test_turn_left_120_degrees(self):
        """The sentence of the paper."""
        self.assert_turns(math.radians(120), direction="left", angle="120", angle_unit="degrees")

    def test_turn_right_2_radians(self):
        """Another one."""
        self.assert_turns(-2.0, direction="right", angle="2", angle_unit="radians")

    def test_turn_left_270_degrees_is_not_90_to_the_right(self):
        """More than half a turn."""
        self.assert_turns(math.radians(270), direction="left", angle="270", angle_unit="degrees")

    def test_turn_north_and_then_west(self):
        """By REP 103 the base faces along y, and then against x, whichever way it faced before."""
        for direction, yaw_rad in (("north", math.pi / 2.0), ("west", math.pi)):
            state, text = self.start("turning_to_direction", direction=direction).outcome()
            self.assertEqual(GoalStatus.SUCCEEDED, state, text)
            self.assert_stands()
            self.assertLessEqual(abs(math.remainder(self.yaw_rad - yaw_rad, 2.0 * math.pi)), 0.04)

    def test_move_forward_3_feet(self):
        """The sentence of the paper."""
        self.assert_moves("moving_forward", 0.9144, distance="3", distance_unit="feet")

    def test_move_backward_1_metre(self):
        """Backwards."""
        self.assert_moves("moving_backward", -1.0, distance="1", distance_unit="metre")

    def test_speed_is_changed_while_the_node_runs(self):
        """The next motion has the new speed; one below the creep changes nothing."""
        client = Client("move_action_server", timeout=DEADLINE_S)
        try:
            self.assertEqual(0.15, client.update_configuration({"linear_speed_m_per_s": 0.15})["linear_speed_m_per_s"])
            self.assertEqual(0.15, client.update_configuration({"linear_speed_m_per_s": 0.01})["linear_speed_m_per_s"])
            type(self).fastest_command = 0.0
            self.assert_moves("moving_forward", 0.5, distance="0.5", distance_unit="metre")
            self.assertAlmostEqual(0.15, self.fastest_command)
        finally:
            client.update_configuration({"linear_speed_m_per_s": 0.3})
            client.close()

    def test_negative_distance_moves_the_other_way(self):
        """Move forward minus half a metre."""
        self.assert_moves("moving_forward", -0.5, distance="-0.5", distance_unit="metres")

    def test_cancel_in_mid_motion_stops_the_base(self):
        """A cancelled goal is PREEMPTED, and zero velocity has been published before."""
        goal = self.start("moving_forward", distance="15", distance_unit="metres")
        wait_until(lambda: self.speed > 0.1)
        goal.handle.cancel()
        state, text = goal.outcome()
        self.assertEqual(GoalStatus.PREEMPTED, state, text)
        self.assertRegex(text, r"^I moved [\d.]+ m\.$")
        self.assert_stands()

    def test_newer_goal_of_another_server_preempts_the_older(self):
        """One base: the newest goal of the three servers has it."""
        older = self.start("moving_forward", distance="15", distance_unit="metres")
        wait_until(lambda: self.speed > 0.1)
        before_rad = self.turned_rad
        newer = self.start("turning", direction="left", angle="1", angle_unit="radian")
        state, text = older.outcome()
        self.assertEqual(GoalStatus.PREEMPTED, state, text)
        self.assertIn("another motion", text)
        state, text = newer.outcome()
        self.assertEqual(GoalStatus.SUCCEEDED, state, text)
        self.assert_stands()
        self.assertAlmostEqual(1.0, self.turned_rad - before_rad, delta=0.05)

    def test_newer_goal_of_the_same_server_preempts_the_older(self):
        """As in actionlib."""
        older = self.start("turning", direction="left", angle="3", angle_unit="turns")
        wait_until(lambda: self.speed > 0.1)
        newer = self.start("turning", direction="right", angle="30", angle_unit="degrees")
        self.assertEqual(GoalStatus.PREEMPTED, older.outcome()[0])
        self.assertEqual(GoalStatus.SUCCEEDED, newer.outcome()[0])
        self.assert_stands()

    def test_limits_are_refused_without_a_motion(self):
        """Too far, too much, no number, no unit."""
        before = self.position, self.turned_rad
        for frame_name, arguments, words in (
            ("moving_forward", {"distance": "3", "distance_unit": "kilometres"}, "more than the limit"),
            ("turning", {"direction": "left", "angle": "1e400", "angle_unit": "degrees"}, "count"),
            ("turning", {"direction": "left", "angle": "3"}, "unit"),
            ("moving_backward", {}, "How far"),
        ):
            state, text = self.start(frame_name, **arguments).outcome()
            self.assertEqual(GoalStatus.ABORTED, state, text)
            self.assertIn(words, text)
        self.assertEqual(before, (self.position, self.turned_rad))


if __name__ == "__main__":
    rospy.init_node("test_move_action_server")
    rostest.rosrun("move_action_server", "test_move_action_server", TestMoveActionServer, sys.argv)
