"""Plays the stages around the command server, for tests by subject."""

import time
import unittest

import actionlib
import rospy
from roboframenet_msgs.msg import Command, CommandStatus, ExecuteCommandAction, Reply, StageEvent, StopReport
from std_msgs.msg import String

from roboframenet_testing import wait_until


class CommandServerCase(unittest.TestCase):
    """The node, with all other stages played here."""

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
        if command.text.startswith(("silent", "Forget all")):
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

    def times_heard(self, text):
        return sum(command.text == text for command in list(self.heard))

    def listen_anew(self):
        """Connect again to what the parser hears."""
        self.subscribers[0].unregister()
        self.subscribers[0] = rospy.Subscriber("command_text", Command, self.on_command)
        wait_until(lambda: self.subscribers[0].get_num_connections() == 1)

    def fence(self):
        """Return when everything that was said before has been handled."""
        text = f"fence {time.monotonic()}"
        self.say(text)
        self.wait_for_reply(text)

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
