#!/usr/bin/python3
"""Questions in the whole pipeline: the reply is the answer, and a question stops nothing that runs."""

import threading
import unittest
from typing import List

import rospy
from roboframenet_msgs.msg import FilledSemanticFrame, FilledSemanticFrameResult, Reply
from std_msgs.msg import String

from rfnserver import RFNServer
from roboframenet_rostest import say, wait_for_pipeline
from roboframenet_testing import wait_until


class QuestionAnsweringTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.is_dancing, cls.may_end = threading.Event(), threading.Event()
        cls.server = RFNServer("dancing", cls.dance)
        cls.server.register_with_frame("dancing")
        cls.server.start()
        wait_for_pipeline(["pinging", "dancing", "question_of_abilities", "question_of_place"])

    @classmethod
    def dance(cls, _: FilledSemanticFrame) -> None:
        cls.is_dancing.set()
        cls.may_end.wait(60.0)
        if cls.server.is_preempt_requested():
            cls.server.set_preempted(FilledSemanticFrameResult(success=False))

    def assert_says(self, text: str, *parts: str) -> None:
        reply = say(text)
        self.assertEqual((reply.outcome, reply.code), (Reply.DONE, "DONE"), reply.sentence)
        for part in parts:
            self.assertIn(part, reply.sentence)

    def test_1_abilities_are_those_of_the_servers_that_run(self) -> None:
        wait_until(lambda: "Dance" in say("What can you do?").sentence or "Ping" in say("What can you do?").sentence)
        self.assertNotIn("Turn", say("What can you do?").sentence)

    def test_2_what_is_known_is_answered_and_what_is_not_is_said(self) -> None:
        wait_until(lambda: "table" in say("Where is the mug?").sentence)
        self.assert_says("Where is the mug?", "on the table in the kitchen")
        # Nobody speaks as fast; the answer comes over another way than what was said before.
        for _ in range(10):
            self.assert_says("Where is the spoon?", "I know of no spoon.")
            self.assert_says("What did I say?", "Where is the spoon?")
            self.assert_says("What did you say?", "Where is the spoon?")

    def test_2_an_answer_is_spoken(self) -> None:
        said: List[str] = []
        subscriber = rospy.Subscriber("said", String, lambda message: said.append(message.data), queue_size=10)
        wait_until(lambda: subscriber.get_num_connections() > 0)
        self.assert_says("Where is the mug?", "on the table in the kitchen")
        wait_until(lambda: any("on the table in the kitchen" in text for text in said), message=lambda: said)

    def test_2_a_statement_is_told(self) -> None:
        self.assert_says("Tell Anna that dinner is ready.", "Anna, I was asked to tell you: dinner is ready.")
        self.assert_says("Tell me when you are done.", "I am done.")
        self.assert_says("Tell me the date.", "It is ")

    def test_2_whoever_says_who_they_are_is_known(self) -> None:
        self.assert_says("Who am I?", "I do not know who you are.")
        self.assert_says("I am Anna.", "Hello, Anna.")
        wait_until(lambda: "You are Anna." in say("Who am I?").sentence)

    def test_3_other_questions_are_refused_as_questions(self) -> None:
        self.assertEqual(say("Should I turn left?").code, "QUESTION")

    def test_3_deeds_are_remembered_for_questions_and_conditions(self) -> None:
        self.assert_says("Did you say hello?", "No, as far as I remember.")
        self.assert_says("If you have not said hello, say goodbye.", "Done.")
        self.assert_says("If you have said hello, say goodbye.", "hello")
        self.assert_says("Say hello.", "Done.")
        wait_until(lambda: say("Did you say hello?").sentence.startswith('Yes: I carried out "Say hello." today at '))
        self.assert_says("Tell me how often you said hello.", "Once.")
        self.assert_says("What did you say to Anna?", "as far as I remember")
        self.assert_says("Why did you say hello?", 'Because you asked me to: "Say hello."')
        self.assert_says("Are you able to dance?", "Yes, I can dance.")
        self.assert_says("Are you able to close doors?", "nothing that runs here can do that")

    def test_4_question_preempts_nothing(self) -> None:
        replies: List[Reply] = []
        dancing = threading.Thread(target=lambda: replies.append(say("Dance.")))
        dancing.start()
        self.assertTrue(self.is_dancing.wait(60.0))
        wait_until(lambda: "Dance." in say("What are you doing?").sentence)
        self.assert_says("Are you dancing?", 'Yes, I am carrying out "Dance."')
        self.assert_says("Are you saying hello?", 'No, I am carrying out "Dance."')
        self.assertFalse(replies)
        self.may_end.set()
        dancing.join(60.0)
        self.assertEqual(replies[0].outcome, Reply.DONE, replies[0].sentence)


if __name__ == "__main__":
    import rostest

    rospy.init_node("questions_test")
    rostest.rosrun("roboframenet_tests", "questions_test", QuestionAnsweringTest)
