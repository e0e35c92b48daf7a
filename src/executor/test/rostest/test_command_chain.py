#!/usr/bin/python3
"""Command server, arbitrator, executor and stop server together: one reply to each text."""

import collections
import os
import signal
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from roboframenet_msgs.msg import (
    Command,
    CommandSemanticFrames,
    FilledSemanticFrame,
    Plan,
    PlanCandidate,
    PlanNode,
    Reply,
    StageEvent,
)
from std_msgs.msg import String

from roboframenet_testing import wait_until
from roboframenet_testing.ros_connections import is_connected
from roboframenet_testing.ros_processes import process_of

STAGES = ("stanford_parser_ros", "semantic_framer", "frame_registrar")


class CommandChainTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_command_chain")
        cls.replies, cls.log, cls.velocities = [], [], []
        cls.frames = rospy.Publisher("command_semantic_frames", CommandSemanticFrames, queue_size=1000)
        cls.events = rospy.Publisher("stage_events", StageEvent, queue_size=1000)
        cls.text = rospy.Publisher("text", String, queue_size=1000)
        subscribers = [
            rospy.Subscriber("command_text", Command, cls.on_command),
            rospy.Subscriber("server_log", String, lambda message: cls.log.append(message.data)),
        ]
        velocities = rospy.Subscriber("cmd_vel", Twist, cls.velocities.append)
        replies = rospy.Subscriber("reply", Reply, cls.replies.append)
        wait_until(lambda: all(entity.get_num_connections() == 1 for entity in subscribers + [cls.frames, cls.events]))
        # The command server and the stop server.
        wait_until(lambda: all(entity.get_num_connections() == 2 for entity in (velocities, replies, cls.text)))
        # What is published before its listener has connected is lost.
        for connection in (
            ("/arbitrator", "command_plan", "/executor"),
            ("/command_server", "command_cancel", "/executor"),
            ("/stop_server", "stop_report", "/executor"),
            ("/stop_server", "stop_report", "/command_server"),
        ):
            wait_until(lambda connection=connection: is_connected(*connection), message=str(connection))

    @classmethod
    def on_command(cls, command):
        """Text "run one, succeed two / fail one; run two": semicolons separate clauses, slashes their candidates, and
        commas frames. A step that fails is not called "abort" there: that is a cry, and stops.
        """
        for stage in STAGES:
            cls.events.publish(StageEvent(command=command, stage=stage, stamp=rospy.Time.now(), sentence="at it"))
        clauses = command.text.split(";")
        nodes = [PlanNode(kind=PlanNode.SEQUENCE, label=command.text, children=range(1, len(clauses) + 1))]
        for clause in clauses:
            ways = [[step.split() for step in candidate.split(",")] for candidate in clause.split("/")]
            nodes.append(
                PlanNode(
                    kind=PlanNode.DO,
                    label=clause.strip(),
                    candidates=[
                        PlanCandidate(
                            coverage=1.0,
                            frames=[
                                FilledSemanticFrame(
                                    name="abort" if behaviour == "fail" else behaviour, action_server_topics=[server]
                                )
                                for behaviour, server in steps
                            ],
                        )
                        for steps in ways
                    ],
                )
            )
        cls.frames.publish(CommandSemanticFrames(command=command, plan=Plan(nodes=nodes)))

    def setUp(self):
        for known in (self.replies, self.log, self.velocities):
            del known[:]

    def replies_to(self, text):
        return [reply for reply in list(self.replies) if reply.command.text == text]

    def wait_for_replies(self, text, count=1):
        wait_until(lambda: len(self.replies_to(text)) >= count, message=lambda: self.replies_to(text))
        return self.replies_to(text)

    def wait_for_log(self, line):
        wait_until(lambda: line in self.log, message=lambda: self.log)

    def test_next_candidate_after_a_failed_second_step(self):
        text = "succeed one, fail two / succeed one, succeed two"
        self.text.publish(text)
        self.assertEqual(Reply.DONE, self.wait_for_replies(text)[0].outcome)
        # Replies and log come on connections of their own.
        self.wait_for_log("two ends succeed")
        self.assertEqual(
            ["one", "two", "one", "two"], [line.split()[0] for line in self.log if line.split()[1] == "begins"]
        )

    def begun(self):
        return [line for line in self.log if line.split()[1] == "begins"]

    def test_clause_that_was_done_is_not_done_again(self):
        text = "succeed one; fail two / reject one / succeed two"
        self.text.publish(text)
        reply = self.wait_for_replies(text)[0]
        self.assertEqual(Reply.DONE, reply.outcome)
        self.wait_for_log("two ends succeed")
        self.assertEqual(
            ["one begins succeed", "two begins abort", "one begins reject", "two begins succeed"], self.begun()
        )
        self.assertIn("aborted as asked for", reply.sentence)

    def test_clause_that_cannot_be_done_says_what_was_done(self):
        text = "succeed one; fail two / reject one; succeed two"
        self.text.publish(text)
        reply = self.wait_for_replies(text)[0]
        self.assertEqual((Reply.FAILED, "ALL_CANDIDATES_FAILED"), (reply.outcome, reply.code))
        self.assertEqual(
            'I did "succeed one", but I could not do "fail two / reject one": aborted as asked '
            'for; rejected as asked for. I did not begin "succeed two".',
            reply.sentence,
        )
        self.assertEqual(["one begins succeed", "two begins abort", "one begins reject"], self.begun())

    def test_new_command_preempts(self):
        self.text.publish("run one")
        self.wait_for_log("one begins run")
        self.text.publish("succeed two")
        self.assertEqual("NEW_COMMAND", self.wait_for_replies("run one")[0].code)
        self.assertEqual("DONE", self.wait_for_replies("succeed two")[0].code)
        self.wait_for_log("two ends succeed")
        self.assertEqual(["one begins run", "one preempted run", "two begins succeed", "two ends succeed"], self.log)

    def test_flood_of_texts_gets_one_reply_each(self):
        for _ in range(50):
            self.text.publish("run one")
        self.text.publish("succeed two")
        self.wait_for_replies("succeed two")
        self.wait_for_log("two ends succeed")
        self.wait_for_replies("run one", count=50)
        self.assertEqual({"NEW_COMMAND"}, {reply.code for reply in self.replies_to("run one")})
        counts = collections.Counter(reply.command.id for reply in self.replies)
        self.assertEqual({1}, set(counts.values()))
        self.assertEqual(51, len(counts))

    def test_stop_in_a_flood(self):
        for _ in range(20):
            self.text.publish("run one")
        self.text.publish("stop")
        for _ in range(5):
            self.text.publish("run two")
        self.text.publish("stop")
        self.wait_for_replies("stop", count=2)
        self.wait_for_replies("run one", count=20)
        self.wait_for_replies("run two", count=5)
        self.assertEqual({Reply.SUPERSEDED}, {reply.outcome for reply in self.replies if "run" in reply.command.text})
        wait_until(self.is_nothing_running)
        # Nothing that was said before the stop begins after it.
        self.text.publish("succeed two")
        self.assertEqual("DONE", self.wait_for_replies("succeed two")[0].code)
        self.wait_for_log("two ends succeed")
        self.assertTrue(self.is_nothing_running())
        self.assertEqual({1}, set(collections.Counter(reply.command.id for reply in self.replies).values()))

    def is_nothing_running(self):
        begun = sum("begins run" in line for line in self.log)
        # A goal that was cancelled before it was accepted ends without having run.
        return begun <= sum("preempted run" in line for line in self.log)

    def test_z_stop_with_everything_else_hung(self):
        self.text.publish("run one")
        self.wait_for_log("one begins run")
        pids = [process_of(node) for node in ("/command_server", "/arbitrator", "/executor")]
        for pid in pids:
            os.kill(pid, signal.SIGSTOP)
        try:
            self.text.publish("Stop.")
            self.assertEqual("stop_server", self.wait_for_replies("Stop.")[0].stage)
            self.wait_for_log("one preempted run")
            wait_until(lambda: self.velocities)
            self.assertTrue(all(velocity == Twist() for velocity in self.velocities))
        finally:
            for pid in pids:
                os.kill(pid, signal.SIGCONT)
        # When they come back they find the command stopped, and answer it.
        self.assertEqual("STOPPED", self.wait_for_replies("run one")[0].code)
        self.text.publish("succeed one")
        self.assertEqual("DONE", self.wait_for_replies("succeed one")[0].code)
        self.assertEqual(1, len(self.replies_to("Stop.")))


if __name__ == "__main__":
    rostest.rosrun("executor", "command_chain", CommandChainTest)
