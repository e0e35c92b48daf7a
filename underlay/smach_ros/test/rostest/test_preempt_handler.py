#!/usr/bin/python3
"""A program with set_preempt_handler stops its machine at Ctrl-C."""

import os
import signal
import subprocess
import sys
import threading
import unittest

import actionlib
import rospy
import rostest
from actionlib.msg import TestAction


class PreemptHandlerTest(unittest.TestCase):
    def test_interrupt_cancels_the_goal_and_ends_the_nested_containers(self):
        accepted, cancelled = threading.Event(), threading.Event()

        def execute(goal):
            accepted.set()
            if cancelled.wait(30.0):
                server.set_preempted()

        server = actionlib.SimpleActionServer("watched", TestAction, execute, auto_start=False)
        server.register_preempt_callback(cancelled.set)
        server.start()
        program = os.path.join(os.path.dirname(os.path.abspath(__file__)), "nested_machine.py")
        process = subprocess.Popen([sys.executable, program], stdout=subprocess.PIPE, universal_newlines=True)
        try:
            self.assertTrue(accepted.wait(30.0))
            process.send_signal(signal.SIGINT)
            self.assertTrue(cancelled.wait(30.0), "the goal outlives the program")
            output, _ = process.communicate(timeout=30.0)
        finally:
            process.kill()
            process.wait()
        self.assertIn("outcome: preempted", output)


if __name__ == "__main__":
    rospy.init_node("test_preempt_handler")
    rostest.rosrun("smach_ros", "preempt_handler", PreemptHandlerTest)
