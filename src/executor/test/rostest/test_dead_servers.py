#!/usr/bin/python3
"""Servers that are dead or were never there: a living one is found at once, and each is waited for once.

A reply names the servers that were tried, and "no answer within" tells that one was waited for.
"""

import os
import subprocess
import sys
from contextlib import ExitStack

import actionlib
import rospy
import rostest
from roboframenet_msgs.msg import FilledSemanticFrameAction, FrameCallback, FrameServers, Reply

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from executor_case import ExecutorCase, clause, frame

from roboframenet_ros.ros_waiting import wait_for_action_server
from roboframenet_testing import wait_until
from roboframenet_testing.ros_processes import process_of

SERVER = os.path.join(os.path.dirname(os.path.realpath(__file__)), "misbehaving_server.py")
NUMBER = 50


class DeadServersTest(ExecutorCase):
    """One executor."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.servers = rospy.Publisher("frame_servers", FrameServers, queue_size=1, latch=True)

    def setUp(self):
        super().setUp()
        self.graph = ExitStack()
        self.addCleanup(self.graph.close)

    def start(self, *names):
        """Run servers in a process of their own; returns when they are there."""
        command = [sys.executable, SERVER, f"__name:=mortals_of_{names[0]}", f"_servers:=[{', '.join(names)}]"]
        process = subprocess.Popen(command)
        self.graph.callback(process.wait)
        self.graph.callback(process.kill)
        for name in (names[0], names[-1]):
            client = actionlib.ActionClient(name, FilledSemanticFrameAction)
            self.assertTrue(wait_for_action_server(client, 60.0), name)
            client.stop()
        return process

    def tell_living(self, *names):
        callbacks = [FrameCallback(frame_name="succeed", callback_topic=name, is_alive=True) for name in names]
        self.servers.publish(FrameServers(registrar_id="test", callbacks=callbacks))

    def test_living_server_is_found_among_fifty_that_were_killed(self):
        names = [f"killed_{number}" for number in range(NUMBER)]
        process = self.start(*names)
        process.kill()
        process.wait()
        self.assert_done_by_the_living(names)

    def test_living_server_is_found_among_fifty_that_were_never_there(self):
        self.assert_done_by_the_living([f"never_{number}" for number in range(NUMBER)])

    def assert_done_by_the_living(self, dead):
        for place in (0, NUMBER // 2, NUMBER):
            ways = [[frame("succeed", name)] for name in dead]
            ways.insert(place, [frame("succeed", "two")])
            reply = self.wait_for_reply(self.send(ways))
            self.assertEqual("Done.", reply.sentence)

    def test_likelier_reading_comes_first_although_its_server_is_missing(self):
        both = clause("do it", [[frame("succeed", "nowhere")], [frame("succeed", "two")]])
        both.candidates[1].preference = 1
        self.assert_reply(
            self.send_nodes([both]), Reply.DONE, "DONE", "the program for it is not running: no answer within"
        )

    def test_all_that_are_missing_are_waited_for_once(self):
        ways = [[frame("succeed", f"absent_{number}")] for number in range(6)]
        first = self.wait_for_reply(self.send(ways)).sentence
        self.assertEqual(1, first.count("no answer within"), first)
        # The other five give the same reason, which is told once.
        self.assertEqual(2, first.count("is not running"), first)
        self.assertNotIn("no answer within", self.wait_for_reply(self.send(ways)).sentence)

    def test_server_whose_name_is_none_is_named(self):
        for ways in ([["not a name"]], [["not a name"], ["absent"]]):
            command = self.send([[frame("succeed", name) for name in names] for names in ways])
            self.assert_reply(command, Reply.FAILED, "ALL_CANDIDATES_FAILED", "cannot be reached")

    def test_server_that_died_is_used_when_it_is_back(self):
        process = self.start("phoenix")
        self.assert_reply(self.send([[frame("succeed", "phoenix")]]), Reply.DONE, "DONE")
        process.kill()
        process.wait()
        self.assert_reply(
            self.send([[frame("succeed", "phoenix")]]),
            Reply.FAILED,
            "ALL_CANDIDATES_FAILED",
            "the program for it is not running: no answer within",
        )
        again = self.wait_for_reply(self.send([[frame("succeed", "phoenix")]])).sentence
        self.assertIn("the program for it is not running.", again)
        self.start("phoenix")
        self.assert_reply(self.send([[frame("succeed", "phoenix")]]), Reply.DONE, "DONE")

    def test_servers_that_live_are_connected_before_the_first_goal(self):
        self.tell_living("three")
        wait_until(lambda: self.is_connected("three"))

    def is_connected(self, server):
        _, _, (publishers, _, _) = rospy.get_master().getSystemState()
        return "/executor" in dict(publishers).get(f"/{server}/goal", ())

    def test_dead_servers_leave_no_descriptors(self):
        pid = process_of("executor")

        def descriptors():
            return len(os.listdir(f"/proc/{pid}/fd"))

        self.assert_reply(self.send([[frame("succeed", "two")]]), Reply.DONE, "DONE")
        before = descriptors()
        for number in range(9):
            name = f"brief_{number}"
            process = self.start(name)
            self.tell_living(name)
            self.assert_reply(self.send([[frame("succeed", name)]]), Reply.DONE, "DONE")
            process.kill()
            process.wait()
        self.wait_for_reply(self.send([[frame("succeed", f"never_seen_{number}")] for number in range(9)]))
        after = descriptors()
        self.tell_living()
        wait_until(lambda: descriptors() <= before + 5, message=lambda: f"{before}, {after}, now {descriptors()}")


if __name__ == "__main__":
    rostest.rosrun("executor", "dead_servers", DeadServersTest)
