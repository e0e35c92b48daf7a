#!/usr/bin/python3
"""A goal that a recording repeats beside the node of a fleet is for nobody."""

import time
import unittest

import rospy
import rostest
from actionlib_msgs.msg import GoalID
from roboframenet_msgs.msg import ExecuteCommandActionGoal, Reply

from roboframenet_testing import wait_until

#: Older than what is said now, seconds.
OLD_S = 60.0


class FleetNodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_fleet_node")
        cls.replies = []
        cls.subscriber = rospy.Subscriber("reply", Reply, cls.replies.append)
        cls.goals = rospy.Publisher("command/goal", ExecuteCommandActionGoal, queue_size=10)
        wait_until(lambda: cls.goals.get_num_connections() == 1 and cls.subscriber.get_num_connections() == 1)

    def answer_to(self, goal_id, text, *, age_s=0.0):
        """Send a goal until it is answered: for some seconds, actionlib itself drops one that it knows.

        Returns:
            what its id begins with, and its code
        """
        before = len(self.replies)
        goal = ExecuteCommandActionGoal(goal_id=GoalID(id=goal_id, stamp=rospy.Time.now() - rospy.Duration(age_s)))
        goal.goal.text = text

        def is_answered():
            self.goals.publish(goal)
            time.sleep(0.5)
            return len(self.replies) > before

        wait_until(is_answered)
        ((answered_id, code),) = [(reply.command.id, reply.code) for reply in self.replies[before:]]
        return answered_id.split("-")[0], code

    def test_goal_is_taken_once(self):
        self.assertEqual(("goal_1", "NO_ROBOT"), self.answer_to("goal_1", "Turn left."))
        self.assertEqual(("replayed", "REPLAYED"), self.answer_to("goal_1", "Turn left."))

    def test_goal_that_is_old_is_late(self):
        self.assertEqual(("goal_2", "LATE"), self.answer_to("goal_2", "Turn left.", age_s=OLD_S))

    def test_stop_is_a_stop_whoever_repeats_it(self):
        for _ in range(2):
            self.assertEqual(("goal_3", "NO_ROBOT"), self.answer_to("goal_3", "Stop.", age_s=OLD_S))


if __name__ == "__main__":
    rostest.rosrun("robot_fleet", "fleet_node", FleetNodeTest)
