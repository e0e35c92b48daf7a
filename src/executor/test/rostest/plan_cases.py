"""Plans: clauses, repetitions, bounds and branches; a malformed plan is answered with the reason."""

import rospy
from executor_case import ExecutorCase, clause, frame, join
from roboframenet_msgs.msg import PlanNode, Reply

from roboframenet_testing import wait_until


class PlanCases(ExecutorCase):
    """The nodes of a plan."""

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
            'I did "Ping", but I could not do "wave at Alice": aborted as asked for. I did not begin "go home".',
        )
        self.assertEqual(["one begins succeed", "two begins abort"], self.begun())

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
            self.send_nodes(nodes),
            Reply.DONE,
            "DONE",
            "Done, though another way failed first: aborted as asked for",
            'I did "ping" 3 times.',
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
        self.assert_reply(command, Reply.FAILED, "ALL_CANDIDATES_FAILED", 'could not do "abort": aborted as asked for')

    def test_new_command_ends_all_branches(self):
        first = self.parallel("run", "run", "run")
        wait_until(lambda: len(self.begun()) == 3, message=lambda: self.log)
        second = self.send([[frame("succeed", "one")]])
        self.assert_reply(first, Reply.SUPERSEDED, "NEW_COMMAND")
        self.assert_reply(second, Reply.DONE, "DONE")
        for server in ("one", "two", "three"):
            self.wait_for_log(f"{server} preempted run")
