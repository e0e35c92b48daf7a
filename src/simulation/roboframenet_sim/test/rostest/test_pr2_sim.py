#!/usr/bin/python3
"""The arms and the base of the simulated PR2, as its clients see them."""

import sys
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from pr2_controllers_msgs.msg import JointTrajectoryAction, JointTrajectoryGoal
from sensor_msgs.msg import JointState
from trajectory_msgs.msg import JointTrajectoryPoint

from roboframenet_testing import wait_until

DEADLINE_S = 60.0
SUFFIXES = ("shoulder_pan", "shoulder_lift", "upper_arm_roll", "elbow_flex", "forearm_roll", "wrist_flex", "wrist_roll")
HIGH = (-0.3, -0.2, -0.5, -0.8, 0.0, -0.4, 0.0)
TUCKED = (0.0, 1.1, 0.0, -1.9, 0.0, -1.0, 0.0)


class TestPr2Sim(unittest.TestCase):
    """Trajectories, limits, preemption, the base."""

    @classmethod
    def setUpClass(cls):
        """Connect to both arms and the base."""
        cls.positions, cls.velocities, cls.odometry, cls.fastest = {}, {}, None, 0.0
        cls.joint_states = rospy.Subscriber("joint_states", JointState, cls.on_joints, queue_size=1)
        cls.odom = rospy.Subscriber("odom", Odometry, cls.on_odometry, queue_size=1000)
        cls.arms = {
            prefix: actionlib.ActionClient(f"{prefix}_arm_controller/joint_trajectory_action", JointTrajectoryAction)
            for prefix in ("r", "l")
        }
        for client in cls.arms.values():
            assert client.wait_for_server(rospy.Duration(DEADLINE_S))
        wait_until(lambda: len(cls.positions) == 14 and cls.odometry is not None)

    @classmethod
    def on_joints(cls, message):
        """Take the joints."""
        cls.positions.update(zip(message.name, message.position))
        cls.velocities.update(zip(message.name, message.velocity))

    @classmethod
    def on_odometry(cls, message):
        """Take odometry, and remember the highest speed: the base drives for a moment only."""
        cls.odometry = message
        cls.fastest = max(cls.fastest, message.twist.twist.linear.x)

    def send(self, positions, seconds, prefix="r"):
        """Send a trajectory of one point."""
        goal = JointTrajectoryGoal()
        goal.trajectory.joint_names = [f"{prefix}_{suffix}_joint" for suffix in SUFFIXES]
        goal.trajectory.points = [JointTrajectoryPoint(positions=positions, time_from_start=rospy.Duration(seconds))]
        return self.arms[prefix].send_goal(goal)

    def outcome(self, handle):
        """Wait for the end, and return the state."""
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        return handle.get_terminal_state()

    def is_at(self, positions, prefix="r"):
        """Tell whether the joints are there."""
        return all(
            abs(self.positions[f"{prefix}_{suffix}_joint"] - position) < 0.02
            for suffix, position in zip(SUFFIXES, positions)
        )

    def test_both_arms_follow_trajectories(self):
        """Each arm has an action of its own."""
        left = self.send(TUCKED, 2.0, prefix="l")
        self.assertEqual(GoalStatus.SUCCEEDED, self.outcome(self.send(HIGH, 2.0)))
        wait_until(lambda: self.is_at(HIGH))
        self.assertEqual(GoalStatus.SUCCEEDED, self.outcome(left))
        wait_until(lambda: self.is_at(TUCKED, prefix="l"))

    def test_limits_abort_with_the_joint(self):
        """Beyond the range, and faster than the joint."""
        handle = self.send((3.0,) + TUCKED[1:], 5.0)
        self.assertEqual(GoalStatus.ABORTED, self.outcome(handle))
        self.assertIn("r_shoulder_pan_joint", handle.get_goal_status_text())
        handle = self.send((-0.5, 1.1, 0.0, -0.3, 3.0, -1.0, 3.0), 0.1)
        self.assertEqual(GoalStatus.ABORTED, self.outcome(handle))
        self.assertIn("faster", handle.get_goal_status_text())

    def test_cancel_holds_the_arm_still(self):
        """A cancelled goal is PREEMPTED, and the arm is where it was."""
        self.assertEqual(GoalStatus.SUCCEEDED, self.outcome(self.send(TUCKED, 2.0)))
        handle = self.send(HIGH, 30.0)
        wait_until(lambda: self.velocities["r_shoulder_lift_joint"] < 0.0)
        handle.cancel()
        self.assertEqual(GoalStatus.PREEMPTED, self.outcome(handle))
        wait_until(lambda: self.velocities["r_shoulder_lift_joint"] == 0.0)
        self.assertFalse(self.is_at(HIGH))

    def test_newer_trajectory_takes_the_place_of_the_older(self):
        """As on the real controller."""
        older = self.send(HIGH, 30.0)
        wait_until(lambda: older.get_goal_status() == GoalStatus.ACTIVE)
        newer = self.send(TUCKED, 2.0)
        self.assertEqual(GoalStatus.PREEMPTED, self.outcome(older))
        self.assertEqual(GoalStatus.SUCCEEDED, self.outcome(newer))
        wait_until(lambda: self.is_at(TUCKED))

    def test_base_moves_and_stops_by_itself(self):
        """A commander that falls silent: the base stands after the command timeout."""
        publisher = rospy.Publisher("base_controller/command", Twist, queue_size=1)
        wait_until(lambda: publisher.get_num_connections() > 0)
        command = Twist()
        command.linear.x = 0.3
        publisher.publish(command)
        wait_until(lambda: self.fastest > 0.25)
        wait_until(lambda: self.odometry.twist.twist.linear.x == 0.0)
        self.assertGreater(self.odometry.pose.pose.position.x, 0.1)


if __name__ == "__main__":
    rospy.init_node("pr2_sim_test")
    rostest.rosrun("roboframenet_sim", "pr2_sim_test", TestPr2Sim, sys.argv)
