#!/usr/bin/python3
"""The node with servers that misbehave: one final event for each command, and the right server runs."""

import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalID
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FrameCallback,
    FrameServers,
    Plan,
    PlanCandidate,
    PlanNode,
    Reply,
    ServerProfile,
    StageEvent,
    StoppedPlan,
    StopReport,
)
from smach_msgs.msg import SmachContainerStructure
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


class ExecutorNodeTest(unittest.TestCase):
    count = 0

    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_executor_node")
        cls.events, cls.log = [], []
        cls.plans = rospy.Publisher("command_plan", CommandPlan, queue_size=1000)
        cls.stops = rospy.Publisher("stop_report", StopReport, queue_size=10)
        cls.cancels = rospy.Publisher("command_cancel", Command, queue_size=10)
        cls.server_cancel = rospy.Publisher("one/cancel", GoalID, queue_size=10)
        subscribers = [rospy.Subscriber("stage_events", StageEvent, cls.events.append)]
        log = rospy.Subscriber("server_log", String, lambda message: cls.log.append(message.data))
        wait_until(
            lambda: all(
                entity.get_num_connections() == 1 for entity in subscribers + [cls.plans, cls.stops, cls.cancels]
            )
        )
        wait_until(lambda: log.get_num_connections() == 3 and cls.server_cancel.get_num_connections() == 1)

    def setUp(self):
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

    def test_sequence_runs_in_order(self):
        command = self.send([[frame("succeed", "one"), frame("succeed", "two"), frame("succeed", "three")]])
        self.assert_reply(command, Reply.DONE, "DONE")
        self.wait_for_log("three ends succeed")
        self.assertEqual(
            [f"{server} {what} succeed" for server in ("one", "two", "three") for what in ("begins", "ends")], self.log
        )

    def test_second_candidate_runs_when_the_first_aborts(self):
        command = self.send([[frame("abort", "one")], [frame("succeed", "two")]])
        self.assert_reply(command, Reply.DONE, "DONE", "one aborted: aborted as asked for")
        self.wait_for_log("two ends succeed")

    def test_next_candidate_starts_from_its_first_frame(self):
        command = self.send(
            [[frame("succeed", "one"), frame("abort", "two")], [frame("succeed", "one"), frame("succeed", "three")]]
        )
        self.assert_reply(command, Reply.DONE, "DONE", "two aborted")
        self.wait_for_log("three ends succeed")
        self.assertEqual(
            ["one", "two", "one", "three"], [line.split()[0] for line in self.log if line.split()[1] == "begins"]
        )

    def test_every_way_to_fail_is_named_and_the_next_candidate_runs(self):
        for behaviour, server, part in (
            ("abort", "one", "one aborted: aborted as asked for"),
            ("reject", "one", "one rejected the goal: rejected as asked for"),
            ("unsuccessful", "one", "its result says that it did not succeed"),
            ("lose", "one", "one lost the goal"),
            ("drop_result", "one", "one said SUCCEEDED but sent no result"),
            ("raise", "one", "one did not accept the goal"),
            ("succeed", "nobody", "nobody is not running"),
            ("succeed", "not a name", "not a name cannot be reached"),
            ("freeze", "freezing", "freezing was silent"),
            ("die", "mortal", "mortal has died"),
        ):
            with self.subTest(behaviour=behaviour, server=server):
                command = self.send([[frame(behaviour, server)], [frame("succeed", "two")]])
                self.assert_reply(command, Reply.DONE, "DONE", part)

    def test_when_all_fail_each_server_is_named(self):
        command = self.send([[frame("abort", "one")], [frame("reject", "two")]])
        self.assert_reply(command, Reply.FAILED, "ALL_CANDIDATES_FAILED", "one aborted", "two rejected the goal")

    def test_new_command_preempts_the_one_that_runs(self):
        old = self.send([[frame("run", "one")], [frame("succeed", "three")]])
        self.wait_for_log("one begins run")
        new = self.send([[frame("succeed", "two")]])
        self.assert_reply(old, Reply.SUPERSEDED, "NEW_COMMAND")
        self.assert_reply(new, Reply.DONE, "DONE")
        self.wait_for_log("two ends succeed")
        self.assertEqual(["one begins run", "one preempted run", "two begins succeed", "two ends succeed"], self.log)

    @staticmethod
    def half_a_second(label, server):
        """A command that is done after half a second."""
        return [
            PlanNode(kind=PlanNode.UNTIL, label=label, children=[1], duration=rospy.Duration.from_sec(0.5)),
            clause(label, [[frame("run", server)]]),
        ]

    def test_command_that_follows_begins_when_what_runs_has_ended(self):
        first = self.send_nodes(self.half_a_second("turn", "one"))
        self.wait_for_log("one begins run")
        then = self.send_nodes([clause("bow", [[frame("succeed", "two")]])], beginning=Plan.FOLLOW)
        self.assert_reply(first, Reply.DONE, "DONE")
        self.assert_reply(then, Reply.DONE, "DONE")
        self.assertEqual(["one begins run", "two begins succeed"], self.begun())
        failing = self.send([[frame("abort", "one")]])
        lost = self.send_nodes([clause("bow", [[frame("succeed", "two")]])], beginning=Plan.FOLLOW)
        self.assert_reply(failing, Reply.FAILED, "ALL_CANDIDATES_FAILED")
        self.assertIn(self.wait_for_reply(lost).code, ("NOT_BEGUN", "DONE"))

    def test_command_runs_beside_another_if_their_servers_share_nothing(self):
        servers = rospy.Publisher("frame_servers", FrameServers, queue_size=1, latch=True)
        profiles = [("run", "one", "base"), ("run", "two", "voice"), ("succeed", "three", "base")]
        servers.publish(
            FrameServers(
                callbacks=[
                    FrameCallback(name, server, True, ServerProfile(occupies=[resource]))
                    for name, server, resource in profiles
                ]
            )
        )
        wait_until(lambda: servers.get_num_connections() > 0)
        rospy.sleep(0.3)
        first = self.send_nodes([clause("drive", [[frame("run", "one")]])])
        self.wait_for_log("one begins run")
        refused = self.send_nodes([clause("push", [[frame("succeed", "three")]])], beginning=Plan.BESIDE)
        self.assert_reply(refused, Reply.FAILED, "NOT_BESIDE", 'beside "drive"')
        beside = self.send_nodes(self.half_a_second("sing", "two"), beginning=Plan.BESIDE)
        self.assert_reply(beside, Reply.DONE, "DONE", 'I ended "sing" after 0.5 seconds.')
        self.assertEqual([], self.events_of(first, True))
        free = self.send_nodes([clause("push", [[frame("succeed", "three")]])], beginning=Plan.WHEN_FREE)
        self.assert_reply(free, Reply.SUPERSEDED, "NOT_FREE")
        other = self.send_nodes([clause("sing", [[frame("run", "two")]])], beginning=Plan.BESIDE)
        self.wait_for_log("two begins run")
        new = self.send([[frame("succeed", "three")]])
        self.assert_reply(first, Reply.SUPERSEDED, "NEW_COMMAND")
        self.assert_reply(other, Reply.SUPERSEDED, "NEW_COMMAND")
        self.assert_reply(new, Reply.DONE, "DONE")
        servers.unregister()

    def test_older_command_does_not_run(self):
        old_stamp = rospy.Time.now()
        new = self.send([[frame("run", "one")]])
        self.wait_for_log("one begins run")
        old = self.send([[frame("succeed", "two")]], stamp=old_stamp)
        self.assert_reply(old, Reply.SUPERSEDED, "NEW_COMMAND")
        self.cancels.publish(new)
        self.assert_reply(new, Reply.SUPERSEDED, "STOPPED")

    def test_flood_gets_one_final_event_each(self):
        commands = [self.send([[frame("run", "one")]]) for _ in range(49)]
        last = self.send([[frame("succeed", "two")]])
        self.assert_reply(last, Reply.DONE, "DONE")
        for command in commands:
            self.assert_reply(command, Reply.SUPERSEDED, "NEW_COMMAND")
            self.assertEqual(1, len(self.events_of(command, True)))

    def test_server_that_ignores_the_cancel_is_named_and_the_new_command_runs(self):
        old = self.send([[frame("ignore_cancel", "one", "8")]])
        self.wait_for_log("one begins ignore_cancel")
        new = self.send([[frame("succeed", "two")]])
        self.assert_reply(old, Reply.SUPERSEDED, "NEW_COMMAND", "one did not end on cancel within 2 s")
        self.assert_reply(new, Reply.DONE, "DONE")

    def test_server_that_aborts_on_cancel_counts_as_preempted(self):
        old = self.send([[frame("abort_on_cancel", "one")], [frame("succeed", "three")]])
        self.wait_for_log("one begins abort_on_cancel")
        new = self.send([[frame("succeed", "two")]])
        self.assert_reply(old, Reply.SUPERSEDED, "NEW_COMMAND")
        self.assert_reply(new, Reply.DONE, "DONE")
        self.assertNotIn("three begins succeed", self.log)

    def test_goal_cancelled_by_somebody_else_ends_the_command(self):
        command = self.send([[frame("run", "one")], [frame("succeed", "two")]])
        self.wait_for_log("one begins run")
        wait_until(lambda: self.events_of(command, False))
        self.server_cancel.publish(GoalID())
        self.assert_reply(command, Reply.SUPERSEDED, "STOPPED", "Another client cancelled it: one was preempted")
        self.assertNotIn("two begins succeed", self.log)

    def test_stop_ends_the_command_and_refuses_what_was_said_before(self):
        before = rospy.Time.now()
        command = self.send([[frame("run", "one")], [frame("succeed", "two")]])
        self.wait_for_log("one begins run")
        self.stops.publish(StopReport(stop_stamp=rospy.Time.now()))
        self.assert_reply(command, Reply.SUPERSEDED, "STOPPED")
        self.wait_for_log("one preempted run")
        late = self.send([[frame("succeed", "two")]], stamp=before)
        self.assert_reply(late, Reply.SUPERSEDED, "STOPPED")
        self.assertNotIn("two begins succeed", self.log)
        after = self.send([[frame("succeed", "two")]])
        self.assert_reply(after, Reply.DONE, "DONE")

    def test_stop_tells_what_is_left(self):
        offered = []
        subscriber = rospy.Subscriber("stopped_plan", StoppedPlan, offered.append)
        wait_until(lambda: subscriber.get_num_connections() == 1)
        self.addCleanup(subscriber.unregister)
        clauses = [
            ("ping", [[frame("succeed", "one")]]),
            ("run", [[frame("run", "one")]]),
            ("wave", [[frame("succeed", "two")]]),
        ]
        command = self.send_clauses(*clauses)
        self.wait_for_log("one begins run")
        self.stops.publish(StopReport(stop_stamp=rospy.Time.now()))
        self.assert_reply(command, Reply.SUPERSEDED, "STOPPED", 'I did "ping"')
        wait_until(lambda: [one for one in offered if one.command.id == command.id])
        (left,) = [one for one in offered if one.command.id == command.id]
        self.assertEqual(left.said, '"run" and "wave"')
        self.assertEqual([node.label for node in left.plan.nodes], ["do it all", "run", "wave"])
        # What a newer command ends is over.
        replaced = self.send([[frame("run", "one")]])
        self.assert_reply(self.send([[frame("succeed", "two")]]), Reply.DONE, "DONE")
        self.assertFalse([one for one in offered if one.command.id == replaced.id])

    def test_stop_while_the_server_does_not_accept(self):
        command = self.send([[frame("accept_late", "one", "60")]])
        self.wait_for_log("one begins accept_late")
        self.stops.publish(StopReport(stop_stamp=rospy.Time.now()))
        self.assert_reply(command, Reply.SUPERSEDED, "STOPPED")

    def test_events_come_while_it_runs(self):
        command = self.send([[frame("run", "one")]])
        wait_until(
            lambda: len([event for event in self.events_of(command, False) if "run by one" in event.sentence]) >= 4
        )
        stamps = [event.stamp.to_sec() for event in self.events_of(command, False)]
        self.assertEqual(sorted(stamps), stamps)
        self.cancels.publish(command)
        self.wait_for_reply(command)

    def test_malformed_plans_are_answered_with_the_reason(self):
        good = clause("x", [[frame("succeed", "one")]])
        for nodes, part in (
            ([], "the plan has no nodes"),
            ([clause("x", [])], "a clause has no candidates"),
            ([clause("x", [[]])], "a candidate has no frames"),
            ([clause("x", [[frame("succeed", "")]])], "exactly one action server"),
            ([join("x")], "a sequence has no children"),
            ([join("x", 1, 7), good], "no such node"),
            ([join("x", 1, 1), good], "node 1 of the plan has two parents"),
            ([join("x", 1), good, good], "are not reached from its root"),
            ([join("x", 1), good, join("y", 3), join("z", 2)], "nodes 2, 3 of the plan are not reached from its root"),
            ([join("x", 1), join("y", 0)], "the root for a child"),
            ([join("x", index + 1) for index in range(900)] + [good], "more than 32 levels"),
            ([good] * 2000, "the plan has 2000 nodes"),
            ([PlanNode(kind=99)], "is of the kind 99"),
        ):
            with self.subTest(part=part):
                self.assert_reply(self.send_nodes(nodes), Reply.FAILED, "STAGE_ERROR", part)
        self.assertEqual([], self.log)

    def test_failover_stays_in_its_clause(self):
        # "Ping and wave at Alice.", with three servers for waving, two of which fail.
        command = self.send_clauses(
            ("Ping", [[frame("succeed", "one")], [frame("succeed", "three")]]),
            ("wave at Alice", [[frame("abort", "two")], [frame("reject", "three")], [frame("succeed", "two")]]),
        )
        self.assert_reply(command, Reply.DONE, "DONE", "two aborted", "three rejected the goal")
        self.wait_for_log("two ends succeed")
        self.assertEqual(
            ["one begins succeed", "two begins abort", "three begins reject", "two begins succeed"], self.begun()
        )

    def test_failover_starts_the_sequence_of_its_clause_again(self):
        command = self.send_clauses(
            ("Ping", [[frame("succeed", "one")]]),
            (
                "fetch it",
                [
                    [frame("succeed", "two"), frame("abort", "three")],
                    [frame("succeed", "two"), frame("succeed", "three")],
                ],
            ),
        )
        self.assert_reply(command, Reply.DONE, "DONE", "three aborted")
        self.wait_for_log("three ends succeed")
        self.assertEqual(["one", "two", "three", "two", "three"], [line.split()[0] for line in self.begun()])

    def test_clause_that_fails_ends_the_plan_and_the_reply_says_what_was_done(self):
        command = self.send_clauses(
            ("Ping", [[frame("succeed", "one")]]),
            ("wave at Alice", [[frame("abort", "two")]]),
            ("go home", [[frame("succeed", "three")]]),
        )
        self.assert_reply(
            command,
            Reply.FAILED,
            "ALL_CANDIDATES_FAILED",
            'I did "Ping", but I could not do "wave at Alice": two aborted: aborted as asked for. '
            'I did not begin "go home".',
        )
        self.assertEqual(["one begins succeed", "two begins abort"], self.begun())

    def test_new_command_in_each_clause_leaves_the_rest(self):
        for number in range(3):
            with self.subTest(clause=number):
                del self.log[:]
                behaviours = ["succeed"] * number + ["run"] + ["succeed"] * (2 - number)
                old = self.send_clauses(
                    *(
                        (f"part {index}", [[frame(behaviour, "one")], [frame(behaviour, "three")]])
                        for index, behaviour in enumerate(behaviours)
                    )
                )
                self.wait_for_log("one begins run")
                new = self.send([[frame("succeed", "two")]])
                self.assert_reply(old, Reply.SUPERSEDED, "NEW_COMMAND", *(f'"part {index}"' for index in range(number)))
                self.assert_reply(new, Reply.DONE, "DONE")
                self.wait_for_log("two ends succeed")
                self.assertEqual(
                    ["one begins succeed"] * number + ["one begins run", "two begins succeed"], self.begun()
                )

    def test_repetition_waits_and_or_else(self):
        nodes = [
            join("all", 1, 3, 4),
            PlanNode(kind=PlanNode.REPEAT, label="three times", children=[2], count=3, most=3),
            clause("ping", [[frame("succeed", "one")]]),
            PlanNode(kind=PlanNode.WAIT, label="wait", duration=rospy.Duration.from_sec(0.2)),
            PlanNode(kind=PlanNode.FALLBACK, label="or else", children=[5, 6]),
            clause("wave", [[frame("abort", "two")]]),
            clause("bow", [[frame("succeed", "three")]]),
        ]
        self.assert_reply(
            self.send_nodes(nodes), Reply.DONE, "DONE", "Done, after two aborted", 'I did "ping" 3 times.'
        )
        wait_until(lambda: len(self.begun()) == 5, message=lambda: self.log)
        self.assertEqual(["one"] * 3 + ["two", "three"], [line.split()[0] for line in self.begun()])

    def test_time_that_is_over_ends_a_clause(self):
        nodes = [
            PlanNode(kind=PlanNode.UNTIL, label="all", children=[1], duration=rospy.Duration.from_sec(0.5)),
            clause("follow me", [[frame("run", "one")]]),
        ]
        self.assert_reply(self.send_nodes(nodes), Reply.DONE, "DONE", 'I ended "follow me" after 0.5 seconds.')
        self.wait_for_log("one preempted run")

    def test_limit_that_is_over_ends_a_clause(self):
        nodes = [
            join("all", 1, 2),
            clause("follow me", [[frame("run", "one")]]),
            clause("bow", [[frame("succeed", "two")]]),
        ]
        nodes[1].limit = rospy.Duration.from_sec(0.5)
        self.assert_reply(
            self.send_nodes(nodes),
            Reply.FAILED,
            "LIMIT_REACHED",
            '"follow me" was not done within 0.5 seconds. I ended "follow me". I did not begin "bow".',
        )
        self.wait_for_log("one preempted run")
        self.assertEqual(["one begins run"], self.begun())

    def parallel(self, *behaviours, count=0):
        servers = ("one", "two", "three")
        leaves = [clause(behaviour, [[frame(behaviour, server)]]) for behaviour, server in zip(behaviours, servers)]
        root = PlanNode(kind=PlanNode.PARALLEL, label="all", children=list(range(1, len(leaves) + 1)), count=count)
        return self.send_nodes([root] + leaves)

    def test_branches_run_at_the_same_time(self):
        self.assert_reply(self.parallel("succeed", "run", "run", count=1), Reply.DONE, "DONE", "Done.")
        for server in ("two", "three"):
            if f"{server} begins run" in self.log:
                self.wait_for_log(f"{server} preempted run")

    def test_branch_that_fails_ends_the_others(self):
        command = self.parallel("run", "abort")
        self.assert_reply(command, Reply.FAILED, "ALL_CANDIDATES_FAILED", 'could not do "abort": two aborted')

    def test_new_command_ends_all_branches(self):
        first = self.parallel("run", "run", "run")
        wait_until(lambda: len(self.begun()) == 3, message=lambda: self.log)
        second = self.send([[frame("succeed", "one")]])
        self.assert_reply(first, Reply.SUPERSEDED, "NEW_COMMAND")
        self.assert_reply(second, Reply.DONE, "DONE")
        for server in ("one", "two", "three"):
            self.wait_for_log(f"{server} preempted run")

    def test_viewer_sees_the_words_of_the_clauses(self):
        seen = {}
        viewer = rospy.Subscriber(
            "executor/smach/container_structure",
            SmachContainerStructure,
            lambda structure: seen.update({structure.path: structure.children}),
        )
        command = self.send_clauses(("Ping", [[frame("run", "one")]]), ("wave at Alice", [[frame("succeed", "two")]]))
        wait_until(lambda: "/do it all/2 wave at Alice/candidate_1" in seen, message=lambda: seen)
        self.assertEqual(["1 Ping", "2 wave at Alice"], seen["/do it all"])
        self.assertEqual(["1_succeed_by_two"], seen["/do it all/2 wave at Alice/candidate_1"])
        self.cancels.publish(command)
        self.wait_for_reply(command)
        viewer.unregister()

    def test_viewer_stays_connected_from_one_machine_to_the_next(self):
        seen = set()
        viewer = rospy.Subscriber(
            "executor/smach/container_structure", SmachContainerStructure, lambda structure: seen.add(structure.path)
        )
        # Nothing runs yet.
        wait_until(lambda: viewer.get_num_connections() > 0)
        for words in ("Ping", "wave at Alice"):
            command = self.send_clauses((words, [[frame("run", "one")]]), ("go home", [[frame("succeed", "two")]]))
            wait_until(lambda words=words: f"/do it all/1 {words}/candidate_1" in seen, message=lambda: seen)
            self.cancels.publish(command)
            self.wait_for_reply(command)
            self.assertGreater(viewer.get_num_connections(), 0)
        viewer.unregister()

    def test_more_servers_than_connections(self):
        for _ in range(3):
            command = self.send([[frame("succeed", server) for server in ("one", "two", "three", "one")]])
            self.assert_reply(command, Reply.DONE, "DONE")
        # The log comes on another connection, and must not run into the next test.
        wait_until(lambda: sum("ends" in line for line in self.log) == 12, message=lambda: self.log)

    def test_server_busy_with_another_client_is_left_alone(self):
        client = actionlib.ActionClient("three", FilledSemanticFrameAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60.0)))
        goal = FilledSemanticFrameAction().action_goal.goal
        goal.frame = frame("run", "three")
        handle = client.send_goal(goal)
        self.wait_for_log("three begins run")
        self.assert_reply(self.send([[frame("succeed", "three")]]), Reply.DONE, "DONE")
        self.assertNotIn("three preempted run", self.log)
        handle.cancel()
        self.wait_for_log("three preempted run")


if __name__ == "__main__":
    rostest.rosrun("executor", "executor_node", ExecutorNodeTest)
