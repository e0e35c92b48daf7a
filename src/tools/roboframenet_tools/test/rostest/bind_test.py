#!/usr/bin/python3
"""``rfn bind`` reads the type of what runs."""

import os
import subprocess
import tempfile
import unittest

import actionlib
import rospy
import rostest
from actionlib_tutorials.msg import FibonacciAction
from move_base_msgs.msg import MoveBaseAction
from std_srvs.srv import SetBool

from frame_bindings.binding_file import Kind, load_bindings


def bind(*words: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(["rfn", "bind", *words], capture_output=True, text=True, timeout=120, check=False)


class BindTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.server = actionlib.SimpleActionServer("drive_base", MoveBaseAction, lambda _goal: None, auto_start=False)
        cls.server.start()
        # A client with a type of its own must not be believed.
        cls.client = actionlib.SimpleActionClient("drive_base", FibonacciAction)
        cls.service = rospy.Service("set_light", SetBool, lambda _request: (True, ""))

    def test_binding_has_the_type_of_the_server(self) -> None:
        ended = bind("drive_base", "--frame", "navigating_to_location")
        # The names differ, so a person has to look at it.
        self.assertEqual(1, ended.returncode, ended.stderr)
        self.assertIn("I only guess target_pose by 'goal'", ended.stderr)
        text = ended.stdout.replace("# target_pose", "target_pose")
        (binding,) = load_bindings(text, "standard output").bindings
        self.assertEqual((Kind.ACTION, "move_base_msgs/MoveBaseAction"), (binding.kind, binding.type_name))
        self.assertEqual({"target_pose": "goal"}, binding.fields)

    def test_frames_that_fit_are_listed(self) -> None:
        ended = bind("drive_base")
        self.assertEqual(2, ended.returncode)
        self.assertIn("navigating_to_location", ended.stderr)
        self.assertLessEqual(ended.stderr.count(","), 4)

    def test_service_and_file(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bindings.yaml")
            bind("set_light", "--frame", "pinging", "--out", path)
            with open(path, encoding="utf-8") as file:
                (binding,) = load_bindings(file.read(), path).bindings
            self.assertEqual((Kind.SERVICE, "std_srvs/SetBool"), (binding.kind, binding.type_name))
            self.assertEqual(
                ("success", "message"), (binding.result_names.success_field, binding.result_names.text_field)
            )
            self.assertEqual(2, bind("set_light", "--frame", "pinging", "--out", path).returncode)

    def test_unknown_names_are_said(self) -> None:
        ended = bind("drive_bass", "--frame", "pinging")
        self.assertEqual(6, ended.returncode)
        self.assertIn("did you mean /drive_base?", ended.stderr)
        self.assertIn("did you mean pinging?", bind("drive_base", "--frame", "pining").stderr)


if __name__ == "__main__":
    rospy.init_node("bind_test")
    rostest.rosrun("roboframenet_tools", "bind", BindTest)
