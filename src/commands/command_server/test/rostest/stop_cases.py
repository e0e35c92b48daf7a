"""Stops, the command behind a stop, and what goes on after it."""

import rospy
from command_server_case import CommandServerCase
from roboframenet_msgs.msg import CommandPlan, Plan, PlanNode, Reply, StoppedPlan

from roboframenet_testing import wait_until


class StopCases(CommandServerCase):
    """Stops."""

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

    def test_what_the_report_of_a_stop_ends_is_cancelled_by_name(self):
        self.say("silent until the report")
        wait_until(lambda: "silent until the report" in self.active_texts())
        # The command server may hear the stop server before it hears the stop itself.
        self.report_stop("heard_first", "Halt!")
        self.assertEqual("STOPPED", self.wait_for_reply("silent until the report").code)
        wait_until(lambda: "silent until the report" in [command.text for command in self.cancelled])

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

        def is_asked():
            self.say("Go on.")
            self.fence()
            return self.replies_to("Go on.")[-1].code == "CONFIRM"

        # The report of the stop and the plan come on connections of their own. The fence is no answer.
        wait_until(is_asked)
        self.say("Carry on.")
        asked = self.wait_for_reply("Carry on.")
        self.assertEqual((Reply.NEEDS_INFORMATION, "CONFIRM"), (asked.outcome, asked.code))
        self.assertTrue(asked.sentence.endswith('Shall I go on with "wave"?'), asked.sentence)
        self.say("Yes.")
        wait_until(lambda: plans)
        self.assertEqual((plans[0].command.text, plans[0].plan.nodes[0].label), ("Yes.", "wave"))
        self.send_event(plans[0].command, "executor", is_final=True)
        self.assertEqual(self.wait_for_reply("Yes.").stage, "executor")
        self.assertFalse([c for c in self.heard if c.text == "Yes."])

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

    def test_stop_that_no_stop_server_answers_is_answered(self):
        self.say("Freeze!")
        reply = self.wait_for_reply("Freeze!")
        self.assertEqual((Reply.FAILED, "STAGE_SILENT", "stop_server"), (reply.outcome, reply.code, reply.stage))
