#!/usr/bin/python3
"""Words that persons teach: obeyed with other arguments, after a restart and by a second robot; and forgotten."""

import subprocess
import unittest
from pathlib import Path
from typing import Dict, List, Tuple

import rosnode
import rospy
import rostest
from roboframenet_msgs.msg import CommandLexicalUnits, Reply
from roboframenet_msgs.srv import AddLexicalUnit

from roboframenet_rostest import say, wait_for_pipeline
from roboframenet_testing.waiting import wait_until

FRAMES = ["navigating_to_location", "perceiving", "taking", "opening", "gesturing", "turning"]
GUEST = "/turtlebot"
GOING, LOOKING = "navigating_to_location", "perceiving"
#: A phrasing that is asked about, another command with it, its frame, and the words by which it is forgotten.
BY_A_YES: Tuple[Tuple[str, str, str, str], ...] = (
    ("Make your way to the kitchen.", "Make your way to the hall.", GOING, "making my way"),
    ("Have a peek at the shelf.", "Have a peek at the bed.", LOOKING, "having a peek"),
    ("Saunter to the kitchen.", "Saunter to the hall.", GOING, "sauntering"),
    ("Mosey over to the office.", "Mosey over to the garage.", GOING, "moseying over"),
)
#: Ways to go and to look, by which more is taught: as many as there are in all.
WAYS_TO_GO = (
    "bound dash hasten hike hobble hop jog limp lumber meander plod prance race roam scamper scurry sidle slink speed "
    "sprint stagger stomp stride strut tiptoe toddle trek trot trudge voyage zip zoom"
)
WAYS_TO_LOOK = ("goggle", "have a stare", "peep", "take a peek")
#: So many are forgotten.
MOST_FORGOTTEN = 10
TURNING, SEQUENCE = "turning", "taught_"
#: What is taught in words, the words that are said then, and their frame, or how its name begins.
IN_WORDS: Tuple[Tuple[str, str, str], ...] = (
    ("When I say home time, go to the hall.", "Home time.", GOING),
    ("To freshen up means to look at the bed.", "Freshen up.", LOOKING),
    ("To make the rounds means to go to the kitchen and to go to the hall.", "Make the rounds.", SEQUENCE),
    ("When I say showtime, turn left 90 degrees.", "Showtime!", TURNING),
    ("When I say bedtime, go to the bedroom.", "Bedtime.", GOING),
    ("When I say lunch, go to the kitchen and look at the table.", "Lunch!", SEQUENCE),
    ("When I say dismissed, go to the office.", "Dismissed.", GOING),
    ("When I say about face, turn right 180 degrees.", "About face!", TURNING),
    ("When I say lights out, go to the bedroom.", "Lights out.", GOING),
    ("To stand down means to go to the hall.", "Stand down.", GOING),
    ("To warm up means to turn left 360 degrees.", "Warm up.", TURNING),
    ("Clocking off means going to the office.", "Clock off.", GOING),
    ("When I say inspection, look at the sofa.", "Inspection!", LOOKING),
    ("When I say attention, turn left 45 degrees.", "Attention!", TURNING),
    ("When I say coffee break, go to the kitchen.", "Coffee break.", GOING),
    ("When I say movie night, go to the living room and look at the sofa.", "Movie night.", SEQUENCE),
    ("To tidy up means to put the books on the table and the red mug in the sink.", "Tidy up.", SEQUENCE),
    ("When I say chop chop, go to the kitchen.", "Chop chop!", GOING),
    ("When I say siesta, go to the sofa.", "Siesta!", GOING),
    ("When I say high noon, turn right 90 degrees.", "High noon.", TURNING),
)
#: The guest has no arm.
NOT_FOR_THE_GUEST = frozenset(["Tidy up."])
#: So many of them are taught where not all are.
FEW_IN_WORDS = 3


class LearningTest(unittest.TestCase):
    """The whole graph, the home and a guest; the methods run in the order of their names."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = Path(rospy.get_param("~folder"))
        count = rospy.get_param("~count", 0)
        more = [
            (f"{way.capitalize()} to the kitchen.", f"{way.capitalize()} to the hall.", GOING, way)
            for way in WAYS_TO_GO.split()
        ]
        more += [
            (f"{way.capitalize()} at the shelf.", f"{way.capitalize()} at the bed.", LOOKING, way)
            for way in WAYS_TO_LOOK
        ]
        cls.by_a_yes = (BY_A_YES + tuple(more))[: count or None]
        cls.in_words = IN_WORDS[: FEW_IN_WORDS if count else None]
        cls.frames: Dict[str, List[str]] = {}
        cls.subscribers = [
            rospy.Subscriber(f"{robot}/command_lexical_units", CommandLexicalUnits, cls.on_units, queue_size=100)
            for robot in ("", GUEST)
        ]
        wait_for_pipeline(["navigating_to_location", "perceiving"])

    def file(self) -> str:
        return str(self.folder / "learned.sqlite")

    @classmethod
    def on_units(cls, message: CommandLexicalUnits) -> None:
        cls.frames[message.command.id] = [clause.readings[0].lexical_unit.frame_name for clause in message.clauses]

    def assert_done(self, text: str, frame: str, robot: str = "") -> None:
        """Say something, and find that it was carried out as a frame."""
        reply = say(text, robot=robot, timeout_s=120.0)
        self.assertEqual((reply.outcome, reply.code), (Reply.DONE, "DONE"), f"{text} {reply.sentence}")
        wait_until(lambda: reply.command.id in self.frames, message=lambda: text)
        (done,) = self.frames[reply.command.id]
        self.assertTrue(done == frame or (frame == SEQUENCE and done.startswith(frame)), f"{text} {done}")

    def assert_asked(self, text: str) -> None:
        """Say something that is asked about, and that does nothing."""
        reply = say(text)
        self.assertEqual((reply.outcome, reply.code), (Reply.NEEDS_INFORMATION, "CONFIRM"), f"{text} {reply.sentence}")
        self.assertNotIn(reply.command.id, self.frames)

    def assert_taught(self, text: str) -> None:
        """Teach something in words, which is asked about and does nothing."""
        self.assert_asked(text)
        kept = say("Yes.")
        self.assertEqual((kept.outcome, kept.sentence[:9]), (Reply.DONE, "All right"), f"{text} {kept.sentence}")
        self.assertNotIn(kept.command.id, self.frames)

    def test_1_a_yes_teaches_and_other_arguments_are_understood(self) -> None:
        for said, other, frame, _ in self.by_a_yes:
            with self.subTest(said):
                self.assert_asked(said)
                self.assert_done("Yes.", frame)
                self.assert_done(other, frame)

    def test_2_words_are_taught_in_words(self) -> None:
        for said, words, frame in self.in_words:
            with self.subTest(said):
                self.assertNotEqual(say(words).outcome, Reply.DONE)
                self.assert_taught(said)
                self.assert_done(words, frame)

    def test_3_kinds_and_names_of_places_are_taught_in_words(self) -> None:
        self.assert_done("Go to the office.", GOING)
        self.assert_taught("This room is the den.")
        self.assert_taught("A frobnicator is a sofa.")
        self.assert_done("Go to the hall.", GOING)
        self.assert_done("Go to the den.", GOING)
        self.assert_done("Look at the frobnicator.", LOOKING)

    def test_3_a_no_is_kept_too(self) -> None:
        self.assert_asked("Shuffle over to the kitchen.")
        self.assertEqual(say("No.").code, "DECLINED")
        again = say("Shuffle over to the kitchen.")
        self.assertNotEqual(again.outcome, Reply.DONE)
        self.assertNotIn("walk over", again.sentence)

    def test_4_it_is_known_after_a_restart(self) -> None:
        nodes = rosnode.get_node_names()
        killed = "/semantic_framer" if "/semantic_framer" in nodes else "/stages"
        uri = rosnode.get_api_uri(rospy.get_master(), killed)
        rosnode.kill_nodes([killed])
        wait_until(lambda: rosnode.get_api_uri(rospy.get_master(), killed, skip_cache=True) not in (None, uri), 120.0)
        wait_for_pipeline(["navigating_to_location", "perceiving"])
        for _, other, frame, _ in self.by_a_yes:
            with self.subTest(other):
                self.assert_done(other, frame)
        for _, words, frame in self.in_words:
            with self.subTest(words):
                self.assert_done(words, frame)
        self.assert_done("Go to the den.", GOING)

    def test_5_a_second_robot_knows_it_when_it_imports_it(self) -> None:
        _, other, frame, _ = self.by_a_yes[0]
        _, words, of_words = self.in_words[0]
        self.assertNotEqual(say(words, robot=GUEST).outcome, Reply.DONE)
        exported = self.folder / "exported.yaml"
        command = ["rfn", "export-learned", "--file", self.file(), "--out", str(exported)]
        subprocess.run(command, check=True, timeout=60)
        rospy.wait_for_service(f"{GUEST}/add_lexical_unit", 60.0)
        added = rospy.ServiceProxy(f"{GUEST}/add_lexical_unit", AddLexicalUnit)(absolute_file_path=str(exported))
        self.assertTrue(added.success)
        self.assert_done(other, frame, robot=GUEST)
        self.assert_done(words, of_words, robot=GUEST)

    def test_5_a_second_robot_takes_over_all_of_it(self) -> None:
        own = f"{self.file()}.{GUEST.strip('/')}"
        subprocess.run(["rfn", "import-learned", self.file(), "--file", own], check=True, timeout=60)
        for _, other, frame, _ in self.by_a_yes:
            with self.subTest(other):
                self.assert_done(other, frame, robot=GUEST)
        for _, words, frame in self.in_words:
            if words not in NOT_FOR_THE_GUEST:
                with self.subTest(words):
                    self.assert_done(words, frame, robot=GUEST)

    def test_6_it_is_forgotten_by_its_words(self) -> None:
        for said, _, _, about in self.by_a_yes[:MOST_FORGOTTEN]:
            with self.subTest(said):
                told = say(f"Forget what I taught you about {about}.")
                self.assertEqual((told.outcome, told.code), (Reply.DONE, "DONE"), told.sentence)
                self.assert_asked(said)
                say("No.")
        for _, words, _ in self.in_words:
            told = say(f'Forget what I taught you about "{words.strip(".").lower()}".')
            self.assertEqual((told.outcome, told.code), (Reply.DONE, "DONE"), told.sentence)
            self.assertNotEqual(say(words).outcome, Reply.DONE)


if __name__ == "__main__":
    rospy.init_node("learning_test")
    rostest.rosrun("roboframenet_tests", "learning", LearningTest)
