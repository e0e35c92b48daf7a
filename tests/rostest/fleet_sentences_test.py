#!/usr/bin/python3
"""Addressed sentences, said to three simulated robots: who moves, and what the reply says."""

import unittest
from typing import Tuple

import rospy
from roboframenet_msgs.msg import Reply

from fleet_robots import Robots
from roboframenet_testing import comes_true

ALL = ("alpha", "beta", "gamma")
#: What is said, one after the other; who moves; and the code of the reply.
SENTENCES: Tuple[Tuple[str, Tuple[str, ...], str], ...] = (
    ("Turn left 20 degrees.", (), "WHO"),
    ("Gamma.", ("gamma",), "DONE"),
    ("Alpha, turn left 20 degrees.", ("alpha",), "DONE"),
    ("beta turn right 20 degrees", ("beta",), "DONE"),
    ("Turn left 30 degrees, Gamma.", ("gamma",), "DONE"),
    ("Turn right 30 degrees.", ("gamma",), "DONE"),
    ("Beta and Gamma, turn left 20 degrees.", ("beta", "gamma"), "DONE"),
    ("Move forward 20 centimetres.", ("beta", "gamma"), "DONE"),
    ("The other one, turn right 20 degrees.", ("alpha",), "DONE"),
    ("The others, move back 20 centimetres.", ("beta", "gamma"), "DONE"),
    ("Everybody, turn left 20 degrees.", ALL, "DONE"),
    ("Everybody but Alpha, turn right 20 degrees.", ("beta", "gamma"), "DONE"),
    ("Tell Beta to turn left 20 degrees.", ("beta",), "DONE"),
    ("I want Gamma to turn left 20 degrees.", ("gamma",), "DONE"),
    ("Could Alpha turn left 20 degrees?", ("alpha",), "DONE"),
    ("Alpha, turn left 20 degrees, and Beta, turn right 20 degrees.", ("alpha", "beta"), "DONE"),
    ("Alpha, turn right 20 degrees, then Gamma, turn left 20 degrees.", ("alpha", "gamma"), "DONE"),
    ("Somebody, turn left 20 degrees.", ("alpha",), "DONE"),
    ("Delta, turn left 20 degrees.", (), "UNKNOWN_ROBOT"),
    ("Rosie, turn left 20 degrees.", (), "UNKNOWN_ROBOT"),
    ("Stop Alpha.", (), "DONE"),
    ("Everybody stop.", (), "DONE"),
)


class FleetSentencesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        rospy.init_node("fleet_sentences_test")
        cls.robots = Robots()
        cls.robots.wait_until_ready()

    def test_who_acts(self) -> None:
        wrong = []
        for sentence, robots, code in SENTENCES:
            before = self.robots.turned()
            reply: Reply = self.robots.ask(sentence)
            is_right = comes_true(lambda before=before, robots=robots: self.robots.who_moved(before) == robots, 3.0)
            rospy.loginfo(
                "%s -> %s: %s", sentence, ", ".join(self.robots.who_moved(before)) or "nobody", reply.sentence
            )
            if not is_right or reply.code != code:
                wrong.append((sentence, self.robots.who_moved(before), reply.code, reply.sentence))
        rospy.loginfo("addressed sentences: %d of %d right", len(SENTENCES) - len(wrong), len(SENTENCES))
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    import rostest

    rostest.rosrun("roboframenet_tests", "fleet_sentences_test", FleetSentencesTest)
