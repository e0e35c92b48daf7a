#!/usr/bin/python3
"""A bag that is played beside the robot commands nothing, and is told on `reply`, under ids of its own."""

import os
import signal
import subprocess
import tempfile
import time
import unittest
from collections import Counter

import rospy
import rostest
from roboframenet_msgs.msg import CommandParse, ExecuteCommandActionGoal, Reply

from rfnserver import RFNServer
from roboframenet_rostest import say, wait_for_pipeline
from roboframenet_testing import wait_until
from roboframenet_testing.ros_processes import process_of

#: A stamp that is older is one of a recording, seconds.
OLD_S = 10.0


class ReplayedBagTest(unittest.TestCase):
    """The pipeline, a server that counts, and a bag of two sentences and of all that came of them."""

    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_replayed_bag")
        cls.goals, cls.replies = [], []
        cls.server = RFNServer("counting", cls.goals.append)
        cls.server.register_with_frame("pinging")
        cls.server.start()
        cls.subscriber = rospy.Subscriber("reply", Reply, cls.replies.append)
        wait_for_pipeline(["pinging"])
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.bag = os.path.join(folder.name, "everything.bag")
        # It records what somebody publishes: the client of a sentence would come too late.
        cls.goal = rospy.Publisher("command/goal", ExecuteCommandActionGoal, queue_size=1)
        recording = subprocess.Popen(["rosbag", "record", "-a", "-O", cls.bag])
        wait_until(lambda: not cls.unrecorded(), message=cls.unrecorded)
        # The master knows the recorder before it is connected.
        time.sleep(2.0)
        cls.said = [say("Ping."), say("Ping every day at noon.")]
        time.sleep(1.0)
        recording.send_signal(signal.SIGINT)
        recording.wait(60.0)

    @classmethod
    def unrecorded(cls):
        _, _, (_, subscribers, _) = rospy.get_master().getSystemState()
        heard = {topic for topic, nodes in subscribers if any(node.startswith("/record") for node in nodes)}
        return {
            "/command_text",
            "/command_parse",
            "/command_plan",
            "/command_standing_order",
            "/command/goal",
            "/counting/goal",
        } - heard

    def setUp(self):
        self.assertEqual(["DONE", "DONE"], [reply.code for reply in self.said], self.said)

    def play(self, *arguments):
        # Nobody hears some of all topics; a stage hears each that is named.
        wait = ["--wait-for-subscribers"] if arguments else []
        subprocess.run(["rosbag", "play", "-q", "-d", "3", *wait, self.bag, *arguments], check=True, timeout=120)

    def assert_nothing_is_done(self, *arguments):
        """Play; returns the codes of the replies that were told meanwhile, without those of the bag."""
        before, known = len(self.goals), len(self.replies)
        self.play(*arguments)
        # What is said now goes the same way as what was played, behind it.
        reply = say("Ping.")
        self.assertEqual("DONE", reply.code)
        wait_until(lambda: any(one.command.id == reply.command.id for one in self.replies[known:]))
        self.assertEqual(before + 1, len(self.goals), arguments)
        told = self.replies[known:]
        own = [reply for reply in told if reply.command.id.startswith("replayed-")]
        self.assertEqual(len(own), len({reply.command.id for reply in own}))
        return Counter(reply.code for reply in own)

    def test_1_soon_after_it_was_recorded_each_stage_knows_its_commands(self):
        parses = []
        subscriber = rospy.Subscriber("command_parse", CommandParse, parses.append)
        for topic, number in (("/command_text", 2), ("/command_parse", 2), ("/command_plan", 1)):
            self.assertEqual({"REPLAYED": number}, self.told(topic))
        # The parser refuses the sentences of the bag: the two that were played, and that which was said behind each.
        self.assertEqual(2 + 3, len(parses))
        subscriber.unregister()
        self.assertEqual({"REPLAYED": 2}, self.told("/command/goal"))
        self.assert_nothing_is_done("--topics", "/counting/goal")

    def told(self, topic):
        return dict(self.assert_nothing_is_done("--topics", topic))

    def test_2_an_order_that_was_taken_back_does_not_come_back(self):
        self.assertEqual("DONE", say("Cancel all orders.").code)
        self.assertEqual({"REPLAYED": 1}, self.told("/command_standing_order"))
        self.assertIn("no standing order", say("What are your standing orders?").sentence.lower())

    def test_3_a_whole_bag_commands_nothing(self):
        self.assertLess(0, self.assert_nothing_is_done()["REPLAYED"])

    def test_4_stages_that_were_started_anew_know_old_commands_by_their_stamps(self):
        time.sleep(OLD_S)
        for node in ("executor", "command_server"):
            pid = process_of(node)
            os.kill(pid, signal.SIGKILL)
            wait_until(lambda pid=pid, node=node: self.is_another(node, pid), message=f"{node} does not come back")
        wait_for_pipeline(["pinging"])
        known = len(self.replies)
        self.assertEqual({"REPLAYED"}, set(self.told("/command_plan")))
        # What stages refused before is not told again to the command server that was started anew.
        own = [reply for reply in self.replies[known:] if reply.command.id.startswith("replayed-")]
        self.assertEqual(["Ping."], [reply.command.text for reply in own])
        self.assertEqual({"REPLAYED": 2}, self.told("/command_text"))
        known = len(self.replies)
        self.assert_nothing_is_done("--topics", "/command/goal")
        self.assertEqual(2, [reply.code for reply in self.replies[known:]].count("LATE"))

    @staticmethod
    def is_another(node, pid):
        try:
            return process_of(node) != pid
        except (OSError, rospy.ROSException):
            return False


if __name__ == "__main__":
    rostest.rosrun("roboframenet_tests", "replayed_bag", ReplayedBagTest)
