#!/usr/bin/python3
"""The node: one procedure or one final event for each command."""
import threading
import time
import unittest

import rospy
import rostest
from roboframenet_msgs.msg import (
    Command, CommandProcedure, CommandSemanticFrames, FilledSemanticFrame, FilledSemanticFrameList, Procedure, Reply,
    StageEvent)


def wait_until(condition, timeout_s=60.0):
    end = time.monotonic() + timeout_s
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.02)
    return condition()


def candidate(*servers):
    return FilledSemanticFrameList(frames=[
        FilledSemanticFrame(name="turning", action_server_topics=[server] if server else []) for server in servers])


class ArbitratorNodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_arbitrator_node")

    def setUp(self):
        self._lock = threading.Lock()
        self.procedures, self.plain, self.events = [], [], []
        self._subscribers = [
            rospy.Subscriber("command_procedure", CommandProcedure, self.procedures.append),
            rospy.Subscriber("procedure", Procedure, self.plain.append),
            rospy.Subscriber("stage_events", StageEvent, self.events.append)]
        self._publisher = rospy.Publisher("command_semantic_frames", CommandSemanticFrames, queue_size=100)
        self.assertTrue(wait_until(lambda: self._publisher.get_num_connections() == 1 and all(
            subscriber.get_num_connections() == 1 for subscriber in self._subscribers)))

    def tearDown(self):
        for subscriber in self._subscribers:
            subscriber.unregister()

    def send(self, command_id, candidates, coverage, preference=None):
        message = CommandSemanticFrames(command=Command(id=command_id, text="turn"), coverage=coverage)
        message.preference = [0] * len(coverage) if preference is None else preference
        message.candidates.frame_lists = candidates
        self._publisher.publish(message)

    def events_of(self, command_ids):
        # What another test ended a moment ago is told again to each new listener.
        return [event for event in list(self.events) if event.command.id in command_ids]

    def test_order_by_coverage_then_policy(self):
        self.send("one", [candidate("a"), candidate("b"), candidate("c", "d")], [0.5, 1.0, 1.0])
        self.assertTrue(wait_until(lambda: self.procedures and self.plain and self.events_of(["one"])))
        procedure = self.procedures[0]
        self.assertEqual("one", procedure.command.id)
        self.assertEqual(
            [["b"], ["c", "d"], ["a"]],
            [[frame.action_server_topics[0] for frame in entry.frames] for entry in procedure.procedure.frame_lists])
        self.assertEqual(procedure.procedure, self.plain[0])
        self.assertFalse(self.events_of(["one"])[0].is_final)

    def test_the_likeliest_reading_comes_first(self):
        self.send("tiers", [candidate(name) for name in "abcd"], [1.0, 1.0, 0.5, 1.0], [1, 2, 0, 0])
        self.assertTrue(wait_until(lambda: self.procedures))
        self.assertEqual(["d", "c", "a", "b"], [
            entry.frames[0].action_server_topics[0] for entry in self.procedures[0].procedure.frame_lists])

    def test_a_listener_that_connects_late_hears_how_a_command_ended(self):
        events = self._subscribers.pop()
        events.unregister()
        self.send("unheard", [], [])
        self.send("after_it", [candidate("a")], [1.0])
        # One thread takes both, in their order.
        self.assertTrue(wait_until(lambda: self.procedures))
        del self.events[:]
        self._subscribers.append(rospy.Subscriber("stage_events", StageEvent, self.events.append))
        self.assertTrue(wait_until(lambda: "unheard" in [event.command.id for event in self.events if event.is_final]))

    def test_what_cannot_be_arbitrated_ends_with_one_final_event(self):
        self.send("none", [], [])
        self.send("no_server", [candidate("")], [1.0])
        self.send("no_frames", [candidate()], [1.0])
        self.send("coverage", [candidate("a")], [])
        names = ["none", "no_server", "no_frames", "coverage"]
        self.assertTrue(wait_until(lambda: len(self.events_of(names)) >= 4))
        events = self.events_of(names)
        self.assertEqual(names, [event.command.id for event in events])
        self.assertTrue(all(event.is_final and event.reply.sentence for event in events))
        self.assertEqual([Reply.REFUSED] + [Reply.FAILED] * 3, [event.reply.outcome for event in events])
        self.assertEqual(["NO_SERVER"] + ["STAGE_ERROR"] * 3, [event.reply.code for event in events])
        self.assertFalse(self.procedures)


if __name__ == "__main__":
    rostest.rosrun("arbitrator", "arbitrator_node", ArbitratorNodeTest)
