#!/usr/bin/python3
"""Standing orders in the graph: each is done once when it is due, survives a kill, and begins nothing after a stop."""

import os
import signal
import threading
import time
import unittest
from typing import Dict, List
from xmlrpc.client import ServerProxy

import actionlib
import rosgraph
import rospy
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
    FilledSemanticFrameResult,
    Plan,
    PlanCandidate,
    PlanNode,
    Reply,
    StageEvent,
    StandingOrders,
    TimeExpression,
)
from std_msgs.msg import String

from rfnserver import ConditionServer, RFNServer
from roboframenet_testing import wait_until


def clause(kind: int, label: str, server: str) -> PlanNode:
    frame = FilledSemanticFrame(name=server, action_server_topics=[server])
    return PlanNode(kind=kind, label=label, candidates=[PlanCandidate(frames=[frame], coverage=1.0)])


def at(deed: str, **when: object) -> Plan:
    root = PlanNode(kind=PlanNode.AT, label=deed, children=[1], when=TimeExpression(kind="time", words="then", **when))
    return Plan(nodes=[root, clause(PlanNode.DO, deed, "pinging")])


def whenever(deed: str) -> Plan:
    root = PlanNode(kind=PlanNode.WHENEVER, label=deed, children=[1, 2])
    condition = clause(PlanNode.CONDITION, "the bell rings", "bell_watch")
    return Plan(nodes=[root, condition, clause(PlanNode.DO, deed, "pinging")])


class StandingOrdersTest(unittest.TestCase):
    """The methods run in the order of their names."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.rings = False
        cls.questions = 0
        cls.pings: List[float] = []
        cls.is_slow = threading.Event()
        cls.replies: List[Reply] = []
        cls.events: Dict[str, Reply] = {}
        cls.orders: List[StandingOrders] = []
        cls.server = RFNServer("pinging", cls.ping)
        cls.server.start()
        cls.bell = ConditionServer("bell_watch", cls.is_ringing)
        cls.bell.start()
        cls.given = rospy.Publisher("command_standing_order", CommandPlan, queue_size=10)
        cls.text = rospy.Publisher("text", String, queue_size=10)
        cls.subscribers = [
            rospy.Subscriber("reply", Reply, cls.replies.append),
            rospy.Subscriber("stage_events", StageEvent, cls.hear),
            rospy.Subscriber("standing_orders", StandingOrders, cls.orders.append),
        ]
        cls.meet_server()
        wait_until(lambda: cls.given.get_num_connections() and cls.text.get_num_connections() > 1 and cls.orders)
        replies, events, _ = cls.subscribers
        wait_until(lambda: replies.get_num_connections() and events.get_num_connections() > 1)

    @classmethod
    def meet_server(cls) -> None:
        """Connect to the node's server; a client that has seen its server die loses goals while it reconnects."""
        cls.asked = actionlib.ActionClient("standing_orders_server", FilledSemanticFrameAction)
        assert cls.asked.wait_for_server(rospy.Duration(60.0))

    @classmethod
    def ping(cls, _frame: FilledSemanticFrame) -> None:
        cls.pings.append(time.monotonic())
        while cls.is_slow.is_set() and not cls.server.is_preempt_requested():
            time.sleep(0.01)
        if cls.server.is_preempt_requested():
            cls.server.set_preempted(FilledSemanticFrameResult(success=False))
        else:
            cls.server.set_succeeded(FilledSemanticFrameResult(success=True))

    @classmethod
    def hear(cls, event: StageEvent) -> None:
        if event.is_final and event.stage == "standing_orders":
            cls.events[event.command.text] = event.reply

    def give(self, text: str, plan: Plan) -> Reply:
        self.events.pop(text, None)
        self.given.publish(
            CommandPlan(Command(id=f"given-{time.monotonic()}", stamp=rospy.Time.now(), text=text), plan)
        )
        wait_until(lambda: text in self.events)
        return self.events[text]

    def ask(self, name: str, theme: str = "") -> str:
        elements = [FilledFrameElement("theme", theme)] if theme else []
        handle = self.asked.send_goal(FilledSemanticFrameGoal(FilledSemanticFrame(name, elements, [])))
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        return handle.get_goal_status_text()

    @classmethod
    def is_ringing(cls, _frame: FilledSemanticFrame) -> bool:
        cls.questions += 1
        return cls.rings

    def ring(self, pings: int = 0) -> None:
        """Ring until the source of the condition has seen it and so many pings are made; then be silent."""
        for type(self).rings in (True, False):
            seen = self.questions
            wait_until(lambda count=seen: self.questions > count + 1 and len(self.pings) >= pings)
            time.sleep(0.1)

    def states(self) -> List[str]:
        return [order.state for order in self.orders[-1].orders]

    def kill(self) -> None:
        """Kill the node with SIGKILL, and wait until it is back."""
        uri = rosgraph.Master("/test").lookupNode("/standing_orders")
        pid = ServerProxy(uri).getPid("/test")[2]
        seen = len(self.orders)
        os.kill(pid, signal.SIGKILL)
        wait_until(lambda: len(self.orders) > seen)
        wait_until(lambda: self.given.get_num_connections() > 0)
        wait_until(lambda: "blind" not in self.states())
        self.meet_server()

    def new_replies(self, count: int = 1) -> List[Reply]:
        wait_until(lambda: len(self.replies) >= count)
        replies, self.replies[:] = list(self.replies), []
        return replies

    def test_1_order_for_a_time_is_done_once_and_its_reply_names_it(self) -> None:
        reply = self.give("Ping in one second.", at("Ping", value="PT1S", offset=rospy.Duration(1.0)))
        self.assertEqual((reply.outcome, reply.code), (Reply.DONE, "DONE"))
        self.assertRegex(reply.sentence, r"^I will ping in 1 second, at \d\d:\d\d")
        (done,) = self.new_replies()
        self.assertEqual((done.outcome, done.stage), (Reply.DONE, "executor"), done.sentence)
        self.assertEqual(done.sentence, 'As you said, "Ping in one second": Done.')
        wait_until(lambda: not self.orders[-1].orders)
        self.assertEqual(len(self.pings), 1)

    def test_2_order_for_a_condition_is_done_each_time_it_begins_to_hold(self) -> None:
        reply = self.give("Whenever the bell rings, ping.", whenever("ping"))
        self.assertEqual(reply.sentence, "I will ping whenever the bell rings.")
        wait_until(lambda: self.states() == ["waits"])
        for number in (1, 2):
            self.ring(pings=number + 1)
            wait_until(lambda count=number: len(self.replies) == count)
        self.assertEqual({reply.outcome for reply in self.new_replies(2)}, {Reply.DONE})
        self.assertEqual(len(self.pings), 3)
        self.assertEqual(self.orders[-1].orders[0].count, 2)
        again = self.give("whenever the bell rings, ping", whenever("ping"))
        self.assertEqual((again.outcome, len(self.orders[-1].orders)), (Reply.DONE, 1))

    def test_3_nothing_is_lost_and_nothing_is_done_late_when_the_node_is_killed(self) -> None:
        self.give("Ping in two seconds.", at("Ping", value="PT2S", offset=rospy.Duration(2.0)))
        uri = rosgraph.Master("/test").lookupNode("/standing_orders")
        pid = ServerProxy(uri).getPid("/test")[2]
        os.kill(pid, signal.SIGSTOP)
        time.sleep(8.0)
        os.kill(pid, signal.SIGKILL)
        (missed,) = self.new_replies()
        self.assertEqual((missed.outcome, missed.code), (Reply.FAILED, "MISSED"))
        self.assertEqual(missed.sentence, 'As you said, "Ping in two seconds": I did not do that: I was off.')
        wait_until(lambda: self.states() == ["waits"])
        self.assertEqual(len(self.pings), 3)
        self.ring(pings=4)
        self.new_replies()
        self.assertEqual(len(self.pings), 4)

    def test_4_order_waits_for_what_runs_and_checks_its_condition_then(self) -> None:
        self.is_slow.set()
        self.ring(pings=5)
        self.ring()
        time.sleep(5.0)
        self.is_slow.clear()
        self.assertEqual({reply.code for reply in self.new_replies(2)}, {"DONE", "MISSED"})
        self.assertEqual(len(self.pings), 5)

    def test_5_stop_suspends_the_orders_also_over_a_kill_until_somebody_says_go_on(self) -> None:
        self.is_slow.set()
        self.ring(pings=6)
        self.text.publish("Stop.")
        stopped = {reply.code for reply in self.new_replies(2)}
        self.assertEqual(stopped, {"DONE", "STOPPED"})
        self.is_slow.clear()
        wait_until(lambda: self.states() == ["suspended"])
        self.kill()
        for type(self).rings in (True, False):  # nobody watches
            time.sleep(0.5)
        self.assertEqual((len(self.pings), self.states()), (6, ["suspended"]))
        self.assertIn("suspended since you stopped me", self.ask("question_of_standing_orders"))
        self.assertEqual(self.ask("resuming_orders"), "I am waiting again. I will ping whenever the bell rings.")
        wait_until(lambda: self.states() == ["waits"])
        self.ring(pings=7)
        self.new_replies()
        self.assertEqual(len(self.pings), 7)

    def test_6_orders_are_bounded_listed_and_taken_back(self) -> None:
        for text, hour in (("eight", "T08:00"), ("nine", "T09:00"), ("ten", "T10:00")):
            self.give(f"Ping every day at {text}.", at("Ping", value=hour, period=rospy.Duration(86400)))
        refused = self.give("Ping tomorrow.", at("Ping", value="T08:00", offset=rospy.Duration(86400)))
        self.assertEqual((refused.outcome, refused.code), (Reply.REFUSED, "LIMIT"))
        self.assertEqual(self.ask("forgetting_an_order", "the bell"), 'I forget "Whenever the bell rings, ping".')
        self.assertEqual(self.ask("forgetting_an_order", "that"), 'I forget "Ping every day at ten".')
        self.assertEqual(
            self.ask("question_of_standing_orders"),
            "I have 2 standing orders. I will ping every day at 08:00. I will ping every day at 09:00.",
        )
        self.assertEqual(self.ask("forgetting_an_order", "the lamp"), 'I have no standing order with "the lamp".')
        past = self.give("Ping on Monday.", at("Ping", value="2012-05-14T08:00"))
        self.assertEqual((past.outcome, past.code), (Reply.REFUSED, "CONDITION"))


if __name__ == "__main__":
    import rostest

    rospy.init_node("standing_orders_test")
    rostest.rosrun("standing_orders", "standing_orders_node", StandingOrdersTest)
