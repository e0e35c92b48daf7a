#!/usr/bin/python3
"""Neither a listener of `reply` that was killed, nor a stop server that was started anew, doubles a reply."""

import collections
import os
import signal
import subprocess
import sys
import time
import unittest

import rosgraph
import rospy
import rostest
from roboframenet_msgs.msg import Reply
from std_msgs.msg import Duration, String

from roboframenet_ros.untaken_texts import TOLD_S
from roboframenet_testing import wait_until
from roboframenet_testing.ros_processes import process_of

_LISTENER = """
import rospy
from roboframenet_msgs.msg import Reply
rospy.init_node("killed_listener")
rospy.Subscriber("reply", Reply, lambda _: None)
rospy.spin()
"""
#: From a text to the kill, seconds: before and after the command server has told that it took the text.
DELAYS_S = (0.005, 0.015)
#: So long after the start of the command server, both have replied to all that they are going to.
ANSWERED_S = 13.0
#: Within so long after it hears texts, a node hears the others, seconds.
CONNECTED_S = 2.0


class DeadListenerTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_dead_listener")
        cls.replies, cls.starts = [], []
        cls.text = rospy.Publisher("text", String, queue_size=10)
        cls.subscribers = [
            rospy.Subscriber("reply", Reply, cls.replies.append),
            rospy.Subscriber("command_server_started", Duration, cls.starts.append),
        ]
        cls.wait_for_nodes()
        process = subprocess.Popen([sys.executable, "-c", _LISTENER])
        wait_until(lambda: "/killed_listener" in cls.known_listeners())
        process.kill()
        process.wait()

    @classmethod
    def known_listeners(cls):
        return dict(rosgraph.Master(rospy.get_name()).getSystemState()[1]).get("/reply", ())

    @classmethod
    def wait_for_nodes(cls):
        wait_until(
            lambda: cls.text.get_num_connections() == 2 and cls.subscribers[0].get_num_connections() == 2,
            message="the nodes are not there",
        )

    @staticmethod
    def is_another(node, pid):
        try:
            return process_of(node) != pid
        except (OSError, rospy.ROSException):
            return False

    def test_1_stop_server_that_was_started_anew_takes_nothing_for_unheard(self):
        self.wait_for_nodes()
        pid = process_of("stop_server")
        os.kill(pid, signal.SIGKILL)
        said, end_s = [], None
        # It hears texts before it hears what becomes of them, or the other way round.
        while end_s is None or time.monotonic() < end_s:
            said.append(f"Turn left {len(said) + 1} degrees.")
            self.text.publish(said[-1])
            time.sleep(0.02)
            if end_s is None and self.is_another("stop_server", pid):
                end_s = time.monotonic() + CONNECTED_S
        time.sleep(TOLD_S)
        told = [reply for reply in self.replies if reply.command.text in said and reply.stage == "stop_server"]
        self.assertEqual([], [(reply.command.text, reply.code) for reply in told])

    def test_2_one_reply_each(self):
        texts = [f"Turn right {120 + number} degrees." for number in range(len(DELAYS_S))]
        for text, delay_s in zip(texts, DELAYS_S):
            self.wait_for_nodes()
            pid = process_of("command_server")
            del self.starts[:]
            self.text.publish(text)
            time.sleep(delay_s)
            os.kill(pid, signal.SIGKILL)
            wait_until(lambda: bool(self.starts), message="the command server does not come back")
            time.sleep(ANSWERED_S)
            with self.subTest(delay_s=delay_s):
                told = [
                    (reply.stage, reply.code, reply.stamp.to_sec())
                    for reply in self.replies
                    if reply.command.text == text
                ]
                self.assertEqual(["RESTARTED"], [code for _, code, _ in told], told)
        self.assertIn("/killed_listener", self.known_listeners())
        counts = collections.Counter(reply.command.id for reply in self.replies)
        self.assertEqual({1}, set(counts.values()))


if __name__ == "__main__":
    rostest.rosrun("stop_server", "dead_listener", DeadListenerTest)
