#!/usr/bin/python3
"""The node: one procedure or one final event for each command."""

import unittest

import rospy
import rostest
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    CommandSemanticFrames,
    FilledSemanticFrame,
    Plan,
    PlanCandidate,
    PlanNode,
    Procedure,
    Reply,
    StageEvent,
)

from roboframenet_testing import comes_true, wait_until
from roboframenet_testing.ros_connections import is_connected


def candidate(*servers, coverage=1.0, preference=0):
    return PlanCandidate(
        coverage=coverage,
        preference=preference,
        frames=[
            FilledSemanticFrame(name="turning", action_server_topics=[server] if server else []) for server in servers
        ],
    )


def servers_of(node):
    return [[frame.action_server_topics[0] for frame in candidate.frames] for candidate in node.candidates]


class ArbitratorNodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_arbitrator_node")
        cls.plans, cls.procedures, cls.events = [], [], []
        cls._publisher = rospy.Publisher("command_semantic_frames", CommandSemanticFrames, queue_size=100)
        rospy.Subscriber("command_plan", CommandPlan, cls.plans.append)
        rospy.Subscriber("procedure", Procedure, cls.procedures.append)
        cls._on_event = rospy.Subscriber("stage_events", StageEvent, cls.events.append)
        wait_until(lambda: cls._publisher.get_num_connections() == 1)
        for topic in ("command_plan", "procedure", "stage_events"):
            wait_until(lambda topic=topic: is_connected("/arbitrator", topic, rospy.get_name()), message=topic)

    def setUp(self):
        for received in (self.plans, self.procedures, self.events):
            del received[:]

    def send(self, command_id, *candidates):
        """Send a command of one clause."""
        self.send_plan(command_id, PlanNode(kind=PlanNode.DO, label="turn", candidates=candidates))

    def send_plan(self, command_id, *nodes):
        self._publisher.publish(
            CommandSemanticFrames(command=Command(id=command_id, text="turn"), plan=Plan(nodes=nodes))
        )

    def events_of(self, command_ids):
        return [event for event in list(self.events) if event.command.id in command_ids]

    def test_order_by_reading_then_coverage_then_policy(self):
        self.send(
            "one", candidate("a", coverage=0.5), candidate("b"), candidate("c", "d"), candidate("e", preference=1)
        )
        wait_until(lambda: self.plans and self.procedures and self.events_of(["one"]))
        message = self.plans[0]
        self.assertEqual("one", message.command.id)
        (node,) = message.plan.nodes
        self.assertEqual((PlanNode.DO, "turn"), (node.kind, node.label))
        self.assertEqual([["b"], ["c", "d"], ["a"], ["e"]], servers_of(node))
        self.assertEqual([1.0, 1.0, 0.5, 1.0], [candidate.coverage for candidate in node.candidates])
        self.assertEqual([0, 0, 0, 1], [candidate.preference for candidate in node.candidates])
        self.assertEqual(
            [candidate.frames for candidate in node.candidates],
            [entry.frames for entry in self.procedures[0].frame_lists],
        )
        self.assertFalse(self.events_of(["one"])[0].is_final)

    def test_each_clause_is_ordered_for_itself(self):
        leaves = [
            PlanNode(kind=PlanNode.DO, label=label, candidates=candidates)
            for label, candidates in (
                ("ping", [candidate("p")]),
                ("wave", [candidate("w", preference=1), candidate("v")]),
            )
        ]
        # The children need not stand behind each other.
        self.send_plan(
            "two", PlanNode(kind=PlanNode.SEQUENCE, label="ping and wave", children=[2, 1]), leaves[1], leaves[0]
        )
        wait_until(lambda: self.plans and self.procedures)
        nodes = self.plans[0].plan.nodes
        self.assertEqual(["ping and wave", "ping", "wave"], [node.label for node in nodes])
        self.assertEqual([1, 2], list(nodes[0].children))
        self.assertEqual([[["p"]], [["v"], ["w"]]], [servers_of(node) for node in nodes[1:]])
        self.assertEqual(
            [["p", "v"], ["p", "w"]],
            [[frame.action_server_topics[0] for frame in entry.frames] for entry in self.procedures[0].frame_lists],
        )

    def test_a_listener_that_connects_late_hears_how_a_command_ended(self):
        cls = type(self)
        cls._on_event.unregister()
        self.send("unheard")
        self.send("after_it", candidate("a"))
        # One thread takes both, in their order.
        wait_until(lambda: self.plans and self.procedures)
        del self.events[:]
        cls._on_event = rospy.Subscriber("stage_events", StageEvent, self.events.append)
        wait_until(lambda: "unheard" in [event.command.id for event in self.events if event.is_final])

    def test_standing_order_that_nobody_keeps_is_refused(self):
        # Whoever keeps them may start up to 5 s after the node; until then the order waits.
        def is_refused():
            self.send_plan(
                "order",
                PlanNode(kind=PlanNode.WHENEVER, label="ping whenever it rings", children=[1, 2]),
                PlanNode(kind=PlanNode.CONDITION, label="it rings", candidates=[candidate("bell")]),
                PlanNode(kind=PlanNode.DO, label="ping", candidates=[candidate("a")]),
            )
            return comes_true(lambda: [event for event in self.events_of(["order"]) if event.is_final], 1.0)

        wait_until(is_refused)
        (reply,) = [event.reply for event in self.events_of(["order"]) if event.is_final]
        self.assertEqual((Reply.REFUSED, "NO_SERVER"), (reply.outcome, reply.code))
        self.assertFalse(self.plans)

    def test_what_cannot_be_arbitrated_ends_with_one_final_event(self):
        self.send("none")
        self.send("no_server", candidate(""))
        self.send("no_frames", candidate())
        self.send("coverage", candidate("a", coverage=2.0))
        self.send_plan("no_nodes")
        self.send_plan(
            "circle", PlanNode(kind=PlanNode.SEQUENCE, children=[1]), PlanNode(kind=PlanNode.SEQUENCE, children=[0])
        )
        self.send_plan("unknown", PlanNode(kind=200, candidates=[candidate("a")]))
        names = ["none", "no_server", "no_frames", "coverage", "no_nodes", "circle", "unknown"]
        wait_until(lambda: len(self.events_of(names)) >= len(names))
        events = self.events_of(names)
        self.assertEqual(names, [event.command.id for event in events])
        self.assertTrue(all(event.is_final and event.reply.sentence for event in events))
        self.assertEqual({(Reply.FAILED, "STAGE_ERROR")}, {(event.reply.outcome, event.reply.code) for event in events})
        self.assertFalse(self.plans)


if __name__ == "__main__":
    rostest.rosrun("arbitrator", "arbitrator_node", ArbitratorNodeTest)
