#!/usr/bin/python3
"""A PR2 and a Turtlebot act in one home, each with a pipeline of its own."""

import json
import subprocess
import sys
import threading
import unittest

import rospy
import rostest
from roboframenet_msgs.msg import FrameServers, Reply
from std_msgs.msg import String

from roboframenet_rostest import say, wait_for_pipeline
from roboframenet_testing.waiting import wait_until

GUEST = "turtlebot"
#: To whom it is said, the sentence, the outcome, and what is true in the home afterwards.
SENTENCES = (
    (GUEST, "Go to the kitchen.", Reply.DONE, {"turtlebot.room": "kitchen", "robot.room": "hall"}),
    ("", "Go to the office.", Reply.DONE, {"robot.room": "office", "turtlebot.room": "kitchen"}),
    ("", "Take the blue mug.", Reply.DONE, {"robot.holds": "blue_mug"}),
    # It has no hands.
    (GUEST, "Take the spoon.", Reply.REFUSED, {"spoon.place": "on kitchen_table"}),
    (GUEST, "Turn left 90 degrees.", Reply.DONE, {"turtlebot.room": "kitchen"}),
    (GUEST, "Go to Bob.", Reply.DONE, {"turtlebot.room": "office"}),
    (GUEST, "Guide Bob to the hall.", Reply.DONE, {"bob.room": "hall", "turtlebot.room": "hall"}),
    ("", "Put the mug on the kitchen table.", Reply.DONE, {"blue_mug.place": "on kitchen_table"}),
    (GUEST, "If you are in the hall, say hello.", Reply.DONE, {"turtlebot.room": "hall"}),
    (GUEST, "Tell Alice a joke.", Reply.DONE, {}),
    (GUEST, "Patrol the hall.", Reply.DONE, {"turtlebot.room": "hall"}),
    (GUEST, "Move forward half a metre.", Reply.DONE, {}),
)
#: Questions to the Turtlebot, and a part of the answer.
QUESTIONS = (
    ("Who are you?", "I am"),
    ("Where are you?", "hall"),
    ("What can you do?", "You can say"),
    ("Where is Bob?", "hall"),
)


class TestTwoRobots(unittest.TestCase):
    """Two pipelines and one home."""

    @classmethod
    def setUpClass(cls):
        cls.truth = {}
        cls.frames = set()
        cls.subscribers = [
            rospy.Subscriber("home/truth", String, cls._on_truth, queue_size=1),
            rospy.Subscriber(f"{GUEST}/frame_servers", FrameServers, cls._on_servers, queue_size=1),
        ]
        cls.text = rospy.Publisher(f"{GUEST}/text", String, queue_size=5)
        wait_for_pipeline(["navigating_to_location", "bringing", "placing", "guiding"])
        wanted = {"navigating_to_location", "guiding", "telling", "turning", "question_of_place", "condition_of_place"}
        wait_until(lambda: wanted <= cls.frames, 120.0, "the servers of the Turtlebot are missing")
        wait_until(lambda: cls.text.get_num_connections() > 1, 60.0, "the Turtlebot does not hear")

    @classmethod
    def _on_truth(cls, message):
        cls.truth = json.loads(message.data)["truth"]

    @classmethod
    def _on_servers(cls, message):
        cls.frames |= {one.frame_name for one in message.callbacks if one.is_alive}

    def _becomes(self, expected, text):
        wait_until(lambda: expected.items() <= self.truth.items(), 30.0, f"{text}: {expected}")

    def test_1_sentences(self):
        for robot, text, outcome, expected in SENTENCES:
            with self.subTest(robot=robot, text=text):
                reply = say(text, timeout_s=600.0, robot=robot)
                print(f"{robot or 'pr2'}: {text}: {reply.code}: {reply.sentence}", flush=True)
                self.assertEqual(reply.outcome, outcome, reply.sentence)
                self._becomes(expected, text)

    def test_2_questions(self):
        for text, part in QUESTIONS:
            with self.subTest(text=text):
                reply = say(text, robot=GUEST)
                print(f"{GUEST}: {text}: {reply.sentence}", flush=True)
                self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
                self.assertIn(part, reply.sentence)

    def test_3_both_at_once(self):
        replies = {}

        def tell(robot, text):
            replies[robot] = say(text, timeout_s=600.0, robot=robot)

        said = {"": "Go to the bedroom.", GUEST: "Go to the living room."}
        threads = [threading.Thread(target=tell, args=one) for one in said.items()]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(600.0)
        self.assertEqual({robot: reply.outcome for robot, reply in replies.items()}, dict.fromkeys(said, Reply.DONE))
        self._becomes({"robot.room": "bedroom", "turtlebot.room": "living_room"}, "both")

    def test_4_a_stop_is_for_one_of_them(self):
        replies = {}

        def go_on():
            replies["pr2"] = say("Go to the kitchen.", timeout_s=600.0)

        thread = threading.Thread(target=go_on)
        thread.start()
        stopped = threading.Timer(1.0, lambda: self.text.publish("Stop."))
        stopped.start()
        reply = say("Go to the garage.", timeout_s=600.0, robot=GUEST)
        thread.join(600.0)
        stopped.join()
        self.assertEqual(reply.code, "STOPPED", reply.sentence)
        self.assertEqual(replies["pr2"].outcome, Reply.DONE, replies["pr2"].sentence)
        self._becomes({"robot.room": "kitchen"}, "the PR2 goes on")

    def test_5_rfn_list_counts_them(self):
        shown = subprocess.run(
            ["rosrun", "roboframenet_tools", "rfn", "list"], stdout=subprocess.PIPE, check=True, timeout=120
        ).stdout.decode()
        print(shown, flush=True)
        self.assertIn("2 (turtlebot, pr2)", shown)
        rows = [line.split() for line in shown.split("\n\n")[0].splitlines()[1:]]
        self.assertEqual([row for row in rows if row[-1] == "0"], [])


if __name__ == "__main__":
    rospy.init_node("two_robots_test")
    rostest.rosrun("roboframenet_tests", "home_two_robots", TestTwoRobots, sys.argv)
