#!/usr/bin/python3
"""One truthful reply, and a robot that stands: the executor, a source or the master is killed while a plan runs.

The parameter ``~cases`` names what is killed: "SEQUENCE master finish", "UNTIL source"; see kill_in_plan.py. A command
is done although the master hangs ("SEQUENCE hang"), and what goes on without a master ends with its commander.
"""

import json
import os
import subprocess
import sys
import unittest

import rospy
import rostest
from kill_in_plan import PLANS, WATCHING
from roboframenet_msgs.msg import Reply

SCRIPT = os.path.join(os.path.dirname(os.path.realpath(__file__)), "kill_in_plan.py")
#: What is done of each plan, by its own words, when the leaf that runs has ended.
FINISHED = {
    "DO": (Reply.DONE, "DONE", "Done."),
    "FALLBACK": (Reply.DONE, "DONE", "Done."),
    "REPEAT": (Reply.FAILED, "MASTER_LOST", 'I did "go on". I do not repeat "go on".'),
    "WAIT": (Reply.FAILED, "MASTER_LOST", 'The ROS master is gone. I did not begin "what follows".'),
    "PARALLEL": (Reply.FAILED, "MASTER_LOST", 'I did "go on" and "what follows". I did not begin "what follows".'),
}
AS_A_REST = (Reply.FAILED, "MASTER_LOST", 'I did "go on". I did not begin "what follows".')


def every_case():
    """Every kind of node with every victim that it has."""
    cases = [f"{kind} executor" for kind in PLANS] + [f"{kind} source" for kind in WATCHING]
    return cases + [f"{kind} master {how}" for kind in PLANS for how in ("finish", "stop")]


class KillsTest(unittest.TestCase):
    def killed(self, case):
        process = subprocess.run(
            [sys.executable, SCRIPT, *case.split()], capture_output=True, text=True, timeout=120, check=False
        )
        self.assertEqual(0, process.returncode, f"{case}: {process.stderr[-2000:]}")
        found = json.loads(process.stdout.splitlines()[-1])
        print(f"{case}: {found}", flush=True)
        return found

    def check(self, case):
        kind, victim, how = [*case.split(), ""][:3]
        found = self.killed(case)
        if victim == "commander":
            self.assertIn("one preempted last", found["ended"], case)
            return
        self.assertEqual(1, len(found["replies"]), case)
        reply = found["replies"][0]
        told = (reply["outcome"], reply["code"])
        if victim == "hang":
            self.assertEqual((Reply.DONE, "DONE"), told, reply["sentence"])
            return
        self.assertEqual([], found["begun"], case)
        if victim == "master":
            outcome, code, sentence = (
                FINISHED.get(kind, AS_A_REST) if how == "finish" else (Reply.FAILED, "MASTER_LOST", "")
            )
            self.assertEqual((outcome, code), told, case)
            self.assertIn(sentence, reply["sentence"], case)
            if kind != "WAIT":
                self.assertIn("one ends last" if how == "finish" else "one preempted last", found["ended"], case)
            return
        expected = (Reply.FAILED, "STAGE_SILENT" if victim == "executor" else "CONDITION_UNKNOWN")
        self.assertEqual(expected, told, case)
        if kind != "WAIT":
            # The robot stands.
            self.assertIn("one preempted last", found["ended"], case)
        if victim == "source":
            self.assertIn('whether "it is so"', reply["sentence"])

    def test_kills(self):
        cases = rospy.get_param("~cases")
        for case in every_case() if cases == "all" else cases:
            with self.subTest(case=case):
                self.check(case)


if __name__ == "__main__":
    rospy.init_node("test_kills")
    rostest.rosrun("executor", "kills", KillsTest)
