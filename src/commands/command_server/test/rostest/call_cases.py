"""Frames that a program has filled itself."""

import rospy
from actionlib_msgs.msg import GoalID
from command_server_case import CommandServerCase
from roboframenet_msgs.msg import Clause, Command, CommandLexicalUnits, LexicalUnitReading, Plan, PlanNode, Reply

from roboframenet_testing import wait_until


class CallCases(CommandServerCase):
    """Calls of frames: one reply each, and no way around a stop."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.sent_on = []
        cls.calls = rospy.Publisher("called_frames", CommandLexicalUnits, queue_size=10)
        cls.call_cancels = rospy.Publisher("called_frames/cancel", GoalID, queue_size=10)
        cls.units = rospy.Subscriber("command_lexical_units", CommandLexicalUnits, cls.sent_on.append)
        wait_until(
            lambda: all(end.get_num_connections() == 1 for end in (cls.calls, cls.call_cancels, cls.units)),
            message="the command server does not take calls",
        )

    def call(self, command_id, *, age_s=0.0, frames=1, plan=None):
        command = Command(
            id=command_id, stamp=rospy.Time.now() - rospy.Duration.from_sec(age_s), text=f"call {command_id}"
        )
        reading = LexicalUnitReading()
        reading.lexical_unit.frame_name = "turning"
        clauses = [Clause(readings=[reading], words="turning")] * frames
        self.calls.publish(CommandLexicalUnits(command=command, clauses=clauses, plan=plan or Plan()))
        return command

    def passed_on(self, command):
        return [units for units in list(self.sent_on) if units.command.id == command.id]

    def reply_to(self, command):
        return self.wait_for_reply(command.text)

    def test_a_call_goes_to_the_registrar_and_gets_one_reply(self):
        command = self.call("agent-one-1")
        wait_until(lambda: self.passed_on(command))
        self.assertEqual(self.passed_on(command)[0].clauses[0].readings[0].lexical_unit.frame_name, "turning")
        self.assertEqual(self.times_heard(command.text), 0)  # nobody reads it as words
        self.send_event(command, "frame_registrar")
        self.send_event(command, "executor", is_final=True)
        self.assertEqual(self.reply_to(command).outcome, Reply.DONE)
        self.send_event(command, "executor", is_final=True)
        self.fence()
        self.assertEqual(len(self.replies_to(command.text)), 1)

    def test_a_call_is_taken_once_and_not_when_it_is_old(self):
        for command_id, ages_s in (("agent-twice-1", (0.0, 0.0)), ("agent-old-1", (30.0,))):
            for age_s in ages_s:
                command = self.call(command_id, age_s=age_s)
            wait_until(lambda sent=command: [r for r in self.replies_to(sent.text) if r.code == "REPLAYED"])
            self.send_event(command, "executor", is_final=True)
        self.fence()
        self.assertEqual(len([units for units in self.sent_on if units.command.id == "agent-twice-1"]), 1)
        self.assertFalse([units for units in self.sent_on if units.command.id == "agent-old-1"])

    def test_malformed_calls_are_refused(self):
        joined = Plan(nodes=[PlanNode(kind=PlanNode.DO)])
        for command_id, options in (
            ("agent-none-1", {"frames": 0}),
            ("agent-many-1", {"frames": 21}),
            ("agent-plan-1", {"plan": joined}),
            ("text-1234-1", {}),
        ):
            command = self.call(command_id, **options)
            reply = self.reply_to(command)
            self.assertEqual((reply.outcome, reply.code), (Reply.REFUSED, "MALFORMED_CALL"), reply.sentence)
            self.assertFalse(self.passed_on(command))

    def test_a_call_that_is_cancelled_before_it_is_planned_ends(self):
        command = self.call("agent-cancelled-1")
        wait_until(lambda: self.passed_on(command))
        self.call_cancels.publish(GoalID(id=command.id))
        self.assertEqual(self.reply_to(command).outcome, Reply.SUPERSEDED)
        wait_until(lambda: [c for c in self.cancelled if c.id == command.id], message="the executor is not told")

    def test_a_stop_ends_a_call(self):
        command = self.call("agent-stopped-1")
        wait_until(lambda: self.passed_on(command))
        self.report_stop("stop-calls", "Stop.")
        reply = self.reply_to(command)
        self.assertEqual((reply.outcome, reply.code), (Reply.SUPERSEDED, "STOPPED"))
