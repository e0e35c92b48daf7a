"""Servers that misbehave: every way to fail is named, and the next candidate runs."""

import os
import signal
import time

import actionlib
import rospy
from executor_case import ExecutorCase, frame
from roboframenet_msgs.msg import FilledSemanticFrameAction, Reply

from roboframenet_testing import wait_until
from roboframenet_testing.ros_processes import process_of


class CandidateCases(ExecutorCase):
    """The candidates of a clause."""

    def test_sequence_runs_in_order(self):
        command = self.send([[frame("succeed", "one"), frame("succeed", "two"), frame("succeed", "three")]])
        self.assert_reply(command, Reply.DONE, "DONE")
        self.wait_for_log("three ends succeed")
        self.assertEqual(
            [f"{server} {what} succeed" for server in ("one", "two", "three") for what in ("begins", "ends")], self.log
        )

    def test_second_candidate_runs_when_the_first_aborts(self):
        command = self.send([[frame("abort", "one")], [frame("succeed", "two")]])
        self.assert_reply(command, Reply.DONE, "DONE", "aborted as asked for")
        self.wait_for_log("two ends succeed")

    def test_next_candidate_starts_from_its_first_frame(self):
        command = self.send(
            [[frame("succeed", "one"), frame("abort", "two")], [frame("succeed", "one"), frame("succeed", "three")]]
        )
        self.assert_reply(command, Reply.DONE, "DONE", "aborted as asked for")
        self.wait_for_log("three ends succeed")
        self.assertEqual(
            ["one", "two", "one", "three"], [line.split()[0] for line in self.log if line.split()[1] == "begins"]
        )

    def test_every_way_to_fail_is_named_and_the_next_candidate_runs(self):
        for behaviour, server, part in (
            ("abort", "one", "aborted as asked for"),
            ("reject", "one", "rejected as asked for"),
            ("unsuccessful", "one", "its result says that it did not succeed"),
            ("lose", "one", "lost the goal"),
            ("drop_result", "one", "said SUCCEEDED but sent no result"),
            ("raise", "one", "did not accept the goal"),
            ("freeze", "freezing", "was silent"),
            ("die", "mortal", "has died"),
        ):
            with self.subTest(behaviour=behaviour, server=server):
                command = self.send([[frame(behaviour, server)], [frame("succeed", "two")]])
                self.assert_reply(command, Reply.DONE, "DONE", part)

    def test_server_is_not_silent_while_the_executor_does_not_run(self):
        command = self.send([[frame("run", "one")], [frame("succeed", "two")]])
        self.wait_for_log("one begins run")
        pid = process_of("executor")
        os.kill(pid, signal.SIGSTOP)
        time.sleep(rospy.get_param("executor/silence_timeout_s") + 0.5)
        os.kill(pid, signal.SIGCONT)
        time.sleep(1.0)
        self.assertEqual(["one begins run"], self.log)
        self.cancels.publish(command)
        self.assert_reply(command, Reply.SUPERSEDED, "STOPPED")

    def test_when_all_fail_each_server_is_named(self):
        command = self.send([[frame("abort", "one")], [frame("reject", "two")]])
        self.assert_reply(
            command, Reply.FAILED, "ALL_CANDIDATES_FAILED", "aborted as asked for", "rejected as asked for"
        )

    def test_failover_stays_in_its_clause(self):
        # "Ping and wave at Alice.", with three servers for waving, two of which fail.
        command = self.send_clauses(
            ("Ping", [[frame("succeed", "one")], [frame("succeed", "three")]]),
            ("wave at Alice", [[frame("abort", "two")], [frame("reject", "three")], [frame("succeed", "two")]]),
        )
        self.assert_reply(command, Reply.DONE, "DONE", "aborted as asked for", "rejected as asked for")
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
        self.assert_reply(command, Reply.DONE, "DONE", "aborted as asked for")
        self.wait_for_log("three ends succeed")
        self.assertEqual(["one", "two", "three", "two", "three"], [line.split()[0] for line in self.begun()])

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
