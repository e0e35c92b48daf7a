"""Sends plans to the executor and waits for its replies, for tests by subject."""

import unittest

import rospy
from actionlib_msgs.msg import GoalID
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    FilledFrameElement,
    FilledSemanticFrame,
    Plan,
    PlanCandidate,
    PlanNode,
    StageEvent,
    StopReport,
)
from std_msgs.msg import String

from roboframenet_testing import wait_until


def frame(behaviour, server, seconds="0"):
    return FilledSemanticFrame(
        name=behaviour,
        action_server_topics=[server] if server else [],
        frame_elements=[FilledFrameElement("seconds", seconds)],
    )


def clause(label, ways):
    """A clause; each way is a list of frames."""
    return PlanNode(
        kind=PlanNode.DO, label=label, candidates=[PlanCandidate(frames=frames, coverage=1.0) for frames in ways]
    )


def join(label, *children):
    return PlanNode(kind=PlanNode.SEQUENCE, label=label, children=children)


class ExecutorCase(unittest.TestCase):
    """One executor, and servers that do what a frame asks for."""

    count = 0

    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_executor_node")
        cls.events, cls.log = [], []
        cls.plans = rospy.Publisher("command_plan", CommandPlan, queue_size=1000)
        cls.stops = rospy.Publisher("stop_report", StopReport, queue_size=10)
        cls.cancels = rospy.Publisher("command_cancel", Command, queue_size=10)
        cls.marks = rospy.Publisher("servers/mark", String, queue_size=10)
        cls.server_cancel = rospy.Publisher("one/cancel", GoalID, queue_size=10)
        subscribers = [rospy.Subscriber("stage_events", StageEvent, cls.events.append)]
        log = rospy.Subscriber("server_log", String, lambda message: cls.log.append(message.data))
        wait_until(
            lambda: all(
                entity.get_num_connections() == 1
                for entity in subscribers + [cls.plans, cls.stops, cls.cancels, cls.marks]
            )
        )
        wait_until(lambda: log.get_num_connections() == 3 and cls.server_cancel.get_num_connections() == 1)

    def setUp(self):
        # The log comes on another connection than the replies: what the test before caused is to arrive first.
        self.marks.publish(self.id())
        self.wait_for_log(self.id())
        del self.log[:]

    def send(self, ways, stamp=None):
        """Send a command of one clause."""
        return self.send_nodes([clause("do it", ways)], stamp)

    def send_clauses(self, *ways_by_label):
        """Send a command of several clauses."""
        leaves = [clause(label, ways) for label, ways in ways_by_label]
        return self.send_nodes([join("do it all", *range(1, len(leaves) + 1))] + leaves)

    def send_nodes(self, nodes, stamp=None, beginning=Plan.REPLACE):
        type(self).count += 1
        command = Command(id=f"{self.id()}_{self.count}", text="do it", stamp=stamp or rospy.Time.now())
        self.plans.publish(CommandPlan(command=command, plan=Plan(nodes=nodes, beginning=beginning)))
        return command

    def begun(self):
        return [line for line in self.log if line.split()[1] == "begins"]

    def events_of(self, command, is_final):
        return [event for event in list(self.events) if event.command.id == command.id and event.is_final == is_final]

    def wait_for_reply(self, command):
        wait_until(lambda: self.events_of(command, True), message=f"no final event of {command.id}")
        return self.events_of(command, True)[0].reply

    def assert_reply(self, command, outcome, code, *parts):
        reply = self.wait_for_reply(command)
        self.assertEqual((outcome, code), (reply.outcome, reply.code), reply.sentence)
        for part in parts:
            self.assertIn(part, reply.sentence)

    def wait_for_log(self, line):
        wait_until(lambda: line in self.log, message=lambda: self.log)
