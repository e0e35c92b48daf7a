#!/usr/bin/python3
"""A command reaches the next stage, also one that starts after the command was published."""

import subprocess
import sys
import time
import unittest

import rospy
import rostest
from roboframenet_msgs.msg import Command

from roboframenet_ros.ros_hand_over import HandOver
from roboframenet_testing import wait_until

# A subscriber in a process of its own, which can be killed as a stage is.
_LISTENER = """
import rospy
from roboframenet_msgs.msg import Command
rospy.init_node("listener", anonymous=True)
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
        listener = subprocess.Popen([sys.executable, "-c", _LISTENER.format(topic="three")], stdout=subprocess.PIPE)
        self.addCleanup(listener.stdout.close)
        wait_until(lambda: topic.is_connected)
        topic.publish(Command(id="first"))
        self.assertEqual(b"first\n", listener.stdout.readline())
        listener.kill()
        listener.wait(10.0)
        topic.publish(Command(id="orphan"))
        heard = self.heard_by("three")
        wait_until(lambda: heard == ["orphan"])


if __name__ == "__main__":
    rostest.rosrun("roboframenet_ros", "hand_over", HandOverTest)
