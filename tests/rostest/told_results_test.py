#!/usr/bin/python3
"""Ported servers of other robots: what they say in their results is told, and what they do not heed is not done."""

import unittest
from typing import Any, List

from roboframenet_msgs.msg import Reply

from other_actions import FOLLOW_JOINTS, PICK_CUBE
from rfnserver import RFNActionServer, RFNServer
from roboframenet_rostest import say, wait_for_pipeline

FollowJointsGoal, FollowJointsResult = FOLLOW_JOINTS["FollowJointsGoal"], FOLLOW_JOINTS["FollowJointsResult"]
GRIPPER = {"container_portal": ["gripper"]}


class ToldResultsTest(unittest.TestCase):
    """The pipeline, a gripper that picks cubes, and an arm that follows joints."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.picked: List[bool] = []
        cls.positions: List[float] = []
        cls.picker = RFNActionServer("cube_picker", PICK_CUBE["PickCubeAction"], cls.pick, auto_start=False)
        cls.picker.start()
        assert cls.picker.register_with_frame("taking", heeds={"theme": ["cube"]}), cls.picker.last_error
        cls.arm = RFNServer(
            "arm_controller/follow_joints",
            FOLLOW_JOINTS["FollowJointsAction"],
            execute_cb=cls.follow,
            auto_start=False,
            frame_callback=lambda frame: FollowJointsGoal(["gripper"], [3.0 if frame.name == "closing" else 0.1]),
        )
        cls.arm.start()
        wait_for_pipeline(["taking"])

    @classmethod
    def pick(cls, handle: Any) -> None:
        handle.set_accepted()
        cls.picked.append(not cls.picked)
        handle.set_succeeded(PICK_CUBE["PickCubeResult"](success=cls.picked[-1]))

    @classmethod
    def follow(cls, goal: Any) -> None:
        (position,) = goal.positions
        cls.positions.append(position)
        if position > 1.0:
            cls.arm.set_aborted(FollowJointsResult(-1, f"gripper: {position:g} is out of range"))
        else:
            cls.arm.set_succeeded(FollowJointsResult(0, ""))

    def reply_to(self, text: str, code: str) -> str:
        reply = say(text)
        self.assertEqual(code, reply.code, reply.sentence)
        self.assertEqual(code == "DONE", reply.outcome == Reply.DONE)
        return reply.sentence

    def test_success_that_says_false_is_no_success(self) -> None:
        self.reply_to("Pick up the cube.", "DONE")
        sentence = self.reply_to("Pick up the cube.", "ALL_CANDIDATES_FAILED")
        self.assertIn("cube_picker reports a failure", sentence)
        self.assertEqual([True, False], self.picked)
        # It lists what it picks: a bottle is refused before the goal.
        self.reply_to("Pick up the bottle.", "VALUE_NOT_ALLOWED")
        self.assertEqual(2, len(self.picked))

    def test_callback_that_reads_nothing_does_what_the_server_lists(self) -> None:
        self.assertTrue(self.arm.register_with_frame("opening"), self.arm.last_error)
        sentence = self.reply_to("Open the window.", "ALL_CANDIDATES_FAILED")
        self.assertIn('I cannot take the container portal "the window" into account', sentence)
        self.assertEqual([], self.positions)
        self.assertTrue(self.arm.register_with_frame("opening", heeds=GRIPPER), self.arm.last_error)
        self.reply_to("Open the window.", "VALUE_NOT_ALLOWED")
        self.assertEqual([], self.positions)
        self.reply_to("Open the gripper.", "DONE")
        self.assertEqual([0.1], self.positions)
        # In the result alone, the status has no text.
        self.assertTrue(self.arm.register_with_frame("closing", heeds=GRIPPER), self.arm.last_error)
        self.assertIn("gripper: 3 is out of range", self.reply_to("Close the gripper.", "ALL_CANDIDATES_FAILED"))

    def test_table_refuses_the_second_half_before_the_first_is_done(self) -> None:
        table = {"element": "container_portal", "values": {"drawer": "red"}}
        self.assertTrue(
            self.picker.register_with_frame("closing", goal_mapping={"colour": table}), self.picker.last_error
        )
        before = len(self.picked)
        self.reply_to("Pick up the cube and then close the lid.", "VALUE_NOT_ALLOWED")
        self.assertEqual(before, len(self.picked))

    def test_elements_to_ignore_need_no_mapping_and_a_server_of_actions(self) -> None:
        self.assertFalse(self.picker.register_with_frame("opening"))
        self.assertIn("container_portal", self.picker.last_error)
        self.assertTrue(
            self.picker.register_with_frame("opening", ignored_elements=["container_portal"]), self.picker.last_error
        )
        with self.assertRaisesRegex(TypeError, "unheeded"):
            RFNServer("frames_alone", lambda frame: None).register_with_frame("opening", ignored_elements=["degree"])


if __name__ == "__main__":
    import rospy
    import rostest

    rospy.init_node("told_results_test")
    rostest.rosrun("roboframenet_tests", "told_results", ToldResultsTest)
