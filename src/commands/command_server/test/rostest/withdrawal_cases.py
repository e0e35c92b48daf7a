"""Prohibitions, corrections and "forget that": they end what runs and say so."""

import time

import rospy
from command_server_case import CommandServerCase
from roboframenet_msgs.msg import Command, Reply, StopReport

from roboframenet_testing import wait_until


class WithdrawalCases(CommandServerCase):
    """What is taken back."""

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

    def test_stop_server_that_has_not_heard_of_the_order_ends_no_command_that_takes_it_back(self):
        self.say("silent order of the evening")
        wait_until(lambda: self.times_heard("silent order of the evening"))
        order = next(c for c in self.heard if c.text == "silent order of the evening")
        self.send_event(order, "standing_orders", is_final=True, sentence="I will wave at six.")
        self.wait_for_reply("silent order of the evening")
        self.say("Forget everything!")
        wait_until(lambda: self.times_heard("Forget all standing orders."))
        command = next(c for c in self.heard if c.text == "Forget all standing orders.")
        stop_stamp = rospy.Time.now()
        self.reports.publish(
            StopReport(command=Command(id="late", stamp=stop_stamp, text="Forget everything!"), stop_stamp=stop_stamp)
        )
        # The stages drop what was said before a stop.
        self.assertGreater(command.stamp, stop_stamp)
        self.fence()
        self.send_event(command, "executor", is_final=True, sentence="I have forgotten all 1 orders.")
        reply = self.wait_for_reply("Forget everything!")
        self.assertEqual((Reply.DONE, "executor"), (reply.outcome, reply.stage))

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
