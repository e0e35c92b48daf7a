#!/usr/bin/python3
"""A stage of 2012 in the middle of the pipeline: ``outside_test.py STAGE``. It knows what 2012 had, and no more."""

import sys
import unittest
from typing import Any, Callable, List

import rospy
import rostest
from roboframenet_msgs.msg import (
    FilledLexicalUnit,
    FilledLexicalUnitList,
    FilledSemanticFrame,
    FilledSemanticFrameList,
    FilledSemanticFrameListList,
    Procedure,
    Reply,
)
from stanford_parser_msgs.msg import Parse
from std_msgs.msg import String

from rfnserver import RFNServer
from roboframenet_rostest import say, wait_for_pipeline
from roboframenet_testing import wait_until


def stage(asked: str, asked_type: Any, answers: str, answers_type: Any, work: Callable[[Any], Any]) -> rospy.Subscriber:
    """Start a stage as 2012 had it: a subscriber, a publisher, and what is done between."""
    publisher = rospy.Publisher(f"outside/{answers}", answers_type, queue_size=10)
    subscriber = rospy.Subscriber(f"outside/{asked}", asked_type, lambda message: publisher.publish(work(message)))
    wait_until(lambda: publisher.get_num_connections() > 0 and subscriber.get_num_connections() > 0, 120.0)
    return subscriber


class Outside(unittest.TestCase):
    """Servers that keep what they do, and our pipeline around the stage."""

    done: List[str]
    servers: List[RFNServer]

    @classmethod
    def setUpClass(cls) -> None:
        cls.done, cls.servers = [], []
        for name in ("first", "second"):
            server = RFNServer(name, lambda _frame, name=name: cls.done.append(name))
            server.register_with_frame("pinging")
            server.start()
            cls.servers.append(server)
        wait_for_pipeline(["pinging"])

    def setUp(self) -> None:
        self.done.clear()

    def say(self, text: str) -> Reply:
        return say(text)


class Framer(Outside):
    def test_1_no_framer(self) -> None:
        reply = self.say("Poke.")
        self.assertEqual((Reply.FAILED, "STAGE_SILENT"), (reply.outcome, reply.code))
        self.assertIn("Nobody listens to /outside/parse", reply.sentence)

    def test_2_three_lines(self) -> None:
        def frame(parse: Parse) -> FilledLexicalUnitList:
            known = {"Poke": "pinging", "Fly": "flying_to_the_moon"}
            frames = [known[word] for word in parse.words if word in known]
            return FilledLexicalUnitList([FilledLexicalUnit(frame_name=name) for name in frames])

        self.framer = stage("parse", Parse, "filled_lexical_units", FilledLexicalUnitList, frame)
        reply = self.say("Poke.")
        self.assertEqual((Reply.DONE, 1), (reply.outcome, len(self.done)), reply.sentence)
        reply = self.say("Ping.")
        self.assertEqual((Reply.REFUSED, "NO_READING"), (reply.outcome, reply.code), reply.sentence)
        # What no file describes is refused by our registrar, as for a sentence.
        reply = self.say("Fly.")
        self.assertNotEqual(Reply.DONE, reply.outcome, reply.sentence)
        # A stop passes no framer.
        self.assertEqual(Reply.DONE, self.say("Stop.").outcome)
        self.assertEqual(1, len(self.done))

    def test_3_answers_that_nobody_asked_for_do_nothing(self) -> None:
        publisher = rospy.Publisher("outside/filled_lexical_units", FilledLexicalUnitList, queue_size=10)
        wait_until(lambda: publisher.get_num_connections() > 0)
        publisher.publish(FilledLexicalUnitList([FilledLexicalUnit("pinging", "poke", [])]))
        # The next command goes the same way, so what came before has been read.
        self.say("Poke.")
        self.assertEqual(1, len(self.done))


class Language(Outside):
    def test_text_is_read_outside(self) -> None:
        def read(text: String) -> FilledLexicalUnitList:
            return FilledLexicalUnitList([FilledLexicalUnit("pinging", text.data, [])])

        self.reader = stage("text", String, "filled_lexical_units", FilledLexicalUnitList, read)
        reply = self.say("Hallo, bist du da?")
        self.assertEqual((Reply.DONE, 1), (reply.outcome, len(self.done)), reply.sentence)


class Registrar(Outside):
    def test_frames_come_from_outside(self) -> None:
        def find(units: FilledLexicalUnitList) -> FilledSemanticFrameListList:
            unit = units.lexical_units[0]
            servers = ["/second"] if unit.frame_name == "pinging" else ["/stop_server"]
            frame = FilledSemanticFrame(unit.frame_name, unit.frame_elements, servers)
            return FilledSemanticFrameListList([FilledSemanticFrameList([frame])])

        self.registrar = stage(
            "filled_lexical_units", FilledLexicalUnitList, "filled_semantic_frames", FilledSemanticFrameListList, find
        )
        reply = self.say("Ping.")
        self.assertEqual((Reply.DONE, ["second"]), (reply.outcome, self.done), reply.sentence)
        reply = self.say("Turn left.")
        self.assertEqual((Reply.FAILED, "STAGE_ERROR"), (reply.outcome, reply.code), reply.sentence)
        self.assertIn("/stop_server is not registered for turning", reply.sentence)
        reply = self.say("Ping twice.")
        self.assertEqual((Reply.REFUSED, "NOT_IN_2012"), (reply.outcome, reply.code), reply.sentence)


class Arbitrator(Outside):
    def test_an_arbitrator_prefers_the_second(self) -> None:
        def order(frames: FilledSemanticFrameListList) -> Procedure:
            # The servers of a sequence, the last name first.
            ordered = sorted(frames.frame_lists, key=lambda one: [f.action_server_topics for f in one.frames])
            return Procedure(ordered[::-1])

        self.arbitrator = stage("filled_semantic_frames", FilledSemanticFrameListList, "procedure", Procedure, order)
        for _ in range(5):
            self.assertEqual(Reply.DONE, self.say("Ping.").outcome)
        self.assertEqual(["second"] * 5, self.done)
        reply = self.say("Ping and then ping.")
        self.assertEqual((Reply.DONE, ["second"] * 7), (reply.outcome, self.done), reply.sentence)
        reply = self.say("Ping twice.")
        self.assertEqual((Reply.REFUSED, "NOT_IN_2012"), (reply.outcome, reply.code), reply.sentence)


if __name__ == "__main__":
    rospy.init_node("outside_test")
    case = {one.__name__.lower(): one for one in (Framer, Language, Registrar, Arbitrator)}[sys.argv[1]]
    rostest.rosrun("roboframenet_tests", f"outside_{sys.argv[1]}", case, sys.argv)
