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
    Command, CommandStatus, ExecuteCommandAction, ExecuteCommandGoal, Reply, StageEvent, StopReport)
from std_msgs.msg import String


def wait_until(condition, timeout_s=60.0):
    end = time.monotonic() + timeout_s
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.02)
    return condition()


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
            rospy.Subscriber("status", CommandStatus, cls.statuses.append)]
        cls.client = actionlib.ActionClient("command", ExecuteCommandAction)
        assert wait_until(lambda: all(end.get_num_connections() == 1 for end in cls.subscribers + [
            cls.events, cls.reports, cls.text, cls.reply_subscriber]))
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
        cls.send_event(command, "semantic_framer")
        for _ in range(2 if command.text.startswith("twice") else 1):
            cls.send_event(command, "executor", is_final=True)

    @classmethod
    def send_event(cls, command, stage, is_final=False):
        reply = Reply(command=command, outcome=Reply.DONE, stage=stage, code="DONE", sentence=f"did {command.text}")
        cls.events.publish(StageEvent(command=command, stage=stage, stamp=rospy.Time.now(), sentence="at it",
                                      is_final=is_final, reply=reply if is_final else Reply()))

    def say(self, text):
        self.text.publish(String(text))

    def replies_to(self, text):
        return [reply for reply in list(self.replies) if reply.command.text == text]

    def wait_for_reply(self, text):
        self.assertTrue(wait_until(lambda: self.replies_to(text)), f"no reply to {text!r}")
        return self.replies_to(text)[0]

    def fence(self):
        """Return when everything that was said before has been handled."""
        text = f"fence {time.monotonic()}"
        self.say(text)
        self.wait_for_reply(text)

    def test_command_left_open_by_the_last_run_is_answered(self):
        self.assertTrue(wait_until(lambda: [r for r in self.replies if r.command.id == "left_over"]))
        (reply,) = [reply for reply in self.replies if reply.command.id == "left_over"]
        self.assertEqual((Reply.FAILED, "RESTARTED"), (reply.outcome, reply.code))
        self.assertEqual(("say \x07 it", 5, 7),
                         (reply.command.text, reply.command.stamp.secs, reply.command.stamp.nsecs))

    def test_flood_gets_one_reply_each(self):
        texts = [f"flood {index}" for index in range(50)]
        for text in texts:
            self.say(text)
        self.assertTrue(wait_until(lambda: all(self.replies_to(text) for text in texts)))
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
        self.assertTrue(wait_until(lambda: len(self.replies_to("the same words")) == 2))
        self.assertEqual(2, len({reply.command.id for reply in self.replies_to("the same words")}))

    def test_second_final_event_is_dropped(self):
        self.say("twice please")
        self.wait_for_reply("twice please")
        self.fence()
        self.assertEqual(1, len(self.replies_to("twice please")))

    def test_silent_stage_is_named(self):
        self.say("silent one")
        reply = self.wait_for_reply("silent one")
        self.assertEqual((Reply.FAILED, "STAGE_SILENT", "stanford_parser_ros"),
                         (reply.outcome, reply.code, reply.stage))

    def test_texts_that_are_no_commands_are_refused(self):
        self.say("   ")
        self.assertEqual("EMPTY_TEXT", self.wait_for_reply("   ").code)
        self.say("x" * 101)
        reply = self.wait_for_reply("x" * 100)
        self.assertEqual((Reply.REFUSED, "TEXT_TOO_LONG"), (reply.outcome, reply.code))

    def test_goal_gets_feedback_and_the_reply(self):
        feedback, ends = [], []
        handle = self.client.send_goal(
            ExecuteCommandGoal(text="by action"), feedback_cb=lambda _, message: feedback.append(message.event),
            transition_cb=lambda goal: ends.append(goal) if goal.get_comm_state() == actionlib.CommState.DONE else None)
        self.assertTrue(wait_until(lambda: ends))
        self.assertEqual(GoalStatus.SUCCEEDED, handle.get_terminal_state())
        self.assertEqual("did by action", handle.get_result().reply.sentence)
        self.assertTrue(wait_until(lambda: feedback))
        self.assertEqual(handle.get_result().reply.command.id, self.wait_for_reply("by action").command.id)

    def test_many_goals_in_flight(self):
        handles = [self.client.send_goal(ExecuteCommandGoal(text=f"goal {index}")) for index in range(8)]
        self.assertTrue(wait_until(lambda: all(
            handle.get_comm_state() == actionlib.CommState.DONE for handle in handles)))
        self.assertEqual([f"goal {index}" for index in range(8)],
                         [handle.get_result().reply.command.text for handle in handles])

    def test_cancelled_goal_stops_its_command(self):
        handle = self.client.send_goal(ExecuteCommandGoal(text="silent goal"))
        self.assertTrue(wait_until(lambda: [c for c in self.heard if c.text == "silent goal"]))
        handle.cancel()
        self.assertTrue(wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE))
        self.assertEqual(GoalStatus.PREEMPTED, handle.get_terminal_state())
        self.assertEqual((Reply.SUPERSEDED, "STOPPED"),
                         (handle.get_result().reply.outcome, handle.get_result().reply.code))
        self.assertTrue(wait_until(lambda: [c for c in self.cancelled if c.text == "silent goal"]))

    def test_cancelled_goal_that_runs_waits_for_the_executor(self):
        handle = self.client.send_goal(ExecuteCommandGoal(text="hang in the executor"))
        self.assertTrue(wait_until(lambda: any(
            status.stage == "executor" and [c for c in status.active if c.text == "hang in the executor"]
            for status in self.statuses)))
        handle.cancel()
        self.assertTrue(wait_until(lambda: [c for c in self.cancelled if c.text == "hang in the executor"]))
        self.assertFalse(self.replies_to("hang in the executor"))
        (command,) = [command for command in self.cancelled if command.text == "hang in the executor"]
        self.send_event(command, "executor", is_final=True)
        self.assertEqual(Reply.DONE, self.wait_for_reply("hang in the executor").outcome)

    def test_stop_is_not_passed_on_and_ends_open_commands(self):
        self.say("silent before the stop")
        self.assertTrue(wait_until(lambda: [c for c in self.heard if c.text == "silent before the stop"]))
        self.say("Halt!")
        reply = self.wait_for_reply("silent before the stop")
        self.assertEqual((Reply.SUPERSEDED, "STOPPED"), (reply.outcome, reply.code))
        self.report_stop("of_the_stop_server", "Halt!")
        self.fence()
        self.assertFalse([command for command in self.heard if command.text == "Halt!"])
        # The stop server gave the reply; there is no second one from here.
        self.assertFalse(self.replies_to("Halt!"))
        self.assertTrue(wait_until(lambda: self.statuses[-1].active == []))

    def report_stop(self, command_id, text):
        now = rospy.Time.now()
        command = Command(id=command_id, stamp=now, text=text)
        self.reports.publish(StopReport(command=command, stop_stamp=now, reply=Reply(
            command=command, outcome=Reply.DONE, stage="stop_server", code="DONE", sentence="Stopped by report.")))

    def test_stop_goal_takes_the_reply_of_the_report(self):
        handle = self.client.send_goal(ExecuteCommandGoal(text="Abort!"))
        self.report_stop(handle.comm_state_machine.action_goal.goal_id.id, "Abort!")
        self.assertTrue(wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE))
        self.assertEqual("Stopped by report.", handle.get_result().reply.sentence)
        self.assertEqual(GoalStatus.SUCCEEDED, handle.get_terminal_state())

    def test_stop_that_no_stop_server_answers_is_answered(self):
        self.say("Freeze!")
        reply = self.wait_for_reply("Freeze!")
        self.assertEqual((Reply.FAILED, "STAGE_SILENT", "stop_server"), (reply.outcome, reply.code, reply.stage))

    def test_z_killed_command_server_answers_when_it_is_back(self):
        self.say("silent when it is killed")
        self.assertTrue(wait_until(lambda: [c for c in self.heard if c.text == "silent when it is killed"]))
        api = rosgraph.Master(rospy.get_name()).lookupNode("/command_server")
        _, _, pid = xmlrpc.client.ServerProxy(api).getPid("/test_command_server_node")
        os.kill(pid, signal.SIGKILL)
        reply = self.wait_for_reply("silent when it is killed")
        self.assertEqual((Reply.FAILED, "RESTARTED"), (reply.outcome, reply.code))


if __name__ == "__main__":
    rostest.rosrun("command_server", "command_server_node", CommandServerNodeTest)
