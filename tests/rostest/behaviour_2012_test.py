#!/usr/bin/python3
"""With ``behaviour:=2012``, sentences, servers and topics behave as in the system of 2012."""

import subprocess
import unittest
from typing import Dict, List, Tuple

import rospy
from roboframenet_msgs.msg import FilledLexicalUnitList, FilledSemanticFrame, Procedure, Reply
from std_msgs.msg import String

from rfnserver import RFNServer
from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_rostest import can_do
from roboframenet_testing import wait_until

#: Server and frame. Two servers go to places; the policy draws lots for which of them is tried first.
SERVERS = (
    ("walking", "navigating_to_location"),
    ("rolling", "navigating_to_location"),
    ("turning", "turning"),
    ("moving_forward", "moving_forward"),
)
#: This many draws between two servers give both, except in one run of two thousand; the seed is fixed.
DRAWS = 12


class Behaviour2012Test(unittest.TestCase):
    """The pipeline as in 2012, and servers that only record their goals."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.replies: List[Reply] = []
        cls.done: List[Tuple[str, Dict[str, str]]] = []
        cls.units: List[FilledLexicalUnitList] = []
        cls.procedures: List[Procedure] = []
        cls.subscribers = [
            rospy.Subscriber("reply", Reply, cls.replies.append, queue_size=100),
            rospy.Subscriber("filled_lexical_units", FilledLexicalUnitList, cls.units.append, queue_size=100),
            rospy.Subscriber("procedure", Procedure, cls.procedures.append, queue_size=100),
        ]
        cls.text = rospy.Publisher("text", String, queue_size=100)
        wait_until(lambda: cls.text.get_num_connections() >= 2, message="nobody listens to 'text'")
        wait_until(is_pipeline_complete, 120.0, "the pipeline did not come up")
        cls.servers = [cls.server(name, frame_name) for name, frame_name in SERVERS]
        assert can_do({frame_name for _, frame_name in SERVERS}), "the servers did not register"

    @classmethod
    def server(cls, name: str, frame_name: str) -> RFNServer:
        def callback(frame: FilledSemanticFrame) -> None:
            cls.done.append((name, {element.name: element.argument for element in frame.frame_elements}))

        server = RFNServer(name, callback)
        server.start()
        assert server.register_with_frame(frame_name)
        return server

    def setUp(self) -> None:
        self.done.clear()
        self.units.clear()
        self.procedures.clear()

    def reply_to(self, text: str, since: int) -> Reply:
        wait_until(lambda: any(reply.command.text == text for reply in self.replies[since:]), message=text)
        return next(reply for reply in self.replies[since:] if reply.command.text == text)

    def say(self, text: str) -> Reply:
        since = len(self.replies)
        self.text.publish(String(data=text))
        return self.reply_to(text, since)

    def test_a_sentence_by_rostopic_pub(self) -> None:
        text = "Turn left 120 degrees."
        since = len(self.replies)
        subprocess.run(
            ["rostopic", "pub", "-1", rospy.resolve_name("text"), "std_msgs/String", f"data: '{text}'"],
            check=True,
            timeout=120,
            stdout=subprocess.DEVNULL,
        )
        self.assertEqual(self.reply_to(text, since).outcome, Reply.DONE)
        self.assertEqual(self.done, [("turning", {"direction": "left", "angle": "120", "angle_unit": "degrees"})])
        wait_until(lambda: bool(self.procedures and self.units))
        self.assertEqual(self.units[0].lexical_units[0].frame_name, "turning")

    def test_an_argument_is_one_word(self) -> None:
        self.assertEqual(self.say("Go to Roger's new office.").outcome, Reply.DONE)
        self.assertEqual([arguments for _, arguments in self.done], [{"goal": "office"}])

    def test_unused_words_are_ignored(self) -> None:
        reply = self.say("Turn right 2 radians with a hammer.")
        self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
        self.assertEqual(self.done, [("turning", {"direction": "right", "angle": "2", "angle_unit": "radians"})])

    def test_no_question_is_asked(self) -> None:
        reply = self.say("Move forward.")
        self.assertEqual((reply.outcome, reply.code), (Reply.REFUSED, "MISSING_ELEMENT"), reply.sentence)
        reply = self.say("three feet")
        self.assertEqual(reply.outcome, Reply.REFUSED, reply.sentence)
        self.assertEqual(self.done, [])

    def test_lots_decide_which_server_is_tried_first(self) -> None:
        for _ in range(DRAWS):
            self.assertEqual(self.say("Go to the office.").outcome, Reply.DONE)
        self.assertEqual({name for name, _ in self.done}, {"walking", "rolling"})
        self.assertEqual({len(arguments) for _, arguments in self.done}, {1})

    def test_negated_commands_are_refused(self) -> None:
        self.assertEqual(self.say("Don't turn left.").code, "NEGATED")
        self.assertEqual(self.done, [])


if __name__ == "__main__":
    import rostest

    rospy.init_node("behaviour_2012_test")
    rostest.rosrun("roboframenet_tests", "behaviour_2012", Behaviour2012Test)
