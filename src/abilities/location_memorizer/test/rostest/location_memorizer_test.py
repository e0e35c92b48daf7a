#!/usr/bin/python3
"""Places: refused without a pose, remembered with one, and still known when the node was killed and came back."""

import os
import signal
import unittest
from xmlrpc.client import ServerProxy

import actionlib
import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseWithCovarianceStamped
from location_memorizer.srv import GetLocation, GetLocationResponse
from roboframenet_msgs.msg import (
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
)

from roboframenet_testing import wait_until

#: A name that another reading of the same words would make shorter.
ODD_WORDS = "the the\nfront hall"


class LocationMemorizerTest(unittest.TestCase):
    """The methods run in the order of their names."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.client = actionlib.ActionClient("location_memorizer", FilledSemanticFrameAction)
        assert cls.client.wait_for_server(rospy.Duration(60.0))

    def name_this_place(self, words: str) -> "actionlib.ClientGoalHandle":
        frame = FilledSemanticFrame(name="naming_location", frame_elements=[FilledFrameElement("location", words)])
        handle = self.client.send_goal(FilledSemanticFrameGoal(frame=frame))
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        return handle

    def ask(self, name: str) -> GetLocationResponse:
        rospy.wait_for_service("get_location", timeout=60.0)
        return rospy.ServiceProxy("get_location", GetLocation)(name)

    def test_1_nothing_is_remembered_without_a_pose(self) -> None:
        self.assertEqual(self.name_this_place("the office").get_goal_status(), GoalStatus.ABORTED)
        self.assertFalse(self.ask("office").success)

    def test_2_place_is_remembered_and_survives_a_kill(self) -> None:
        publisher = rospy.Publisher("amcl_pose", PoseWithCovarianceStamped, queue_size=1, latch=True)
        pose = PoseWithCovarianceStamped()
        pose.header.frame_id = "map"
        pose.pose.pose.position.x, pose.pose.pose.orientation.w = 2.5, 1.0
        publisher.publish(pose)
        wait_until(lambda: self.ask("nowhere").pose.pose.position.x == 2.5)
        for words in ("the office", ODD_WORDS):
            self.assertEqual(self.name_this_place(words).get_goal_status(), GoalStatus.SUCCEEDED)
        master = rosgraph.Master("/location_memorizer_test")
        pid = ServerProxy(master.lookupNode(rospy.resolve_name("location_memorizer"))).getPid("/test")[2]
        publisher.unregister()
        os.kill(pid, signal.SIGKILL)
        wait_until(lambda: self.is_another(pid), message="the node does not return")
        for words in ("The Office", ODD_WORDS):
            answer = self.ask(words)
            self.assertTrue(answer.success, words)
            self.assertEqual((answer.pose.header.frame_id, answer.pose.pose.position.x), ("map", 2.5))

    def is_another(self, pid: int) -> bool:
        try:
            uri = rosgraph.Master("/test").lookupNode(rospy.resolve_name("location_memorizer"))
            return ServerProxy(uri).getPid("/test")[2] != pid and self.ask("office").success
        except (OSError, rosgraph.MasterException, rospy.ServiceException):
            return False


if __name__ == "__main__":
    import rostest

    rospy.init_node("location_memorizer_test")
    rostest.rosrun("location_memorizer", "location_memorizer_test", LocationMemorizerTest)
