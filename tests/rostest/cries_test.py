#!/usr/bin/python3
"""Cries such as "Whoa!" stop a robot that drives: odometry shows that it stands, and the reply says what it stopped."""

import math
import os
import signal
import threading
import time
import unittest
from typing import List, Tuple

import rospy
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import FilledSemanticFrameActionFeedback, Reply
from std_msgs.msg import String

from command_server.beside_cries import words_not_done
from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_rostest import can_do
from roboframenet_testing import wait_until
from roboframenet_testing.ros_processes import process_of

DRIVE = "Move forward 15 metres."
CRIES = (
    "STOP!!",
    "okay stop right there",
    "stop, you will hit the lamp",
    "will you please stop moving",
    "cancel",
    "Don't move!",
    "hold on a second",
    "that's enough",
    "no no no",
    "forget it",
    "stpo",
    "you're going to hit the wall stop",
    "stop the engine",
)
PROHIBITIONS = (
    ("Don't go there!", "NEGATED"),
    ("you must not drive on", "NEGATED"),
    ("not there", "CORRECTION"),
    ("no, the office", "CORRECTION"),
    ("wrong way", "CORRECTION"),
    ("no no the other one", "CORRECTION"),
)
#: Corrections that are understood but refused by a later stage, with its code.
REFUSED_CORRECTIONS = (
    ("No, go to the garage.", "NO_SERVER"),
    ("No, move forward 3 kilometres.", "LIMIT"),
    ("wrong, bring me the mug", "NO_SERVER"),
    ("Go to the garage instead.", "NO_SERVER"),
)
#: Said while the robot drives: it drives on.
NO_CRIES = (
    "Don't stop!",
    "stop at the door",
    "why did you stop",
    "step",
    "no, keep going",
    "No, continue.",
    "no go on",
    "no keep moving forward",
)
STANDING = 0.001
SHALL_I_GO_ON = 'Shall I go on with "Move forward 15 metres" from its beginning and "turn left 10 degrees"?'


class CriesTest(unittest.TestCase):
    """One robot, and a person to follow who stands where the robot starts."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.lock = threading.Lock()
        cls.replies: List[Reply] = []
        cls.following: List[FilledSemanticFrameActionFeedback] = []
        cls.speeds: List[Tuple[float, float]] = []
        cls.heading = None
        cls.turned = 0.0
        cls.subscribers = [
            rospy.Subscriber("reply", Reply, cls.replies.append, queue_size=100),
            rospy.Subscriber(
                "following/feedback", FilledSemanticFrameActionFeedback, cls.following.append, queue_size=100
            ),
            rospy.Subscriber("odom", Odometry, cls.on_odometry, queue_size=200),
        ]
        cls.person = rospy.Publisher("person/act", String, queue_size=1)
        cls.text = rospy.Publisher("text", String, queue_size=100)
        wait_until(lambda: cls.text.get_num_connections() >= 2, message="nobody listens to 'text'")
        wait_until(is_pipeline_complete, 120.0, "the pipeline did not come up")
        assert can_do(("turning", "moving_forward", "following")), "the robot did not register"
        wait_until(lambda: bool(cls.speeds), message="no odometry")
        wait_until(lambda: cls.person.get_num_connections() > 0, message="there is no person")

    @classmethod
    def on_odometry(cls, message: Odometry) -> None:
        heading = 2.0 * math.atan2(message.pose.pose.orientation.z, message.pose.pose.orientation.w)
        with cls.lock:
            if cls.heading is not None:
                turn = heading - cls.heading
                cls.turned += math.atan2(math.sin(turn), math.cos(turn))
            cls.heading = heading
            cls.speeds.append((message.twist.twist.linear.x, message.twist.twist.angular.z))

    def setUp(self) -> None:
        self.wait_for_rest()

    def speed(self) -> float:
        return max(abs(speed) for speed in self.speeds[-1])

    def wait_for_rest(self) -> None:
        wait_until(lambda: self.speed() < STANDING, message="still moving")

    def replies_to(self, text: str, since: int) -> List[Reply]:
        return [reply for reply in self.replies[since:] if reply.command.text == text]

    def wait_for_reply(self, text: str, since: int) -> Reply:
        wait_until(lambda: bool(self.replies_to(text, since)), message=f"no reply to {text!r}")
        return self.replies_to(text, since)[0]

    def say(self, text: str) -> Reply:
        since = len(self.replies)
        self.text.publish(String(data=text))
        return self.wait_for_reply(text, since)

    def start(self, text: str) -> int:
        """Start a motion; return the number of replies before it."""
        since = len(self.replies)
        self.text.publish(String(data=text))
        wait_until(lambda: self.speed() > 0.05, message="the robot does not move")
        return since

    def fence(self) -> None:
        """Return when all earlier sentences have been answered."""
        self.assertEqual(self.say("I like the kitchen.").outcome, Reply.REFUSED)

    def test_cries_stop_the_robot(self) -> None:
        for cry in CRIES:
            since = self.start(DRIVE)
            reply = self.say(cry)
            outcome = Reply.FAILED if words_not_done(cry) else Reply.DONE
            self.assertEqual((reply.outcome, reply.stage), (outcome, "stop_server"), f"{cry!r}: {reply.sentence}")
            self.wait_for_rest()
            self.assertEqual(self.wait_for_reply(DRIVE, since).code, "STOPPED", cry)
            self.fence()
            self.assertEqual(len(self.replies_to(cry, since)), 1, cry)

    def test_prohibitions_and_corrections_stop_and_say_so(self) -> None:
        for said, code in PROHIBITIONS:
            since = self.start(DRIVE)
            reply = self.say(said)
            self.assertEqual((reply.outcome, reply.code), (Reply.REFUSED, code), f"{said!r}: {reply.sentence}")
            self.assertIn('I stopped "Move forward 15 metres".', reply.sentence)
            self.wait_for_rest()
            self.assertEqual(self.wait_for_reply(DRIVE, since).outcome, Reply.SUPERSEDED)
            self.fence()
            self.assertEqual(len(self.replies_to(said, since)), 1, said)

    def test_correction_that_cannot_be_carried_out_stops_and_says_both(self) -> None:
        alone = {said: self.say(said) for said, _ in REFUSED_CORRECTIONS}
        for said, code in REFUSED_CORRECTIONS:
            since = self.start(DRIVE)
            reply = self.say(said)
            self.assertEqual((reply.outcome, reply.code), (Reply.REFUSED, code), f"{said!r}: {reply.sentence}")
            self.assertEqual(reply.sentence, f'I stopped "Move forward 15 metres". {alone[said].sentence}')
            self.wait_for_rest()
            self.assertEqual(self.wait_for_reply(DRIVE, since).outcome, Reply.SUPERSEDED)
            self.fence()
            self.assertEqual(len(self.replies_to(said, since)), 1, said)

    def test_0_following_that_is_forbidden_ends(self) -> None:
        since = len(self.replies)
        self.text.publish(String(data="Follow me."))
        # A person who walks away before the robot has seen them is not followed.
        wait_until(lambda: any(feedback.feedback.is_succeeding for feedback in self.following))
        self.person.publish(String(data="walk"))
        wait_until(lambda: self.speed() > 0.05, message="the robot does not follow")
        reply = self.say("Don't follow me.")
        self.assertEqual(reply.sentence, 'I stopped "Follow me". You said not to.')
        self.wait_for_rest()
        self.assertEqual(self.wait_for_reply("Follow me.", since).outcome, Reply.SUPERSEDED)

    def test_prohibition_while_nothing_runs_is_refused(self) -> None:
        reply = self.say("Don't follow me.")
        self.assertEqual((reply.outcome, reply.code), (Reply.REFUSED, "NEGATED"))
        self.assertTrue(reply.sentence.startswith("I am not doing that."), reply.sentence)

    def test_whole_command_in_a_correction_replaces_what_runs(self) -> None:
        since = self.start("Turn left 6 radians.")
        reply = self.say("No, turn right half a radian.")
        self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
        self.assertEqual(self.wait_for_reply("Turn left 6 radians.", since).code, "NEW_COMMAND")

    def test_command_behind_a_stop_begins_at_standstill(self) -> None:
        since = self.start(DRIVE)
        first = len(self.speeds)
        text = "Stop and turn left 90 degrees."
        stop = self.say(text)
        self.assertEqual(stop.outcome, Reply.DONE, stop.sentence)
        reply = self.wait_for_reply("turn left 90 degrees.", since)
        self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
        self.assertGreater(reply.command.stamp, stop.command.stamp)
        self.assertNotEqual(reply.command.id, stop.command.id)
        self.wait_for_rest()
        speeds = self.speeds[first:]
        turning = next(index for index, (_, angular) in enumerate(speeds) if angular > 0.05)
        self.assertTrue(any(max(map(abs, speed)) < STANDING for speed in speeds[:turning]))
        self.assertTrue(all(abs(linear) < STANDING for linear, _ in speeds[turning:]))
        self.fence()
        self.assertEqual(len(self.replies_to(text, since)), 1)
        self.assertEqual(len(self.replies_to("turn left 90 degrees.", since)), 1)

    def test_command_behind_a_stop_turns_by_what_was_said(self) -> None:
        self.start(DRIVE)
        self.assertEqual(self.say("stop").outcome, Reply.DONE)
        self.wait_for_rest()
        start, since = self.turned, len(self.replies)
        self.text.publish(String(data="Stop. Turn left 90 degrees."))
        self.assertEqual(self.wait_for_reply("Turn left 90 degrees.", since).outcome, Reply.DONE)
        self.wait_for_rest()
        self.assertLessEqual(abs(self.turned - start - math.radians(90)), math.radians(2))

    def test_other_sentences_do_not_stop_the_robot(self) -> None:
        since = self.start(DRIVE)
        for said in NO_CRIES:
            reply = self.say(said)
            self.assertNotEqual(reply.stage, "stop_server", said)
        self.assertGreater(self.speed(), 0.05)
        self.assertFalse(self.replies_to(DRIVE, since))
        self.assertEqual(self.say("Stop.").outcome, Reply.DONE)
        self.assertEqual(self.wait_for_reply(DRIVE, since).code, "STOPPED")

    def test_stopped_plan_goes_on_after_a_yes_and_not_after_a_no(self) -> None:
        for answer in ("yes", "no"):
            self.start("Move forward 15 metres and turn left 10 degrees.")
            self.assertEqual(self.say("Stop.").outcome, Reply.DONE)
            self.wait_for_rest()
            asked = self.say("Go on.")
            self.assertEqual((asked.outcome, asked.code), (Reply.NEEDS_INFORMATION, "CONFIRM"), asked.sentence)
            self.assertTrue(asked.sentence.endswith(SHALL_I_GO_ON), asked.sentence)
            self.assertLess(self.speed(), STANDING)
            if answer == "yes":
                since = self.start(answer)
                self.assertEqual(self.say("Stop!").outcome, Reply.DONE)
                self.assertEqual(self.wait_for_reply(answer, since).code, "STOPPED")
                self.wait_for_rest()
            else:
                self.assertEqual(self.say(answer).code, "DECLINED")
                self.fence()
                self.assertLess(self.speed(), STANDING)

    def test_forget_that_takes_back_the_order_that_was_given(self) -> None:
        order = "Whenever I say banana, turn left 5 degrees."
        said = ("Forget that.", "What are you waiting for?", "Go to the garage.")
        stop_server = process_of("stop_server")
        # The stop server hears it with all others, or when one, two or three sentences have been answered.
        for count in (0, 1, 2, 3, 3):
            given = self.say(order)
            self.assertEqual((given.outcome, given.stage), (Reply.DONE, "standing_orders"), given.sentence)
            # A person needs longer to answer than the stop server to hear of the order; this test would not.
            time.sleep(1.0)
            since = len(self.replies)
            if count:
                os.kill(stop_server, signal.SIGSTOP)
            replies = []
            try:
                for position, text in enumerate(said, start=1):
                    replies.append(self.say(text))
                    if position == count:
                        os.kill(stop_server, signal.SIGCONT)
            finally:
                os.kill(stop_server, signal.SIGCONT)
            forgotten, waited_for, refused = replies
            self.assertEqual(forgotten.sentence, f'I forget "{order[:-1]}".')
            # Other tests in the same graph give orders, too.
            self.assertNotIn("banana", waited_for.sentence)
            self.assertEqual(refused.code, "NO_SERVER")
            time.sleep(0.5)
            self.assertEqual(len(self.replies_to("Forget that.", since)), 1)
        # At any other time it is a cry.
        self.assertEqual(self.say("Forget that!").stage, "stop_server")


if __name__ == "__main__":
    import rostest

    rospy.init_node("cries_test")
    rostest.rosrun("roboframenet_tests", "cries", CriesTest)
