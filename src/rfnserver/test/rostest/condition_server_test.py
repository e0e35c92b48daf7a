#!/usr/bin/python3
"""A server that watches: what its feedback says, with which stamps, and when it gives up."""

import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from roboframenet_msgs.msg import (
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameActionFeedback,
    FilledSemanticFrameGoal,
)

from rfnserver import ConditionServer, ConditionUnknown, Observed
from roboframenet_testing import wait_until


class ConditionServerTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("condition_server_test")
        cls.open_doors, cls.is_silent, cls.stamp = set(), False, rospy.Time(5)

        def is_open(frame):
            if cls.is_silent:
                raise ConditionUnknown("/doors is silent")
            if frame["theme"].text == "the cellar":
                return None
            if frame["theme"].text == "the attic":
                return Observed(True, cls.stamp)
            return frame["theme"].text in cls.open_doors

        def while_watched():
            cls.watched.append("begin")
            return lambda: cls.watched.append("end")

        cls.watched = []
        cls.server = ConditionServer("door_watch", is_open, while_watched=while_watched, longest_silence_s=2.0)
        cls.server.start()
        cls.client = actionlib.ActionClient("door_watch", FilledSemanticFrameAction)
        cls.feedback = []
        subscriber = rospy.Subscriber("door_watch/feedback", FilledSemanticFrameActionFeedback, cls.feedback.append)
        assert cls.client.wait_for_server(rospy.Duration(10.0))
        wait_until(lambda: subscriber.get_num_connections() == 1)

    def setUp(self):
        type(self).is_silent = False
        self.open_doors.clear()
        del self.feedback[:]

    def watch(self, theme):
        frame = FilledSemanticFrame(name="being_open", frame_elements=[FilledFrameElement("theme", theme)])
        return self.client.send_goal(FilledSemanticFrameGoal(frame=frame))

    def feedback_about(self, handle):
        goal_id = handle.comm_state_machine.action_goal.goal_id.id
        return [one for one in list(self.feedback) if one.status.goal_id.id == goal_id]

    def said(self, handle):
        """What was said about a goal, without repetitions."""
        said = [one.feedback.is_succeeding for one in self.feedback_about(handle)]
        return [one for place, one in enumerate(said) if place == 0 or said[place - 1] != one]

    def end(self, *handles):
        for handle in handles:
            handle.cancel()
        # A cancel that overtakes its goal recalls it.
        ends = (GoalStatus.PREEMPTED, GoalStatus.RECALLED)
        wait_until(lambda: all(handle.get_goal_status() in ends for handle in handles))

    def test_says_so_at_once_and_at_each_change(self):
        kitchen, hall = self.watch("the kitchen"), self.watch("the hall")
        wait_until(lambda: self.said(kitchen) == [False] and self.said(hall) == [False])
        self.open_doors.add("the hall")
        wait_until(lambda: self.said(hall) == [False, True])
        self.open_doors.clear()
        wait_until(lambda: self.said(hall) == [False, True, False])
        self.assertEqual([False], self.said(kitchen))
        self.end(kitchen, hall)

    def test_repeats_itself_while_nothing_changes(self):
        handle = self.watch("the kitchen")
        wait_until(lambda: len(self.feedback_about(handle)) >= 3)
        self.assertEqual([False], self.said(handle))
        self.end(handle)

    def test_repeats_more_conditions_than_a_topic_keeps(self):
        handles = [self.watch(f"door {number}") for number in range(60)]
        wait_until(lambda: all(len(self.feedback_about(handle)) >= 3 for handle in handles))
        self.assertEqual(60 * [[False]], [self.said(handle) for handle in handles])
        self.end(*handles)

    def test_keeps_the_stamp_of_the_source(self):
        handle = self.watch("the attic")
        wait_until(lambda: bool(self.feedback_about(handle)))
        self.assertEqual(self.stamp, self.feedback_about(handle)[0].header.stamp)
        self.end(handle)

    def test_gives_up_when_nobody_can_tell(self):
        handle = self.watch("the kitchen")
        wait_until(lambda: self.said(handle) == [False])
        type(self).is_silent = True
        wait_until(lambda: handle.get_goal_status() == GoalStatus.ABORTED)
        self.assertEqual("/doors is silent", handle.get_goal_status_text())

    def test_says_nothing_before_it_knows(self):
        cellar, kitchen = self.watch("the cellar"), self.watch("the kitchen")
        wait_until(lambda: len(self.feedback_about(kitchen)) >= 3)
        self.assertEqual(([], [False]), (self.said(cellar), self.said(kitchen)))
        self.end(cellar, kitchen)

    def test_knows_when_somebody_watches(self):
        wait_until(lambda: not self.server._is_asking and self.watched[-1:] != ["begin"])
        del self.watched[:]
        one, two = self.watch("the kitchen"), self.watch("the hall")
        wait_until(lambda: self.said(one) == [False] and self.said(two) == [False])
        self.assertEqual(["begin"], self.watched)
        self.end(one, two)
        wait_until(lambda: self.watched == ["begin", "end"])

    def test_watches_again_after_a_pause(self):
        self.end(self.watch("the kitchen"))
        wait_until(lambda: not self.server._is_asking)
        handle = self.watch("the kitchen")
        wait_until(lambda: self.said(handle) == [False])
        self.end(handle)


if __name__ == "__main__":
    rostest.rosrun("rfnserver", "condition_server", ConditionServerTest)
