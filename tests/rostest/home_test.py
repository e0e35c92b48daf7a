#!/usr/bin/python3
"""Sentences act in the home: text, pipeline, servers, actions, and the truth afterwards."""

import json
import sys
import threading
import unittest

import rospy
import rostest
from roboframenet_msgs.msg import Reply
from std_msgs.msg import String

from roboframenet_rostest import say, wait_for_pipeline
from roboframenet_testing.waiting import wait_until

#: Sentence, outcome, and what is true in the home afterwards.
SENTENCES = (
    ("bring me the newspaper", Reply.DONE, {"newspaper.place": "held alice"}),
    ("Chop the cucumber.", Reply.DONE, {"cucumber.form": "chopped", "fridge.is_open": False}),
    ("shut the window", Reply.FAILED, {"robot.arm": "tucked"}),
    ("Go to the office.", Reply.DONE, {"robot.room": "office"}),
    ("open the fridge", Reply.DONE, {"fridge.is_open": True}),
    ("turn the fan on", Reply.DONE, {"fan.is_on": True}),
    # What may do harm wants a yes.
    ("turn the fan off", Reply.NEEDS_INFORMATION, {"fan.is_on": True}),
    ("No.", Reply.REFUSED, {"fan.is_on": True}),
    ("turn the fan off", Reply.NEEDS_INFORMATION, {"fan.is_on": True}),
    ("Yes.", Reply.DONE, {"fan.is_on": False}),
    ("lead Bob to the kitchen", Reply.DONE, {"bob.room": "kitchen", "robot.room": "kitchen"}),
)


class TestHomeServers(unittest.TestCase):
    """The node home_servers with the home and the whole pipeline."""

    @classmethod
    def setUpClass(cls):
        cls.truth = {}
        cls.changed = threading.Event()
        cls.subscriber = rospy.Subscriber("home/truth", String, cls._on_truth, queue_size=1)
        wait_for_pipeline(["navigating_to_location", "bringing", "chopping", "guiding"])

    @classmethod
    def _on_truth(cls, message):
        cls.truth = json.loads(message.data)["truth"]

    def test_sentences(self):
        for text, outcome, expected in SENTENCES:
            with self.subTest(text=text):
                # Seconds of ROS time, of which twenty pass in one second.
                reply = say(text, timeout_s=2400.0)
                self.assertEqual(reply.outcome, outcome, reply.sentence)
                wait_until(
                    lambda expected=expected: expected.items() <= self.truth.items(), message=f"{text}: {expected}"
                )
                if outcome == Reply.FAILED:
                    self.assertIn("have not seen", reply.sentence)


if __name__ == "__main__":
    rospy.init_node("home_test")
    rostest.rosrun("roboframenet_tests", "home", TestHomeServers, sys.argv)
