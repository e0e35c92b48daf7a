#!/usr/bin/python3
"""Sentences that differ in one small word, said to a simulated robot: it does two things, or says what it cannot do.

The pairs are those of ``small_words.tsv`` of offline_pipeline. A robot that cannot tell the two sentences of a pair
apart must say so in its reply to one of them, and not do the same for both.
"""

import math
import random
import unittest
from dataclasses import dataclass
from typing import Dict, List, Tuple

import rospy
from dynamic_reconfigure.client import Client
from roboframenet_msgs.msg import Reply
from sensor_msgs.msg import JointState

from roboframenet_demo.node import OUTCOME_NAMES
from roboframenet_demo.ros_conversation import Conversation
from roboframenet_demo.ros_observer import RobotObserver
from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_rostest import can_do
from roboframenet_testing import wait_until
from roboframenet_testing.workspace import package

PAIRS = package("offline_pipeline") / "test" / "unit" / "small_words.tsv"
#: A server that could carry the sentence out is missing: this says nothing about the small word.
ABOUT_SERVERS = "NO_SERVER"
#: Of the sample.
SEED = 5
#: Motions of the same kind that differ by less are the same: metres, radians.
LEAST_M, LEAST_RAD = 0.05, 0.1


@dataclass(frozen=True)
class Deed:
    """What the robot did and said for one sentence."""

    outcome: str
    code: str
    sentence: str
    turned_rad: float
    moved_m: float
    place_m: Tuple[float, float]
    arms: Tuple[float, float]
    said: Tuple[str, ...]

    def differs_from(self, other: "Deed") -> bool:
        """Whether the robot did something else, or said that it cannot do it."""
        if "DONE" not in (self.outcome, other.outcome):
            return self.code != ABOUT_SERVERS and other.code != ABOUT_SERVERS and self.sentence != other.sentence
        if self.outcome != other.outcome:
            return True
        return (
            abs(self.turned_rad - other.turned_rad) > LEAST_RAD
            or abs(self.moved_m - other.moved_m) > LEAST_M
            or math.dist(self.place_m, other.place_m) > LEAST_M
            or any(abs(one - another) > LEAST_RAD for one, another in zip(self.arms, other.arms))
            or self.said != other.said
        )


class SmallWordsTest(unittest.TestCase):
    """Each sentence is said once; pairs share sentences."""

    def setUp(self) -> None:
        self.conversation = Conversation(on_event=lambda event: None)
        self.observer = RobotObserver()
        self.joints: Dict[str, List[float]] = {}
        self.subscriber = rospy.Subscriber("joint_states", JointState, self.on_joints, queue_size=50)

    def on_joints(self, message: JointState) -> None:
        for name, position in zip(message.name, message.position):
            self.joints.setdefault(name, []).append(position)

    def excursion_of(self, side: str) -> float:
        """Return how far a joint of an arm went."""
        moved = [max(seen) - min(seen) for name, seen in list(self.joints.items()) if name.startswith(f"{side}_")]
        return max(moved, default=0.0)

    def deed(self, text: str) -> Deed:
        wait_until(lambda: self.observer.observe().is_still, message="the robot does not stand still")
        self.joints.clear()
        self.observer.begin()
        self.conversation.say(text)
        replies = self.conversation.wait_for_replies([text], 120.0)
        self.assertIn(text, replies)
        wait_until(lambda: self.observer.observe().is_still, message="the robot does not stand still")
        reply: Reply = replies[text]
        seen = self.observer.observe()
        arms = self.excursion_of("l"), self.excursion_of("r")
        outcome = OUTCOME_NAMES[reply.outcome]
        # For a robot that goes to places, the way depends on where it was, and only the end counts.
        goes_to_places = rospy.get_param("~goes_to_places")
        turned_rad, moved_m = (0.0, 0.0) if goes_to_places else (seen.turned_rad, seen.moved_m)
        place_m = seen.position_m if goes_to_places else (0.0, 0.0)
        deed = Deed(outcome, reply.code, reply.sentence, turned_rad, moved_m, place_m, arms, tuple(seen.said))
        print(f"{text:45} {outcome:18} {reply.sentence[:90]:90} {seen.describe()} {arms}", flush=True)
        if outcome in ("REFUSED", "NEEDS_INFORMATION"):
            self.assertLess(max(abs(seen.turned_rad), seen.driven_m, *arms), LEAST_M, f"{text}: refused, but it moved")
        if outcome == "NEEDS_INFORMATION":
            self.conversation.say("No.")
            self.conversation.wait_for_replies(["No."], 60.0)
        return deed

    def test_small_words_change_what_the_robot_does(self) -> None:
        wait_until(is_pipeline_complete, 120.0, "the pipeline did not come up")
        self.assertTrue(can_do(rospy.get_param("~frames")), "the robot did not register")
        self.assertTrue(self.conversation.wait_until_heard(2, 60.0))
        if rospy.has_param("~linear_speed_m_per_s"):
            client = Client("move_action_server", timeout=60.0)
            client.update_configuration({"linear_speed_m_per_s": rospy.get_param("~linear_speed_m_per_s")})
            client.close()
        beginnings = tuple(rospy.get_param("~beginnings"))
        lines = PAIRS.read_text(encoding="utf-8").splitlines()
        pairs = [tuple(line.split("\t")) for line in lines if line.startswith(beginnings)]
        sample = rospy.get_param("~sample")
        if sample:
            pairs = random.Random(SEED).sample(pairs, sample)
        deeds: Dict[str, Deed] = {}
        alike: List[Tuple[str, ...]] = []
        for pair in pairs:
            for text in pair:
                if text not in deeds:
                    deeds[text] = self.deed(text)
            if not deeds[pair[0]].differs_from(deeds[pair[1]]):
                alike.append(pair)
        print(f"{len(pairs) - len(alike)} of {len(pairs)} pairs are told apart", flush=True)
        self.assertEqual(alike, [])
        self.assertGreaterEqual(len(pairs), sample or rospy.get_param("~all"))


if __name__ == "__main__":
    import rostest

    rospy.init_node("small_words_test")
    rostest.rosrun("roboframenet_tests", rospy.get_name().strip("/"), SmallWordsTest)
