#!/usr/bin/python3
"""A program with set_preempt_handler stops its machine at Ctrl-C."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import actionlib
import rospy
import rostest
from actionlib.msg import TestAction
from std_msgs.msg import String
from std_srvs.srv import SetBool, SetBoolResponse


class PreemptHandlerTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.accepted, cls.cancelled = threading.Event(), threading.Event()
        cls.server = actionlib.SimpleActionServer("watched", TestAction, cls.execute, auto_start=False)
        cls.server.register_preempt_callback(cls.cancelled.set)
        cls.server.start()
        cls.switched, cls.told = [], []
        rospy.Service("motors", SetBool, lambda request: cls.switched.append(request.data) or SetBoolResponse(True, ""))
        rospy.Subscriber("told", String, lambda message: cls.told.append(message.data))

    @classmethod
    def execute(cls, goal):
        cls.accepted.set()
        if cls.cancelled.wait(30.0):
            cls.server.set_preempted()

    def setUp(self):
        self.accepted.clear()
        self.cancelled.clear()

    def interrupt(self, program):
        """Run a program, interrupt it while its goal runs, return what it prints."""
        path = os.path.join(os.path.dirname(os.path.abspath(__file__)), program)
        process = subprocess.Popen([sys.executable, path], stdout=subprocess.PIPE, universal_newlines=True)
        try:
            self.assertTrue(self.accepted.wait(30.0))
            # Ctrl-C interrupts the main thread; while that starts a state, it holds a lock that the request needs.
            time.sleep(1.0)
            process.send_signal(signal.SIGINT)
            self.assertTrue(self.cancelled.wait(30.0), "the goal outlives the program")
            return process.communicate(timeout=30.0)[0]
        finally:
            process.kill()
            process.wait()

    def test_interrupt_cancels_the_goal_and_ends_the_nested_containers(self):
        self.assertIn("outcome: preempted", self.interrupt("nested_machine.py"))

    def test_cancel_reaches_the_server_before_the_node_goes_down(self):
        self.assertIn("outcome: preempted", self.interrupt("slow_machine.py"))

    def test_states_behind_preempted_run_before_the_node_goes_down(self):
        self.assertIn("outcome: done", self.interrupt("thread_machine.py"))
        self.assertEqual((self.switched, self.told), ([False], ["motors are off"]))


if __name__ == "__main__":
    rospy.init_node("test_preempt_handler")
    rostest.rosrun("smach_ros", "preempt_handler", PreemptHandlerTest)
