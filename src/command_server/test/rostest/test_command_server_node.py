#!/usr/bin/python3
"""The node: whatever the stages do, one reply to each command."""

import collections
import os
import signal
import time
import unittest
import xmlrpc.client

import actionlib
import rosgraph
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    CommandStatus,
    ExecuteCommandAction,
    ExecuteCommandGoal,
    Plan,
    PlanNode,
    Reply,
    StageEvent,
    StoppedPlan,
    StopReport,
)
from std_msgs.msg import String

from roboframenet_testing import wait_until


class CommandServerNodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.replies, cls.cancelled, cls.statuses = [], [], []
        cls.heard = []
        # The reply to the command that the last run left open may come as soon as somebody listens.
        cls.reply_subscriber = rospy.Subscriber("reply", Reply, cls.replies.append)
        rospy.init_node("test_command_server_node")
        cls.events = rospy.Publisher("stage_events", StageEvent, queue_size=1000)
        cls.reports = rospy.Publisher("stop_report", StopReport, queue_size=100)
        cls.text = rospy.Publisher("text", String, queue_size=1000)
        cls.subscribers = [
            rospy.Subscriber("command_text", Command, cls.on_command),
            rospy.Subscriber("command_cancel", Command, cls.cancelled.append),
            rospy.Subscriber("status", CommandStatus, cls.statuses.append),
        ]
        cls.client = actionlib.ActionClient("command", ExecuteCommandAction)
        wait_until(
            lambda: all(
                end.get_num_connections() == 1
                for end in cls.subscribers + [cls.events, cls.reports, cls.text, cls.reply_subscriber]
            )
        )
        assert cls.client.wait_for_server(rospy.Duration(60))

    @classmethod
    def on_command(cls, command):
        """All the stages at once: do with the command what its text says."""
        cls.heard.append(command)
        if command.text.startswith("silent"):
            return
        if command.text.startswith("hang in the executor"):
            cls.send_event(command, "executor")
            return
        if command.text.startswith("no, the garage"):
            cls.send_event(command, "semantic_framer")
            cls.send_event(command, "frame_registrar", is_final=True, outcome=Reply.REFUSED, code="NO_SERVER")
            return
        if command.text.startswith("no, be silent"):
            return
        if command.text.startswith(("don't", "no, ")):
            code = "NEGATED" if command.text.startswith("don't") else "CORRECTION"
            cls.send_event(command, "semantic_framer", is_final=True, outcome=Reply.REFUSED, code=code)
            return
        cls.send_event(command, "semantic_framer")
        for _ in range(2 if command.text.startswith("twice") else 1):
            cls.send_event(command, "executor", is_final=True)

    @classmethod
    def send_event(cls, command, stage, is_final=False, outcome=Reply.DONE, code="DONE", sentence=""):
        reply = Reply(
            command=command, outcome=outcome, stage=stage, code=code, sentence=sentence or f"did {command.text}"
        )
        cls.events.publish(
            StageEvent(
                command=command,
                stage=stage,
                stamp=rospy.Time.now(),
                sentence="at it",
                is_final=is_final,
                reply=reply if is_final else Reply(),
            )
        )

    def say(self, text):
        self.text.publish(String(text))

    def replies_to(self, text):
        return [reply for reply in list(self.replies) if reply.command.text == text]

    def wait_for_reply(self, text):
        wait_until(lambda: self.replies_to(text), message=f"no reply to {text!r}")
        return self.replies_to(text)[0]

    def fence(self):
        """Return when everything that was said before has been handled."""
        text = f"fence {time.monotonic()}"
        self.say(text)
        self.wait_for_reply(text)

    def test_flood_gets_one_reply_each(self):
        texts = [f"flood {index}" for index in range(50)]
        for text in texts:
            self.say(text)
        wait_until(lambda: all(self.replies_to(text) for text in texts))
        self.fence()
        counts = collections.Counter(reply.command.text for reply in self.replies)
        self.assertEqual({1}, {counts[text] for text in texts})
        sent = [command for command in self.heard if command.text.startswith("flood")]
        self.assertEqual(texts, [command.text for command in sent])
        self.assertEqual(50, len({command.id for command in sent}))
        stamps = [command.stamp.to_nsec() for command in sent]
        self.assertEqual(sorted(set(stamps)), stamps)

    def test_same_words_twice_are_two_commands(self):
        self.say("the same words")
        self.say("the same words")
        wait_until(lambda: len(self.replies_to("the same words")) == 2)
        self.assertEqual(2, len({reply.command.id for reply in self.replies_to("the same words")}))

    def test_second_final_event_is_dropped(self):
        self.say("twice please")
        self.wait_for_reply("twice please")
        self.fence()
        self.assertEqual(1, len(self.replies_to("twice please")))

    def test_silent_stage_is_named(self):
        self.say("silent one")
        reply = self.wait_for_reply("silent one")
        self.assertEqual(
            (Reply.FAILED, "STAGE_SILENT", "stanford_parser_ros"), (reply.outcome, reply.code, reply.stage)
        )

    def test_texts_that_are_no_commands_are_refused(self):
        self.say("   ")
        self.assertEqual("EMPTY_TEXT", self.wait_for_reply("   ").code)
        self.say("x" * 101)
        reply = self.wait_for_reply("x" * 100)
        self.assertEqual((Reply.REFUSED, "TEXT_TOO_LONG"), (reply.outcome, reply.code))

    def test_goal_gets_feedback_and_the_reply(self):
        text = "hang in the executor until there is feedback"
        feedback, ends = [], []
        handle = self.client.send_goal(
            ExecuteCommandGoal(text=text),
            feedback_cb=lambda _, message: feedback.append(message.event),
            transition_cb=lambda goal: ends.append(goal) if goal.get_comm_state() == actionlib.CommState.DONE else None,
        )
        # A client hears no feedback any more once it has the result, which comes by another connection.
        wait_until(lambda: feedback)
        command = next(command for command in self.heard if command.text == text)
        self.send_event(command, "executor", is_final=True)
        wait_until(lambda: ends)
        self.assertEqual(GoalStatus.SUCCEEDED, handle.get_terminal_state())
        self.assertEqual(f"did {text}", handle.get_result().reply.sentence)
        self.assertEqual(handle.get_result().reply.command.id, self.wait_for_reply(text).command.id)

    def test_many_goals_in_flight(self):
        handles = [self.client.send_goal(ExecuteCommandGoal(text=f"goal {index}")) for index in range(8)]
        wait_until(lambda: all(handle.get_comm_state() == actionlib.CommState.DONE for handle in handles))
        self.assertEqual(
            [f"goal {index}" for index in range(8)], [handle.get_result().reply.command.text for handle in handles]
        )

    def test_cancelled_goal_stops_its_command(self):
        handle = self.client.send_goal(ExecuteCommandGoal(text="silent goal"))
        wait_until(lambda: [c for c in self.heard if c.text == "silent goal"])
        handle.cancel()
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual(GoalStatus.PREEMPTED, handle.get_terminal_state())
        self.assertEqual(
            (Reply.SUPERSEDED, "STOPPED"), (handle.get_result().reply.outcome, handle.get_result().reply.code)
        )
        wait_until(lambda: [c for c in self.cancelled if c.text == "silent goal"])

    def test_cancelled_goal_that_runs_waits_for_the_executor(self):
        handle = self.client.send_goal(ExecuteCommandGoal(text="hang in the executor"))
        wait_until(
            lambda: any(
                status.stage == "executor" and [c for c in status.active if c.text == "hang in the executor"]
                for status in self.statuses
            )
        )
        handle.cancel()
        wait_until(lambda: [c for c in self.cancelled if c.text == "hang in the executor"])
        self.assertFalse(self.replies_to("hang in the executor"))
        (command,) = [command for command in self.cancelled if command.text == "hang in the executor"]
        self.send_event(command, "executor", is_final=True)
        self.assertEqual(Reply.DONE, self.wait_for_reply("hang in the executor").outcome)

    def test_stop_is_not_passed_on_and_ends_open_commands(self):
        self.say("silent before the stop")
        wait_until(lambda: [c for c in self.heard if c.text == "silent before the stop"])
        self.say("Halt!")
        reply = self.wait_for_reply("silent before the stop")
        self.assertEqual((Reply.SUPERSEDED, "STOPPED"), (reply.outcome, reply.code))
        self.report_stop("of_the_stop_server", "Halt!")
        self.fence()
        self.assertFalse([command for command in self.heard if command.text == "Halt!"])
        # The stop server gave the reply; there is no second one from here.
        self.assertFalse(self.replies_to("Halt!"))
        wait_until(lambda: self.statuses[-1].active == [])

    def report_stop(self, command_id, text, outcome=Reply.DONE, code="DONE"):
        """Reply as the stop server does; returns the stamp of the stop."""
        now = rospy.Time.now()
        command = Command(id=command_id, stamp=now, text=text)
        self.reports.publish(
            StopReport(
                command=command,
                stop_stamp=now,
                reply=Reply(
                    command=command, outcome=outcome, stage="stop_server", code=code, sentence="Stopped by report."
                ),
            )
        )
        return now

    def run_in_executor(self, text):
        """Say a command that runs until it is told to end; returns it as it was sent."""
        self.say(text)
        wait_until(
            lambda: any(
                status.stage == "executor" and [c for c in status.active if c.text == text] for status in self.statuses
            )
        )
        return next(command for command in self.heard if command.text == text)

    def end_in_executor(self, command):
        """End a command once it is cancelled, as the executor does."""
        wait_until(lambda: [c for c in self.cancelled if c.id == command.id])
        self.send_event(
            command, "executor", is_final=True, outcome=Reply.SUPERSEDED, code="STOPPED", sentence="Stopped."
        )

    def active_texts(self):
        return [command.text for status in self.statuses[-1:] for command in status.active]

    def test_stopped_plan_goes_on_after_a_question_and_a_yes(self):
        plans = []
        stopped = rospy.Publisher("stopped_plan", StoppedPlan, queue_size=10)
        planned = rospy.Subscriber("command_plan", CommandPlan, plans.append)
        wait_until(lambda: stopped.get_num_connections() == 1 and planned.get_num_connections() == 1)
        self.addCleanup(planned.unregister)
        self.addCleanup(stopped.unregister)
        self.say("silent until the stop")
        wait_until(lambda: [c for c in self.heard if c.text == "silent until the stop"])
        command = next(c for c in self.heard if c.text == "silent until the stop")
        self.say("Halt!")
        self.report_stop("of_a_stop", "Halt!")
        self.fence()
        plan = Plan(nodes=[PlanNode(kind=PlanNode.DO, label="wave")])
        stopped.publish(StoppedPlan(command=command, plan=plan, said='"wave"'))
        self.fence()
        for text in ("Go on.", "Carry on."):
            self.say(text)
            asked = self.wait_for_reply(text)
            self.assertEqual((Reply.NEEDS_INFORMATION, "CONFIRM"), (asked.outcome, asked.code))
            self.assertTrue(asked.sentence.endswith('Shall I go on with "wave"?'), asked.sentence)
            self.say("Yes." if text == "Carry on." else "fence, and no answer")
        wait_until(lambda: plans)
        self.assertEqual((plans[0].command.text, plans[0].plan.nodes[0].label), ("Yes.", "wave"))
        self.send_event(plans[0].command, "executor", is_final=True)
        self.assertEqual(self.wait_for_reply("Yes.").stage, "executor")
        self.assertFalse([c for c in self.heard if c.text == "Yes."])

    def test_forget_that_right_after_an_order_is_no_stop(self):
        self.say("an order is given")
        self.wait_for_reply("an order is given")
        # The reply of the stage that keeps orders.
        self.say("silent order")
        wait_until(lambda: [c for c in self.heard if c.text == "silent order"])
        order = next(c for c in self.heard if c.text == "silent order")
        self.send_event(order, "standing_orders", is_final=True, sentence="I will wave at noon.")
        self.wait_for_reply("silent order")
        self.say("Oh, forget it!")
        reply = self.wait_for_reply("Oh, forget it!")
        self.assertEqual((Reply.DONE, "executor"), (reply.outcome, reply.stage))
        self.assertTrue([c for c in self.heard if c.text == "Forget that."])

    def test_prohibition_ends_what_runs_and_says_so(self):
        command = self.run_in_executor("hang in the executor, forbidden")
        self.say("silent behind it")
        wait_until(lambda: "silent behind it" in self.active_texts())
        self.say("don't hang")
        # What has not begun ends at once; what runs is waited for.
        self.assertEqual("STOPPED", self.wait_for_reply("silent behind it").code)
        self.fence()
        self.assertFalse(self.replies_to("don't hang"))
        self.end_in_executor(command)
        reply = self.wait_for_reply("don't hang")
        self.assertEqual((Reply.REFUSED, "NEGATED", "semantic_framer"), (reply.outcome, reply.code, reply.stage))
        self.assertEqual(
            'I did not start "silent behind it". I stopped "hang in the executor, forbidden". You said not to.',
            reply.sentence,
        )
        self.assertEqual(Reply.SUPERSEDED, self.wait_for_reply("hang in the executor, forbidden").outcome)
        self.fence()
        self.assertEqual(1, len(self.replies_to("don't hang")))

    def test_correction_ends_what_runs_and_asks_on(self):
        command = self.run_in_executor("hang in the executor, wrongly")
        self.say("no, the office")
        self.end_in_executor(command)
        reply = self.wait_for_reply("no, the office")
        self.assertEqual((Reply.REFUSED, "CORRECTION"), (reply.outcome, reply.code))
        self.assertEqual('I stopped "hang in the executor, wrongly". did no, the office', reply.sentence)

    def test_correction_that_a_later_stage_refuses_ends_what_runs(self):
        for number, (said, code, why) in enumerate(
            (
                ("no, the garage", "NO_SERVER", "did no, the garage"),
                ("no, " + "go on and " * 20, "TEXT_TOO_LONG", "The text has 204 characters; I accept at most 100."),
            )
        ):
            running = f"hang in the executor, refused {number}"
            command = self.run_in_executor(running)
            self.say(said)
            self.end_in_executor(command)
            reply = self.wait_for_reply(said[:100])
            self.assertEqual((Reply.REFUSED, code), (reply.outcome, reply.code))
            self.assertEqual(f'I stopped "{running}". {why}', reply.sentence)
            self.assertEqual(Reply.SUPERSEDED, self.wait_for_reply(running).outcome)
            self.fence()
            self.assertEqual(1, len(self.replies_to(said[:100])))

    def test_correction_that_nobody_answers_ends_what_runs(self):
        command = self.run_in_executor("hang in the executor, unanswered")
        self.say("no, be silent")
        # Its executor speaks every second.
        while not [other for other in self.cancelled if other.id == command.id]:
            self.send_event(command, "executor")
            time.sleep(0.1)
        self.end_in_executor(command)
        reply = self.wait_for_reply("no, be silent")
        self.assertEqual((Reply.FAILED, "STAGE_SILENT"), (reply.outcome, reply.code))
        self.assertTrue(reply.sentence.startswith('I stopped "hang in the executor, unanswered". '), reply.sentence)
        # A stage that wakes changes nothing.
        self.send_event(reply.command, "executor", is_final=True)
        self.fence()
        self.assertEqual(1, len(self.replies_to("no, be silent")))

    def test_prohibition_of_what_is_already_done_is_refused(self):
        self.say("soon done")
        self.wait_for_reply("soon done")
        self.say("don't do anything")
        reply = self.wait_for_reply("don't do anything")
        self.assertEqual(
            (Reply.REFUSED, "NEGATED", "did don't do anything"), (reply.outcome, reply.code, reply.sentence)
        )

    def test_executor_that_does_not_end_it_makes_the_prohibition_fail(self):
        command = self.run_in_executor("hang in the executor, deaf")
        self.say("don't be deaf")
        reply = self.wait_for_reply("don't be deaf")
        self.assertEqual((Reply.FAILED, "NOT_STOPPED"), (reply.outcome, reply.code))
        self.assertIn('"hang in the executor, deaf"', reply.sentence)
        self.end_in_executor(command)
        self.wait_for_reply("hang in the executor, deaf")

    def test_stop_ends_a_prohibition_that_waits(self):
        self.run_in_executor("hang in the executor, stopped")
        self.say("don't go on")
        wait_until(lambda: "don't go on" in self.active_texts())
        self.say("stop it, stop")
        self.assertEqual("STOPPED", self.wait_for_reply("don't go on").code)
        self.assertEqual("STOPPED", self.wait_for_reply("hang in the executor, stopped").code)
        self.report_stop("stop_of_two", "stop it, stop")
        self.fence()
        self.assertEqual(1, len(self.replies_to("don't go on")))

    def test_command_behind_a_stop_begins_when_the_stop_is_answered(self):
        self.say("Stop and come back.")
        wait_until(lambda: "come back." in self.active_texts())
        self.fence()
        self.assertFalse([command for command in self.heard if command.text == "come back."])
        stamp = self.report_stop("stop_before_coming", "Stop and come back.")
        reply = self.wait_for_reply("come back.")
        self.assertEqual((Reply.DONE, "did come back."), (reply.outcome, reply.sentence))
        self.assertGreater(reply.command.stamp, stamp)
        self.fence()
        self.assertEqual([reply.command.id], [c.id for c in self.heard if c.text == "come back."])
        # The reply to the stop is the stop server's.
        self.assertFalse(self.replies_to("Stop and come back."))

    def test_command_behind_a_stop_does_not_begin_when_the_robot_does_not_stop(self):
        self.say("halt, then leap")
        self.report_stop("stop_in_vain", "halt, then leap", outcome=Reply.FAILED, code="NOT_STOPPED")
        reply = self.wait_for_reply("leap")
        self.assertEqual((Reply.FAILED, "NOT_STOPPED"), (reply.outcome, reply.code))
        self.fence()
        self.assertFalse([command for command in self.heard if command.text == "leap"])

    def test_next_stop_ends_the_command_behind_a_stop(self):
        self.say("stop and jump")
        wait_until(lambda: "jump" in self.active_texts())
        self.say("no, no, stop!")
        self.assertEqual("STOPPED", self.wait_for_reply("jump").code)
        self.report_stop("stop_before_jump", "stop and jump")
        self.report_stop("stop_after_jump", "no, no, stop!")
        self.fence()
        self.assertFalse([command for command in self.heard if command.text == "jump"])

    def test_warning_behind_a_stop_is_no_command(self):
        self.say("stop, you will hit the lamp")
        self.report_stop("stop_before_lamp", "stop, you will hit the lamp")
        self.fence()
        self.assertFalse([command for command in self.heard if "lamp" in command.text])

    def test_goal_with_a_command_behind_a_stop_ends_with_that_command(self):
        feedback = []
        handle = self.client.send_goal(
            ExecuteCommandGoal(text="Stop and crawl."), feedback_cb=lambda _, message: feedback.append(message.event)
        )
        goal_id = handle.comm_state_machine.action_goal.goal_id.id
        wait_until(lambda: "crawl." in self.active_texts())
        self.report_stop(goal_id, "Stop and crawl.")
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        reply = handle.get_result().reply
        self.assertEqual(
            ("crawl.", "did crawl.", GoalStatus.SUCCEEDED),
            (reply.command.text, reply.sentence, handle.get_terminal_state()),
        )
        self.assertNotEqual(goal_id, reply.command.id)
        wait_until(lambda: [event for event in feedback if event.command.id == reply.command.id])

    def test_cancelled_goal_ends_the_command_behind_its_stop(self):
        handle = self.client.send_goal(ExecuteCommandGoal(text="Stop and silently go."))
        wait_until(lambda: "silently go." in self.active_texts())
        handle.cancel()
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual("silently go.", handle.get_result().reply.command.text)
        self.assertEqual(GoalStatus.PREEMPTED, handle.get_terminal_state())
        self.report_stop(handle.comm_state_machine.action_goal.goal_id.id, "Stop and silently go.")
        self.fence()
        self.assertFalse([command for command in self.heard if command.text == "silently go."])

    def test_stop_goal_takes_the_reply_of_the_report(self):
        handle = self.client.send_goal(ExecuteCommandGoal(text="Abort!"))
        self.report_stop(handle.comm_state_machine.action_goal.goal_id.id, "Abort!")
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual("Stopped by report.", handle.get_result().reply.sentence)
        self.assertEqual(GoalStatus.SUCCEEDED, handle.get_terminal_state())

    def test_stop_that_no_stop_server_answers_is_answered(self):
        self.say("Freeze!")
        reply = self.wait_for_reply("Freeze!")
        self.assertEqual((Reply.FAILED, "STAGE_SILENT", "stop_server"), (reply.outcome, reply.code, reply.stage))

    def test_z_killed_command_server_answers_when_it_is_back(self):
        text = "silent when it\x07 is killed"
        self.say(text)
        wait_until(lambda: [command for command in self.heard if command.text == text])
        (command,) = [command for command in self.heard if command.text == text]
        api = rosgraph.Master(rospy.get_name()).lookupNode("/command_server")
        _, _, pid = xmlrpc.client.ServerProxy(api).getPid("/test_command_server_node")
        os.kill(pid, signal.SIGKILL)
        reply = self.wait_for_reply(text)
        self.assertEqual((Reply.FAILED, "RESTARTED"), (reply.outcome, reply.code))
        self.assertEqual((command.id, command.stamp), (reply.command.id, reply.command.stamp))


if __name__ == "__main__":
    rostest.rosrun("command_server", "command_server_node", CommandServerNodeTest)
