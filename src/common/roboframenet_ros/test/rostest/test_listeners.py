#!/usr/bin/python3
"""Who listens to a topic: nobody waits for a listener that was killed, and everybody for one that hangs."""

import signal
import subprocess
import sys
import unittest

import rosgraph
import rospy
import rostest
from std_msgs.msg import String

from roboframenet_ros.ros_listeners import has_every_listener
from roboframenet_testing import wait_until

_LISTENER = """
import rospy
from std_msgs.msg import String
rospy.init_node("{name}")
rospy.Subscriber("{topic}", String, lambda _: None)
rospy.spin()
"""


class ListenersTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_listeners")

    def listener(self, name, topic):
        """Run a listener; returns its process when the master knows it."""
        process = subprocess.Popen([sys.executable, "-c", _LISTENER.format(name=name, topic=topic)])
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        wait_until(lambda: f"/{name}" in self.known_listeners(topic))
        return process

    def known_listeners(self, topic):
        return dict(rosgraph.Master(rospy.get_name()).getSystemState()[1]).get(f"/{topic}", ())

    def test_nobody_may_still_come(self):
        self.assertFalse(has_every_listener(rospy.Publisher("nobody", String, queue_size=1)))

    def test_listener_that_was_killed_is_not_waited_for(self):
        self.listener("living", "killed")
        dead = self.listener("dead", "killed")
        dead.kill()
        dead.wait()
        publisher = rospy.Publisher("killed", String, queue_size=1)
        wait_until(lambda: has_every_listener(publisher))
        self.assertIn("/dead", self.known_listeners("killed"))
        self.assertEqual(1, publisher.get_num_connections())

    def test_listener_that_hangs_is_waited_for(self):
        self.listener("quick", "hung")
        slow = self.listener("slow", "hung")
        slow.send_signal(signal.SIGSTOP)
        publisher = rospy.Publisher("hung", String, queue_size=1)
        wait_until(lambda: publisher.get_num_connections() == 1)
        self.assertFalse(has_every_listener(publisher))
        slow.send_signal(signal.SIGCONT)
        wait_until(lambda: has_every_listener(publisher))


if __name__ == "__main__":
    rostest.rosrun("roboframenet_ros", "listeners", ListenersTest)
