#!/usr/bin/python3
"""The node with conditions: watched by servers that say so, change, fall silent, and die."""

import unittest

import rospy
import rostest
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    FilledFrameElement,
    FilledSemanticFrame,
    Plan,
    PlanCandidate,
    PlanNode,
    Reply,
    StageEvent,
    StopReport,
)
from std_msgs.msg import String

from roboframenet_testing import wait_until


def candidate(name, server, **elements):
    arguments = [FilledFrameElement(element, str(value)) for element, value in elements.items()]
    return PlanCandidate(
        frames=[FilledSemanticFrame(name=name, action_server_topics=[server], frame_elements=arguments)], coverage=1.0
    )


def condition(*ways, **fields):
    return PlanNode(kind=PlanNode.CONDITION, label="it is so", candidates=ways, **fields)


def watch(then, server="watching", seconds=0.0, before=0):
    """A watch that says "not so", or "so" (before), and after a time does something else."""
    return candidate("watch", server, then=then, seconds=seconds, before=before)


def do(name, server="one"):
    return PlanNode(kind=PlanNode.DO, label=name, candidates=[candidate(name, server)])


def node(kind, *children, **fields):
    return PlanNode(kind=getattr(PlanNode, kind), label=kind.lower(), children=children, **fields)


class ConditionsTest(unittest.TestCase):
    count = 0

    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_conditions_node")
        cls.events, cls.told = [], []
        cls.plans = rospy.Publisher("command_plan", CommandPlan, queue_size=100)
        cls.stops = rospy.Publisher("stop_report", StopReport, queue_size=10)
        events = rospy.Subscriber("stage_events", StageEvent, cls.events.append)
        log = rospy.Subscriber("server_log", String, lambda message: cls.told.append(message.data))
        wait_until(lambda: all(one.get_num_connections() == 1 for one in (cls.plans, cls.stops, events)))
        wait_until(lambda: log.get_num_connections() == 3)

    def setUp(self):
        self.since = len(self.told)

    @property
    def log(self):
        """What the servers have told in this test."""
        return self.told[self.since :]

    def send(self, *nodes):
        type(self).count += 1
        command = Command(id=f"conditions_{self.count}", text="do it", stamp=rospy.Time.now())
        self.plans.publish(CommandPlan(command=command, plan=Plan(nodes=list(nodes))))
        return command

    def wait_for_reply(self, command):
        def final():
            return [event for event in list(self.events) if event.command.id == command.id and event.is_final]

        wait_until(lambda: bool(final()), message=f"no final event of {command.id}")
        self.assertEqual(1, len(final()))
        return final()[0].reply

    def assert_reply(self, command, outcome, code, sentence):
        reply = self.wait_for_reply(command)
        self.assertEqual((outcome, code, sentence), (reply.outcome, reply.code, reply.sentence))
        # Nobody watches any longer than the plan. A watch of the test before may end while this one runs.
        wait_until(lambda: self.begun("watch") and self.watches(True) == self.watches(False), message=lambda: self.told)

    def begun(self, frame):
        return sorted(line.split()[0] for line in self.log if line.split()[1:] == ["begins", frame])

    def watches(self, is_begin):
        """The servers of all watches that began, or ended, in any test."""
        told = [line.split() for line in self.told]
        return sorted(server for server, what, frame in told if frame == "watch" and (what == "begins") == is_begin)

    def wait_for_log(self, line):
        wait_until(lambda: line in self.log, message=lambda: self.log)

    def until(self, *ways, **fields):
        return self.send(node("UNTIL", 1, 2), condition(*ways, **fields), do("run"))

    def test_until_the_condition_holds(self):
        self.assert_reply(
            self.until(watch("so", seconds=0.5)),
            Reply.DONE,
            "DONE",
            'Done. I ended "run", because "it is so" held.',
        )
        self.wait_for_log("one preempted run")

    def test_until_begins_nothing_when_it_holds_already(self):
        self.assert_reply(
            self.until(watch("so", before=1)),
            Reply.DONE,
            "DONE",
            'Done. I did not begin "run", because "it is so" held.',
        )
        self.assertEqual([], self.begun("run"))

    def test_until_it_begins_to_hold(self):
        command = self.until(watch("toggle", seconds=0.5, before=1), trigger=PlanNode.BEGINS)
        self.assert_reply(command, Reply.DONE, "DONE", 'Done. I ended "run", because "it is so" held.')
        self.wait_for_log("one preempted run")

    def test_while_it_holds(self):
        command = self.send(node("WHILE", 1, 2), condition(watch("toggle", seconds=0.5, before=1)), do("run"))
        self.assert_reply(command, Reply.DONE, "DONE", 'Done. I ended "run", because "it is so" did not hold.')
        self.wait_for_log("one preempted run")

    def test_if_and_otherwise(self):
        for before, sentence, server in (
            (1, "Done.", "one"),
            (0, 'Done. I did "succeed", and not "succeed", because "it is so" did not hold.', "two"),
        ):
            self.since = len(self.told)
            command = self.send(
                node("IF", 1, 2, 3),
                condition(watch("so", seconds=9, before=before)),
                do("succeed"),
                do("succeed", "two"),
            )
            self.assert_reply(command, Reply.DONE, "DONE", sentence)
            self.assertEqual([server], self.begun("succeed"))

    def test_wait_and_then(self):
        nodes = [node("SEQUENCE", 1, 3), node("WAIT", 2), condition(watch("so", seconds=0.5)), do("succeed")]
        command = self.send(*nodes)
        self.assert_reply(command, Reply.DONE, "DONE", "Done.")
        self.assertEqual(["one"], self.begun("succeed"))

    def test_wait_has_a_limit(self):
        nodes = [node("SEQUENCE", 1, 3), node("WAIT", 2), condition(watch("so", seconds=60)), do("succeed")]
        nodes[1].limit = rospy.Duration.from_sec(0.5)
        self.assert_reply(
            self.send(*nodes),
            Reply.FAILED,
            "LIMIT_REACHED",
            'I waited, but within 0.5 seconds "it is so" did not hold. I did not begin "succeed".',
        )
        self.assertEqual([], self.begun("succeed"))

    def test_source_that_falls_silent_ends_the_plan(self):
        self.assert_reply(
            self.until(watch("silence", seconds=0.5)),
            Reply.FAILED,
            "CONDITION_UNKNOWN",
            'I cannot tell whether "it is so": the program for it said nothing for 1 s. I ended "run".',
        )
        self.wait_for_log("one preempted run")

    def test_source_that_repeats_what_is_old_is_dead(self):
        self.assert_reply(
            self.until(watch("old", seconds=0.5)),
            Reply.FAILED,
            "CONDITION_UNKNOWN",
            'I cannot tell whether "it is so": the program for it said nothing for 1 s. I ended "run".',
        )

    def test_source_that_gives_up_is_named_and_the_next_one_watches(self):
        command = self.until(watch("abort", seconds=0.3), watch("so", server="watching_too", seconds=0.5))
        self.assert_reply(command, Reply.DONE, "DONE", 'Done. I ended "run", because "it is so" held.')
        self.assert_reply(
            self.until(watch("abort", seconds=0.3)),
            Reply.FAILED,
            "CONDITION_UNKNOWN",
            'I cannot tell whether "it is so": aborted as asked for. I ended "run".',
        )

    def test_without_a_source_nothing_begins(self):
        reply = self.wait_for_reply(self.until(watch("so", server="nobody")))
        self.assertEqual((Reply.FAILED, "CONDITION_UNKNOWN"), (reply.outcome, reply.code))
        self.assertIn("the program for it is not running", reply.sentence)
        self.assertEqual([], self.begun("run"))

    def test_failover_stays_in_its_clause(self):
        other = PlanNode(kind=PlanNode.DO, label="succeed at last")
        other.candidates = [candidate("abort", "one"), candidate("reject", "two"), candidate("succeed", "two")]
        command = self.send(
            node("SEQUENCE", 1, 3),
            node("REPEAT", 2, count=2, most=2),
            do("succeed"),
            node("UNTIL", 4, 5),
            condition(watch("so", seconds=60)),
            other,
        )
        reply = self.wait_for_reply(command)
        self.assertEqual((Reply.DONE, "DONE"), (reply.outcome, reply.code), reply.sentence)
        self.assertIn('I did "succeed" 2 times.', reply.sentence)
        begun = [line for line in self.log if line.split()[1] == "begins" and line.split()[2] != "watch"]
        expected = ["one succeed", "one succeed", "one abort", "two reject", "two succeed"]
        self.assertEqual([line.replace(" ", " begins ") for line in expected], begun)

    def test_stop_ends_the_work_and_the_watch(self):
        command = self.until(watch("so", seconds=60))
        self.wait_for_log("one begins run")
        self.stops.publish(StopReport(stop_stamp=rospy.Time.now()))
        self.assert_reply(command, Reply.SUPERSEDED, "STOPPED", "Stopped.")
        self.wait_for_log("one preempted run")

    def test_z_source_that_is_killed_ends_the_plan(self):
        command = self.until(watch("die", server="mortal", seconds=0.5))
        reply = self.wait_for_reply(command)
        self.assertEqual((Reply.FAILED, "CONDITION_UNKNOWN"), (reply.outcome, reply.code))
        self.assertIn("has died", reply.sentence)
        self.wait_for_log("one preempted run")


if __name__ == "__main__":
    rostest.rosrun("executor", "conditions_node", ConditionsTest)
