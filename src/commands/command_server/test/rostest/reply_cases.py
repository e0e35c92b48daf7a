"""One reply to each text, whatever the stages do."""

import collections
import os
import signal
import xmlrpc.client

import rosgraph
import rospy
from command_server_case import CommandServerCase
from roboframenet_msgs.msg import Reply

from roboframenet_testing import wait_until


class ReplyCases(CommandServerCase):
    """One reply."""

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

    def test_command_of_which_no_stage_has_told_is_sent_to_who_connects_later(self):
        known = self.run_in_executor("hang in the executor, known")
        self.say("silent to who listens first")
        wait_until(lambda: self.times_heard("silent to who listens first") == 1)
        # As a parser that starts beside a recording does.
        self.listen_anew()
        wait_until(lambda: self.times_heard("silent to who listens first") == 2)
        self.assertEqual(1, self.times_heard(known.text))
        self.send_event(known, "executor", is_final=True)
        self.assertEqual("STAGE_SILENT", self.wait_for_reply("silent to who listens first").code)
        self.assertEqual(1, len(self.replies_to(known.text)))

    def test_texts_that_are_no_commands_are_refused(self):
        self.say("   ")
        self.assertEqual("EMPTY_TEXT", self.wait_for_reply("   ").code)
        self.say("x" * 101)
        reply = self.wait_for_reply("x" * 100)
        self.assertEqual((Reply.REFUSED, "TEXT_TOO_LONG"), (reply.outcome, reply.code))

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
