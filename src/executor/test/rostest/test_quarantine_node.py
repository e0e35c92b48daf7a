#!/usr/bin/python3
"""Servers that hang cost their deadlines once; they are used again when they have ended what they owed."""

import os
import signal
import sys

import rostest
from roboframenet_msgs.msg import Reply

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from executor_case import ExecutorCase, frame

from roboframenet_testing import wait_until
from roboframenet_testing.ros_processes import process_of


class QuarantineTest(ExecutorCase):
    """One executor with a long quarantine."""

    def test_server_that_hangs_is_asked_once_until_it_was_started_again(self):
        self.assert_reply(
            self.send([[frame("freeze", "freezing")], [frame("succeed", "two")]]), Reply.DONE, "DONE", "was silent"
        )
        self.assert_reply(
            self.send([[frame("succeed", "freezing")]]),
            Reply.FAILED,
            "ALL_CANDIDATES_FAILED",
            "the program for it is out of use until it ends its last goal: it was silent",
        )
        self.assertNotIn("freezing begins succeed", self.log)
        os.kill(process_of("/frozen"), signal.SIGKILL)
        wait_until(lambda: self.is_used_again("freezing"), message="freezing is still out of use")

    def test_server_that_ends_late_is_used_again(self):
        old = self.send([[frame("ignore_cancel", "one", "6")]])
        self.wait_for_log("one begins ignore_cancel")
        new = self.send([[frame("succeed", "one")], [frame("succeed", "two")]])
        self.assert_reply(old, Reply.SUPERSEDED, "NEW_COMMAND", "one did not end on cancel")
        self.assert_reply(new, Reply.DONE, "DONE", "the program for it is out of use until it ends its last goal")
        self.wait_for_log("one ends ignore_cancel")
        wait_until(lambda: self.is_used_again("one"), message="one is still out of use")

    def test_server_that_dies_and_is_back_at_once_owes_nothing(self):
        self.assert_reply(
            self.send([[frame("start_again", "four")], [frame("succeed", "two")]]), Reply.DONE, "DONE", "has died"
        )
        wait_until(lambda: self.is_used_again("four"), message="four is still out of use")

    def is_used_again(self, server):
        return self.wait_for_reply(self.send([[frame("succeed", server)]])).code == "DONE"


if __name__ == "__main__":
    rostest.rosrun("executor", "quarantine", QuarantineTest)
