#!/usr/bin/python3
"""A command reaches the next stage, also one that starts after the command was published."""

import subprocess
import sys
import time
import unittest
from contextlib import contextmanager

import rospy
import rostest
from roboframenet_msgs.msg import Command

from roboframenet_ros.ros_hand_over import HandOver
from roboframenet_testing import wait_until
from roboframenet_testing.ros_connections import is_connected

# A subscriber in a process of its own, which can be killed as a stage is.
_LISTENER = """
import rospy
from roboframenet_msgs.msg import Command
rospy.init_node("listener")
rospy.Subscriber("{topic}", Command, lambda message: print(message.id, flush=True))
rospy.spin()
"""


class HandOverTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_hand_over")

    def heard_by(self, topic):
        heard = []
        subscriber = rospy.Subscriber(topic, Command, lambda message: heard.append(message.id))
        self.addCleanup(subscriber.unregister)
        return heard

    @contextmanager
    def listener(self, topic):
        """Run a subscriber, and kill it at the end."""
        with subprocess.Popen([sys.executable, "-c", _LISTENER.format(topic=topic)], stdout=subprocess.PIPE) as process:
            try:
                yield process
            finally:
                process.kill()

    def test_what_nobody_heard_is_sent_once_to_who_connects(self):
        topic = HandOver("one", Command)
        topic.publish(Command(id="early"))
        heard = self.heard_by("one")
        wait_until(lambda: heard == ["early"])
        topic.publish(Command(id="later"))
        wait_until(lambda: heard == ["early", "later"])
        second = self.heard_by("one")
        topic.publish(Command(id="last"))
        wait_until(lambda: "last" in second)
        self.assertEqual(["last"], second)

    def test_what_is_too_old_is_not_sent(self):
        topic = HandOver("two", Command, max_age_s=0.1)
        topic.publish(Command(id="old"))
        time.sleep(0.2)
        heard = self.heard_by("two")
        wait_until(lambda: topic.is_connected)
        topic.publish(Command(id="new"))
        wait_until(lambda: heard)
        self.assertEqual(["new"], heard)

    def test_a_subscriber_that_was_killed_counts_as_nobody(self):
        topic = HandOver("three", Command)
        with self.listener("three") as listener:
            wait_until(lambda: topic.is_connected)
            topic.publish(Command(id="first"))
            self.assertEqual(b"first\n", listener.stdout.readline())
        topic.publish(Command(id="orphan"))
        heard = self.heard_by("three")
        wait_until(lambda: heard == ["orphan"])

    def test_who_was_killed_and_comes_back_gets_what_only_others_heard(self):
        topic = HandOver("four", Command, max_age_s=120.0)
        heard = self.heard_by("four")
        wait_until(lambda: is_connected(rospy.get_name(), "four", rospy.get_name()))
        topic.publish(Command(id="before"))
        with self.listener("four") as listener:
            wait_until(lambda: is_connected(rospy.get_name(), "four", "/listener"))
            topic.publish(Command(id="first"))
            self.assertEqual(b"first\n", listener.stdout.readline())
        topic.publish(Command(id="orphan"))
        wait_until(lambda: heard == ["before", "first", "orphan"])
        with self.listener("four") as listener:
            self.assertEqual(b"orphan\n", listener.stdout.readline())
            topic.publish(Command(id="last"))
            self.assertEqual(b"last\n", listener.stdout.readline())
        self.assertEqual(["before", "first", "orphan"], heard[:3])


if __name__ == "__main__":
    rostest.rosrun("roboframenet_ros", "hand_over", HandOverTest)
