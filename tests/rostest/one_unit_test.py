#!/usr/bin/python3
"""One lexical unit of three lines serves every mood: orders, prohibitions, questions, conditions and remarks."""

import json
import unittest
from pathlib import Path
from typing import Any, Dict

import rospy
import yaml
from roboframenet_msgs.msg import Reply
from std_msgs.msg import String

from offline_pipeline.knowledge import shipped_domains
from roboframenet_rostest import say, wait_for_pipeline
from roboframenet_testing import wait_until

#: The commands drive through the home; seconds of ROS time, of which twenty pass in one second.
_MOST_S = 2400.0


class OneUnitTest(unittest.TestCase):
    """The robot of the home docks, and is spoken to about it."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.truth: Dict[str, Any] = {}
        cls.subscriber = rospy.Subscriber("home/truth", String, cls.on_truth, queue_size=1)
        cls.text = rospy.Publisher("text", String, queue_size=10)
        wait_for_pipeline(["docking", "navigating_to_location", "saying", "question_of_event", "condition_of_deed"])
        wait_until(lambda: cls.text.get_num_connections() > 1 and cls.truth)

    @classmethod
    def on_truth(cls, message: String) -> None:
        cls.truth = json.loads(message.data)["truth"]

    def assert_says(self, text: str, outcome: int, *parts: str) -> None:
        reply = say(text, timeout_s=_MOST_S)
        self.assertEqual(outcome, reply.outcome, f"{text} {reply.sentence}")
        for part in parts:
            self.assertIn(part, reply.sentence, text)

    def test_1_unit_has_three_lines(self) -> None:
        (unit,) = yaml.safe_load(Path(shipped_domains(), "devices", "lexical_units", "docking.yaml").read_text())
        self.assertEqual({"frame_name", "verb", "elements", "examples"}, set(unit))

    def test_2_before_it_has_docked(self) -> None:
        self.assertFalse(self.truth["robot.is_docked"])
        for text in ("Did you dock?", "Have you ever docked?", "Are you docked?"):
            self.assert_says(text, Reply.DONE, "No")
        self.assert_says("Are you docking?", Reply.DONE, "No")
        self.assert_says("Are you able to dock?", Reply.DONE, "Yes")
        for text in ("Don't dock.", "Never dock at night."):
            self.assert_says(text, Reply.REFUSED, "You said not to")
        self.assert_says("If you did not dock, say hello.", Reply.DONE)
        self.assert_says("If you have docked, say hello.", Reply.DONE, "not")
        self.assertFalse(self.truth["robot.is_docked"])

    def test_3_orders_dock(self) -> None:
        for text in ("Dock at the charger.", "Could you dock?", "I want you to dock.", "Make sure that you dock."):
            self.assert_says("Go to the bedroom.", Reply.DONE)
            wait_until(lambda: not self.truth["robot.is_docked"])
            self.assert_says(text, Reply.DONE)
            wait_until(lambda: self.truth["robot.is_docked"])

    def test_4_after_it_has_docked(self) -> None:
        for text in ("Did you dock?", "Have you ever docked?", "Are you docked?", "Tell me whether you docked."):
            self.assert_says(text, Reply.DONE, "Yes")
        self.assert_says("When did you dock?", Reply.DONE, "today at")
        self.assert_says("Where did you dock?", Reply.DONE, "charging station")
        self.assert_says("How often did you dock?", Reply.DONE)
        self.assert_says("If you have docked, say hello.", Reply.DONE)
        self.assert_says("If you are not docked, dance.", Reply.DONE, "not")
        self.assert_says("You docked at the wrong charger.", Reply.REFUSED)
        self.assertTrue(self.truth["robot.is_docked"])
        self.assert_says("Go to the bedroom.", Reply.DONE)
        wait_until(lambda: self.truth["robot.room"] == "bedroom")
        self.assert_says("Go to the charger that you opened.", Reply.REFUSED, "Please name it.")
        self.assertEqual("bedroom", self.truth["robot.room"])
        self.assert_says("Go to the charger at which you docked.", Reply.DONE)
        wait_until(lambda: self.truth["robot.room"] != "bedroom")

    def test_5_while_it_docks(self) -> None:
        self.assert_says("Go to the bedroom.", Reply.DONE)
        self.text.publish(String(data="Dock."))
        wait_until(lambda: "Yes" in say("Are you docking?").sentence)
        self.assert_says("What are you doing?", Reply.DONE, "Dock")
        wait_until(lambda: self.truth["robot.is_docked"])

    def test_6_conditions_wait_for_it(self) -> None:
        self.assert_says("Go to the bedroom.", Reply.DONE)
        self.assert_says("Dock, and when you have docked, say hello.", Reply.DONE)
        wait_until(lambda: self.truth["robot.is_docked"])
        self.assert_says("Go to the bedroom.", Reply.DONE)
        self.assert_says("Say hello after you have docked.", Reply.DONE)
        wait_until(lambda: self.truth["robot.is_docked"])


if __name__ == "__main__":
    import rostest

    rospy.init_node("one_unit_test")
    rostest.rosrun("roboframenet_tests", "one_unit", OneUnitTest)
