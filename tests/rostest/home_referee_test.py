#!/usr/bin/python3
"""A referee judges commands in the home, by their annotations alone."""

import os
import re
import sys
import unittest

import rospy
import rostest

sys.path.append(os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "unit"))
from home_referee.annotated import read_annotated, slots_of
from home_referee.commands import draw
from home_referee.judging import Verdict, judge, table
from roboframenet_msgs.msg import Reply

from home_runs import RosRuns
from roboframenet_rostest import say, wait_for_pipeline
from roboframenet_testing.waiting import wait_until

SPEAKER = "alice"
#: Sentence, outcome, and what the reply says.
ABOUT_THE_WORLD = (
    ("Who am I?", Reply.DONE, "You are Alice"),
    ("Where is Bob?", Reply.DONE, "^(?!I do not know Bob)"),
    ("Where is Anna?", Reply.DONE, "^(?!I do not know Anna)"),
    ("Bring them to Anna.", Reply.NEEDS_INFORMATION, "them"),
    ("Look for my keys.", Reply.DONE, "on the hall table"),
    ("Bring them to Anna.", Reply.DONE, "Done"),
    ("Do you have them?", Reply.DONE, "^No.* held by Anna"),
    ("Cut the bread.", Reply.DONE, "Done"),
    ("What are you holding?", Reply.DONE, "I hold nothing"),
    ("Reduce the speed.", Reply.FAILED, "I know of no speed"),
    ("Open the door.", Reply.NEEDS_INFORMATION, "Which door, the .* door"),
    ("No.", Reply.REFUSED, "nothing"),
)


class TestHomeReferee(unittest.TestCase):
    """The whole graph and the home."""

    def test_commands(self):
        """No state that nobody asked for, and so many right as the parameter says."""
        folder = rospy.get_param("~folder", "")
        if folder and not os.path.isdir(folder):
            self.skipTest(f"no grammars in {folder}")
        slots = slots_of(folder, speaker=SPEAKER)
        count, only = rospy.get_param("~count", 5), rospy.get_param("~only", "")
        first, last = rospy.get_param("~first", 0), rospy.get_param("~last", -1)
        if folder:
            commands, _ = draw(folder, slots, count=count, seed=rospy.get_param("~seed", 11))
        else:
            commands = read_annotated()[:count]
        wait_for_pipeline(["navigating_to_location", "taking", "bringing", "placing", "guiding", "telling"])
        runs = RosRuns(SPEAKER)
        judged = []
        for index, command in enumerate(commands):
            if only.lower() not in command.text.lower() or index < first or index > last >= 0:
                continue
            judged.append(judge(runs.run(command), slots))
            now = judged[-1]
            reasons = " | ".join(now.reasons)
            print(f"{index} {now.verdict.value}: {command.text}: {now.run.outcome}: {reasons}", flush=True)
        print(table(judged), flush=True)
        wrong = [one.run.command.text for one in judged if one.verdict is Verdict.WRONG]
        untold = [one.run.command.text for one in judged if one.verdict is Verdict.UNTOLD]
        right = sum(one.verdict is Verdict.RIGHT for one in judged)
        self.assertEqual(wrong, [])
        self.assertEqual(untold, [])
        self.assertGreaterEqual(right, rospy.get_param("~least_right", 1.0) * len(judged))

    def test_belongings_found_given_and_held_are_known(self):
        """ "My keys", "them" and "it" are what was found and given away; whom the robot serves and seeks is known."""
        if rospy.get_param("~folder", "") or rospy.get_param("~only", ""):
            self.skipTest("these commands are not drawn from grammars")
        wait_for_pipeline(["bringing", "locating", "cutting_food", "question_of_speaker", "question_of_place"])
        runs = RosRuns(SPEAKER)
        runs.arrange({})
        for text, outcome, expected in ABOUT_THE_WORLD:
            if text.endswith("?"):
                # What the robot sees comes to the world model a moment after the deed has ended.
                wait_until(lambda said=text, told=expected: re.search(told, say(said).sentence), message=text)
            reply = say(text, timeout_s=2400.0)
            self.assertEqual((reply.outcome, text), (outcome, text), reply.sentence)
            self.assertRegex(reply.sentence, expected, text)
        wait_until(lambda: runs.truth.get("keys.place") == "held anna", message=runs.truth.get("keys.place"))
        self.assertEqual((runs.truth.get("knife.place"), runs.truth.get("bread.form")), ("in drawer", "cut"))


if __name__ == "__main__":
    rospy.init_node("home_referee_test")
    rostest.rosrun("roboframenet_tests", "home_referee", TestHomeReferee, sys.argv)
