#!/usr/bin/python3
"""The node fleet is killed while commands run, and while they are said: each has one reply, and it is true."""

import time
import unittest
from typing import List

import rospy
from roboframenet_msgs.msg import Reply

from fleet_robots import ROBOTS, Robots, kill
from roboframenet_testing import wait_until

_REPLY_S, _LATER_S = 40.0, 8.0


class FleetKillsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        rospy.init_node("fleet_kills_test")
        cls.robots = Robots()
        cls.robots.wait_until_ready()

    def replies_to(self, since: int, text: str) -> List[Reply]:
        return [reply for reply in self.robots.replies[since:] if reply.command.text == text]

    def assert_each_has_one_reply(self, since: int, texts: List[str]) -> None:
        wait_until(
            lambda: all(len(self.replies_to(since, text)) >= texts.count(text) for text in texts),
            _REPLY_S,
            f"no reply to one of {texts}",
        )
        time.sleep(_LATER_S)
        for text in set(texts):
            found = self.replies_to(since, text)
            self.assertEqual(len(found), texts.count(text), [(reply.code, reply.sentence) for reply in found])
            self.assertEqual(len({reply.command.id for reply in found}), len(found))
            for reply in found:
                rospy.loginfo("killed: %s -> %s %s", text, reply.code, reply.sentence)

    def test_1_what_runs_or_is_said_has_one_true_reply(self) -> None:
        for turn in range(int(rospy.get_param("~kills", 1))):
            self.assertTrue(self.robots.stand(ROBOTS, 20.0))
            since = len(self.robots.replies)
            running, soon_done = "Everybody, turn left 300 degrees.", "Alpha, turn left 20 degrees."
            is_long = turn % 2 == 0
            first = running if is_long else soon_done
            self.robots.say(first)
            wait_until(lambda: self.robots.seen["alpha"].speed > 0.1)
            kill("fleet")
            time.sleep(0.2)
            lost = ["Beta, turn right 20 degrees."] * (1 + turn % 3)
            for text in lost:
                self.robots.say(text)
            self.assert_each_has_one_reply(since, [first, *lost])
            (reply,) = self.replies_to(since, first)
            self.assertEqual(reply.code, "DONE", reply.sentence)
            self.assertTrue(self.robots.stand(ROBOTS, 60.0))
            wait_until(lambda: self.robots.members() == ROBOTS and self.robots.service.is_up)

    def test_2_a_dead_framer_is_told_at_once(self) -> None:
        kill("stages")
        wait_until(lambda: not self.robots.service.is_up)
        said_s = time.monotonic()
        reply = self.robots.ask("Turn left 20 degrees.", to="beta")
        rospy.loginfo("a dead framer is told after %.1f s: %s", time.monotonic() - said_s, reply.sentence)
        self.assertEqual((reply.outcome, reply.code), (Reply.FAILED, "STAGE_SILENT"), reply.sentence)
        self.assertIn("language service is not running", reply.sentence)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("roboframenet_tests", "fleet_kills_test", FleetKillsTest)
