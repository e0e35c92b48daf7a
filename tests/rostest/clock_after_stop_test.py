#!/usr/bin/python3
"""A command that is said after a stop is done, though the clock is paused or set back: no reply tells of a stop."""

import threading
import time
import unittest

import rospy
import rostest
from roboframenet_msgs.msg import Reply
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String

from rfnserver import RFNServer
from roboframenet_rostest import wait_for_pipeline
from roboframenet_testing import wait_until

#: How often each case is tried: each depends on what arrives first.
TRIALS = 5
START_S, BACK_S = 1000.0, 100.0
PERIOD_S = 0.01


class SimulatedClock:
    """Publishes simulated time in a thread of its own."""

    def __init__(self):
        self._publisher = rospy.Publisher("/clock", Clock, queue_size=1)
        self.now_s, self.rate = START_S, 1.0
        threading.Thread(target=self._run, daemon=True).start()

    def _run(self):
        while True:
            time.sleep(PERIOD_S)
            self.now_s += PERIOD_S * self.rate
            self._publisher.publish(Clock(clock=rospy.Time.from_sec(self.now_s)))


class ClockAfterStopTest(unittest.TestCase):
    """The pipeline, and one server that is done at once."""

    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_clock_after_stop")
        cls.clock, cls.goals, cls.replies = SimulatedClock(), [], []
        cls.server = RFNServer("clocked", cls.goals.append)
        cls.server.register_with_frame("pinging")
        cls.server.start()
        cls.text = rospy.Publisher("text", String, queue_size=10)
        cls.subscriber = rospy.Subscriber("reply", Reply, cls.replies.append)
        wait_for_pipeline(["pinging"])
        # The command server and the stop server hear it, and both of them reply.
        wait_until(lambda: cls.text.get_num_connections() == 2 and cls.subscriber.get_num_connections() == 2)

    def tearDown(self):
        self.clock.rate = 1.0

    def said(self, text):
        """Say a text; returns its reply."""
        known = len(self.replies)
        self.text.publish(text)
        wait_until(lambda: [reply for reply in self.replies[known:] if reply.command.text == text], message=text)
        return next(reply for reply in self.replies[known:] if reply.command.text == text)

    def assert_done(self, how):
        goals = len(self.goals)
        for number in range(3):
            reply = self.said("Ping.")
            self.assertEqual("DONE", reply.code, f"{how}, command {number}: {reply.sentence}")
        self.assertEqual(goals + 3, len(self.goals), how)

    def stop(self):
        self.assertEqual("DONE", self.said("Stop.").code)

    def test_clock_that_is_paused_after_a_stop(self):
        for _ in range(TRIALS):
            self.stop()
            self.clock.rate = 0.0
            self.assert_done("paused after")
            self.clock.rate = 1.0
            self.assert_done("going on")

    def test_clock_that_is_paused_before_a_stop(self):
        for _ in range(TRIALS):
            self.clock.rate = 0.0
            time.sleep(0.1)
            self.stop()
            self.assert_done("paused before")
            # Twice at the same time.
            self.stop()
            self.assert_done("paused, stopped again")
            self.clock.rate = 1.0

    def test_clock_that_is_set_back_after_a_stop(self):
        for back_s in (BACK_S, 0.5, 2.0, 10.0, 0.05):
            self.stop()
            self.clock.now_s -= back_s
            self.assert_done(f"set back by {back_s} s")

    def test_clock_that_is_set_back_and_paused_after_a_stop(self):
        for back_s in (BACK_S, 1.5):
            self.stop()
            self.clock.now_s -= back_s
            self.clock.rate = 0.0
            self.assert_done(f"set back by {back_s} s, and paused")
            self.clock.rate = 1.0


if __name__ == "__main__":
    rostest.rosrun("roboframenet_tests", "clock_after_stop", ClockAfterStopTest)
