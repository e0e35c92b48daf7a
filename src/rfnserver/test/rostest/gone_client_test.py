#!/usr/bin/python3
"""What a server does when the process that sent its goal is killed."""

import os
import signal
import subprocess
import sys
import threading
import unittest
from typing import Any

import rospy
from actionlib_tutorials.msg import FibonacciAction

from rfnserver import RFNServer
from roboframenet_testing import wait_until

_PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "frame_client.py")


class GoneClientTest(unittest.TestCase):
    """Each test has a server that is busy until it is cancelled, and a client in a process of its own."""

    def setUp(self) -> None:
        self.is_cancelled = threading.Event()
        self.addCleanup(self.is_cancelled.set)

    def serve(self, *args: Any, **kwargs: Any) -> RFNServer:
        server = RFNServer(*args, **kwargs)
        server.register_preempt_callback(self.is_cancelled.set)
        return server

    def be_busy(self, _goal: Any) -> None:
        self.is_cancelled.wait(60.0)

    def send_and_die(self, server: RFNServer, name: str, kind: str) -> None:
        with subprocess.Popen([sys.executable, _PROGRAM, name, kind]) as client:
            try:
                wait_until(server.is_active)
                if kind != "topic":
                    status = server.action_server.status_pub
                    wait_until(lambda: status.get_num_connections() == 1)
                # The server looks five times a second who listens.
                self.assertFalse(self.is_cancelled.wait(1.0))
            finally:
                client.send_signal(signal.SIGKILL)

    def test_goal_of_a_frame_is_cancelled(self) -> None:
        server = self.serve("waving", self.be_busy)
        server.start()
        self.send_and_die(server, "waving", "frame")
        self.assertTrue(self.is_cancelled.wait(10.0))
        wait_until(lambda: not server.is_active())

    def test_goal_of_a_frame_that_was_only_published_goes_on(self) -> None:
        server = self.serve("bowing", self.be_busy)
        server.start()
        self.send_and_die(server, "bowing", "topic")
        self.assertFalse(self.is_cancelled.wait(1.5))
        self.assertTrue(server.is_active())

    def test_goal_of_an_ordinary_client_goes_on_as_with_actionlib(self) -> None:
        server = self.serve("fibonacci", FibonacciAction, execute_cb=self.be_busy, auto_start=False)
        server.start()
        self.send_and_die(server, "fibonacci", "fibonacci")
        self.assertFalse(self.is_cancelled.wait(1.5))
        self.assertTrue(server.is_active())


if __name__ == "__main__":
    import rostest

    rospy.init_node("gone_client_test")
    rostest.rosrun("rfnserver", "gone_client", GoneClientTest)
