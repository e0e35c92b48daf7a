#!/usr/bin/python3
"""A stage's last word reaches whoever listens, also who connects after it was said."""

import threading
import unittest

import rospy
import rostest
from roboframenet_msgs.msg import Command, Reply, StageEvent

from roboframenet_ros.ros_stage import Stage
from roboframenet_testing import wait_until


class StageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_stage")
        cls.stage = Stage("executor")

    def setUp(self):
        self.heard = []
        self._subscriber = None

    def tearDown(self):
        if self._subscriber is not None:
            self._subscriber.unregister()

    def listen(self):
        self._subscriber = rospy.Subscriber("stage_events", StageEvent, self.heard.append)

    def ids(self):
        return {event.command.id for event in list(self.heard)}

    def test_what_it_says(self):
        self.stage.ends(Command(id="before"), outcome=Reply.DONE, code="DONE", sentence="Done.")
        self.listen()
        # Told again: the publisher has the connection. The subscriber counts it a little earlier.
        wait_until(lambda: self.mine("before"))
        command = Command(id="said", stamp=rospy.Time(7), text="Wave.")
        self.stage.passes_on(command, "At it.")
        self.stage.ends(command, outcome=Reply.REFUSED, code="NO_SERVER", sentence="Nobody can wave.")
        wait_until(lambda: self.mine("said")[-1:] and self.mine("said")[-1].is_final)
        first, last = self.mine("said")[0], self.mine("said")[-1]
        self.assertEqual(StageEvent(command=command, stage="executor", stamp=first.stamp, sentence="At it."), first)
        self.assertEqual(
            StageEvent(
                command=command,
                stage="executor",
                stamp=last.stamp,
                sentence="Nobody can wave.",
                is_final=True,
                reply=Reply(
                    command=command,
                    outcome=Reply.REFUSED,
                    stage="executor",
                    code="NO_SERVER",
                    sentence="Nobody can wave.",
                    stamp=last.stamp,
                ),
            ),
            last,
        )

    def mine(self, command_id):
        return [event for event in list(self.heard) if event.command.id == command_id]

    def test_a_listener_that_was_not_there_hears_the_end_only(self):
        self.stage.passes_on(Command(id="early"), "At it.")
        self.stage.ends(Command(id="early"), outcome=Reply.DONE, code="DONE", sentence="Done.")
        self.listen()
        wait_until(lambda: self.mine("early"))
        self.assertEqual(["Done."], [event.sentence for event in self.mine("early")])
        self.assertTrue(self.mine("early")[0].is_final)

    def test_nothing_is_lost_while_somebody_connects(self):
        said = {f"many_{number}" for number in range(300)}
        speaker = threading.Thread(
            target=lambda: [
                self.stage.ends(Command(id=name), outcome=Reply.DONE, code="DONE", sentence="Done.")
                for name in sorted(said)
            ]
        )
        speaker.start()
        self.listen()
        speaker.join(30.0)
        wait_until(lambda: said <= self.ids(), message=lambda: f"{len(said - self.ids())} of {len(said)} are missing")


if __name__ == "__main__":
    rostest.rosrun("roboframenet_ros", "stage", StageTest)
