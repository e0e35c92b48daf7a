#!/usr/bin/python3
"""A referee judges commands in the home, by their annotations alone."""

import os
import sys
import unittest

import rospy
import rostest

sys.path.append(os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "unit"))
from home_referee.annotated import read_annotated, slots_of
from home_referee.commands import draw
from home_referee.judging import Verdict, judge, table

from home_runs import RosRuns
from roboframenet_rostest import wait_for_pipeline

SPEAKER = "alice"


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


if __name__ == "__main__":
    rospy.init_node("home_referee_test")
    rostest.rosrun("roboframenet_tests", "home_referee", TestHomeReferee, sys.argv)
