#!/usr/bin/python3
"""Following a simulated person, as the executor asks for it."""

import math
import os
import signal
import sys
import threading
import unittest
import xmlrpc.client

import actionlib
import rosgraph
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import (
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
)
from std_msgs.msg import String
from turtlebot_msgs.srv import SetFollowState, SetFollowStateRequest, SetFollowStateResponse

from roboframenet_testing import wait_until

DEADLINE_S = 60.0
BODY_RADIUS_M = 0.2
BAND_M = (0.3, 0.9)
"""From the robot's centre to the person's skin, while following."""


def shut_down(node_name):
    """Interrupt the process of a node."""
    uri = rosgraph.Master(rospy.get_name()).lookupNode(rospy.resolve_name(node_name))
    os.kill(xmlrpc.client.ServerProxy(uri).getPid(rospy.get_name())[2], signal.SIGINT)


class TestTurtlebotFollower(unittest.TestCase):
    """A person walks, stands, leaves; a goal is cancelled; followers of the robot's own."""

    @classmethod
    def setUpClass(cls):
        """Connect to the robot, the person and the follower."""
        cls.lock = threading.Lock()
        cls.robot, cls.speed, cls.person, cls.last_command = None, None, None, None
        cls.gaps_m, cls.path_m = [], 0.0
        cls.robot_at, cls.person_at = {}, {}
        cls.subscribers = [
            rospy.Subscriber("odom", Odometry, cls.on_odometry, queue_size=1000),
            rospy.Subscriber("person/pose", PoseStamped, cls.on_person, queue_size=1000),
            rospy.Subscriber("cmd_vel", Twist, cls.on_command, queue_size=100),
        ]
        cls.act = rospy.Publisher("person/act", String, queue_size=10)
        cls.client = actionlib.ActionClient("following", FilledSemanticFrameAction)
        wait_until(lambda: cls.client.wait_for_server(rospy.Duration(1.0)))
        wait_until(lambda: cls.robot and cls.person and cls.act.get_num_connections() > 0)

    @classmethod
    def on_odometry(cls, message):
        """Take the place of the robot, and count the way."""
        place = message.pose.pose.position.x, message.pose.pose.position.y
        if cls.robot is not None:
            cls.path_m += math.hypot(place[0] - cls.robot[0], place[1] - cls.robot[1])
        cls.robot = place
        cls.robot_at[message.header.stamp.to_nsec()] = place
        cls.measure_gap(message.header.stamp.to_nsec())
        cls.speed = max(abs(message.twist.twist.linear.x), abs(message.twist.twist.angular.z))

    @classmethod
    def on_person(cls, message):
        """Take the place of the person."""
        cls.person = message.pose.position.x, message.pose.position.y
        cls.person_at[message.header.stamp.to_nsec()] = cls.person
        cls.measure_gap(message.header.stamp.to_nsec())

    @classmethod
    def measure_gap(cls, stamp_ns):
        """Measure once both places of the same moment are known: they come on connections of their own."""
        with cls.lock:
            if stamp_ns not in cls.robot_at or stamp_ns not in cls.person_at:
                return
            robot, person = cls.robot_at.pop(stamp_ns), cls.person_at.pop(stamp_ns)
        cls.gaps_m.append(math.hypot(person[0] - robot[0], person[1] - robot[1]) - BODY_RADIUS_M)

    @classmethod
    def on_command(cls, message):
        """Remember the last velocity command."""
        cls.last_command = (message.linear.x, message.angular.z)

    def order(self, act):
        """Let the person do something."""
        self.act.publish(String(data=act))

    def follow(self, client=None, feedback_cb=None):
        """Say "Follow me."."""
        frame = FilledSemanticFrame(
            name="following", frame_elements=[FilledFrameElement(name="cotheme", argument="me")]
        )
        return (client or self.client).send_goal(FilledSemanticFrameGoal(frame=frame), feedback_cb=feedback_cb)

    def outcome(self, handle):
        """Wait for the end, and return state and text."""
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        return handle.get_terminal_state(), handle.get_goal_status_text()

    def meet(self):
        """The person comes before the robot, which follows from then on."""
        self.order("come")
        wait_until(lambda: self.gaps_m and abs(self.gaps_m[-1] - 0.6) < 0.05)
        seen = []
        handle = self.follow(feedback_cb=lambda _, message: seen.append(message.is_succeeding))
        wait_until(lambda: any(seen))
        return handle

    def assert_stands(self):
        """The robot was told to stop, and does."""
        wait_until(lambda: self.last_command == (0.0, 0.0))
        wait_until(lambda: self.speed == 0.0)

    def test_curve_of_ten_metres_keeps_the_band_and_then_stands(self):
        """Ten metres at half a metre per second, an S; then the person stands, and so does the robot; then cancel."""
        handle = self.meet()
        type(self).path_m = 0.0
        del self.gaps_m[:]
        self.order("walk")
        wait_until(lambda: self.path_m > 9.5, message=lambda: (self.path_m, handle.get_goal_status_text()))
        wait_until(lambda: self.speed == 0.0)
        gaps_m = list(self.gaps_m)
        self.assertGreater(min(gaps_m), BAND_M[0])
        self.assertLess(max(gaps_m), BAND_M[1])
        self.assertEqual(GoalStatus.ACTIVE, handle.get_goal_status())
        handle.cancel()
        self.assertEqual(GoalStatus.PREEMPTED, self.outcome(handle)[0])
        self.assert_stands()

    def test_cancel_in_mid_motion_stops_the_robot(self):
        """PREEMPTED, and zero velocity."""
        handle = self.meet()
        self.order("walk")
        wait_until(lambda: self.speed > 0.2)
        handle.cancel()
        self.assertEqual(GoalStatus.PREEMPTED, self.outcome(handle)[0])
        self.assert_stands()

    def test_person_who_leaves_is_lost(self):
        """The robot stops, says so, and the goal is ABORTED."""
        handle = self.meet()
        self.order("leave")
        state, text = self.outcome(handle)
        self.assertEqual(GoalStatus.ABORTED, state)
        self.assertIn("I have lost you", text)
        self.assert_stands()

    # These two end nodes that the tests before them need; tests run in the order of their names.
    def test_when_it_is_shut_down_it_says_stop(self):
        """Zero velocity is the last command."""
        self.meet()
        self.order("walk")
        wait_until(lambda: self.speed > 0.2)
        shut_down("turtlebot_follower")
        self.assert_stands()

    def test_when_it_is_shut_down_the_follower_behind_the_service_is_stopped(self):
        """It would follow without end."""
        client = actionlib.ActionClient("served/following", FilledSemanticFrameAction)
        wait_until(lambda: client.wait_for_server(rospy.Duration(1.0)))
        states = []

        def answer(request):
            states.append(request.state)
            return SetFollowStateResponse(result=SetFollowStateResponse.OK)

        service = rospy.Service("served/turtlebot_follower/change_state", SetFollowState, answer)
        handle = self.follow(client)
        wait_until(lambda: states == [SetFollowStateRequest.FOLLOW], message=handle.get_goal_status_text)
        shut_down("served/turtlebot_follower")
        wait_until(lambda: states == [SetFollowStateRequest.FOLLOW, SetFollowStateRequest.STOPPED])
        service.shutdown()

    def test_without_a_camera_the_goal_is_aborted(self):
        """The reason names the topic."""
        client = actionlib.ActionClient("blind/following", FilledSemanticFrameAction)
        wait_until(lambda: client.wait_for_server(rospy.Duration(1.0)))
        state, text = self.outcome(self.follow(client))
        self.assertEqual(GoalStatus.ABORTED, state)
        self.assertIn("/blind/camera/depth/points", text)

    def test_follower_behind_a_service_is_switched_on_and_off(self):
        """turtlebot_msgs/SetFollowState; without the service the goal is aborted."""
        client = actionlib.ActionClient("served/following", FilledSemanticFrameAction)
        wait_until(lambda: client.wait_for_server(rospy.Duration(1.0)))
        state, text = self.outcome(self.follow(client))
        self.assertEqual(GoalStatus.ABORTED, state)
        self.assertIn("change_state", text)
        states = []

        def answer(request):
            states.append(request.state)
            return SetFollowStateResponse(result=SetFollowStateResponse.OK)

        service = rospy.Service("served/turtlebot_follower/change_state", SetFollowState, answer)
        handle = self.follow(client)
        wait_until(lambda: states == [SetFollowStateRequest.FOLLOW])
        handle.cancel()
        self.assertEqual(GoalStatus.PREEMPTED, self.outcome(handle)[0])
        self.assertEqual([SetFollowStateRequest.FOLLOW, SetFollowStateRequest.STOPPED], states)
        service.shutdown()

    def test_follower_in_a_launch_file_runs_while_the_goal_does(self):
        """As in 2012."""

        def is_up():
            published = rosgraph.Master(rospy.get_name()).getSystemState()[0]
            return any(node.endswith("/other_follower/other_follower") for _, nodes in published for node in nodes)

        client = actionlib.ActionClient("launched/following", FilledSemanticFrameAction)
        wait_until(lambda: client.wait_for_server(rospy.Duration(1.0)))
        handle = self.follow(client)
        # It works, so its start is over: rospy cannot end a node that is just talking with the master.
        rospy.wait_for_message("launched/other_follower/odom", Odometry, timeout=60.0)
        self.assertTrue(is_up())
        handle.cancel()
        self.assertEqual(GoalStatus.PREEMPTED, self.outcome(handle)[0])
        self.assertFalse(is_up())


if __name__ == "__main__":
    rospy.init_node("turtlebot_follower_test")
    rostest.rosrun("turtlebot_follower", "turtlebot_follower_test", TestTurtlebotFollower, sys.argv)
