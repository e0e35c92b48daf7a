"""Commands that come while another one runs: they replace it, follow it, or run beside it."""

import rospy
from executor_case import ExecutorCase, clause, frame
from roboframenet_msgs.msg import FrameCallback, FrameServers, Plan, PlanNode, Reply, ServerProfile

from roboframenet_testing import wait_until


class CommandCases(ExecutorCase):
    """Commands that meet."""

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
        rospy.sleep(1.0)
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
        old = self.send([[frame("ignore_cancel", "one", "12")]])
        self.wait_for_log("one begins ignore_cancel")
        new = self.send([[frame("succeed", "two")]])
        self.assert_reply(old, Reply.SUPERSEDED, "NEW_COMMAND", "one did not end on cancel within 4 s")
        self.assert_reply(new, Reply.DONE, "DONE")

    def test_server_that_aborts_on_cancel_counts_as_preempted(self):
        old = self.send([[frame("abort_on_cancel", "one")], [frame("succeed", "three")]])
        self.wait_for_log("one begins abort_on_cancel")
        new = self.send([[frame("succeed", "two")]])
        self.assert_reply(old, Reply.SUPERSEDED, "NEW_COMMAND")
        self.assert_reply(new, Reply.DONE, "DONE")
        self.assertNotIn("three begins succeed", self.log)

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
