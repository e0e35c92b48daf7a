#!/usr/bin/python3
"""Spoken commands reach the pipeline after a yes; a stop needs none."""

import sys
import unittest
from pathlib import Path
from typing import List

import rospy
from hri_msgs.msg import IdsList, LiveSpeech
from roboframenet_msgs.msg import FrameCallback, FrameCatalogue, FrameServers, Lexicon, SourceFile
from std_msgs.msg import String
from std_srvs.srv import Trigger

from checked_files.source_files import FRAMES_FOLDER, LEXICAL_UNITS_FOLDER, read_text, yaml_files
from offline_pipeline.knowledge import shipped_domains
from roboframenet_testing import wait_until

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from synthetic_speech import speech, with_silence


def files(folder: str) -> List[SourceFile]:
    return [SourceFile(path=path, text=read_text(path)) for path in yaml_files([shipped_domains()], folder)]


class VoiceRecognitionNode(unittest.TestCase):
    """One robot that can move and turn, and learns to follow."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.texts: List[str] = []
        cls.question = "?"
        cls.subscribers = [
            rospy.Subscriber("text", String, lambda message: cls.texts.append(message.data)),
            rospy.Subscriber("voice_question", String, cls.on_question),
        ]
        cls.answer = rospy.Publisher("voice_answer", String, queue_size=1)
        cls.tracked = rospy.Publisher("/humans/voices/tracked", IdsList, queue_size=1, latch=True)
        cls.speech = rospy.Publisher("/humans/voices/somebody/speech", LiveSpeech, queue_size=1)
        cls.catalogue = rospy.Publisher("frame_catalogue", FrameCatalogue, queue_size=1, latch=True)
        cls.servers = rospy.Publisher("frame_servers", FrameServers, queue_size=1, latch=True)
        cls.lexicon = rospy.Publisher("lexicon", Lexicon, queue_size=1, latch=True)
        cls.tracked.publish(IdsList(ids=["somebody"]))
        cls.lexicon.publish(Lexicon(framer_id="1", files=files(LEXICAL_UNITS_FOLDER)))
        cls.catalogue.publish(FrameCatalogue(registrar_id="1", files=files(FRAMES_FOLDER)))
        cls.serve("moving", "turning")
        cls.listen = rospy.ServiceProxy("listen", Trigger)
        cls.listen.wait_for_service(60.0)
        wait_until(lambda: cls.listen().success, 60.0)
        wait_until(lambda: cls.speech.get_num_connections() == 1 and cls.answer.get_num_connections() == 1)

    @classmethod
    def on_question(cls, message: String) -> None:
        cls.question = message.data

    @classmethod
    def serve(cls, *frames: str) -> None:
        callbacks = [FrameCallback(frame_name=name, callback_topic=name, is_alive=True) for name in frames]
        cls.servers.publish(FrameServers(registrar_id="1", callbacks=callbacks))

    def say(self, text: str) -> None:
        folder = Path(rospy.get_param("~folder"))
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / "said.part"
        path.write_bytes(with_silence(speech(text), before_s=0.3, after_s=0.3))
        path.rename(folder / "said.raw")

    def wait_for_question(self, question: str) -> None:
        wait_until(lambda: self.question == question, 20.0, lambda: f"asked: {self.question!r}")

    def test_1_a_motion_is_asked_about_and_confirmed_by_voice(self) -> None:
        self.say("move forward three feet")
        self.wait_for_question("Shall I move forward 3 feet?")
        self.assertEqual(self.texts, [])
        self.say("yes please")
        wait_until(lambda: self.texts == ["move forward 3 feet"], 20.0, lambda: str(self.texts))
        self.wait_for_question("")

    def test_2_a_stop_is_heard_without_a_push(self) -> None:
        self.texts.clear()
        self.say("stop")
        wait_until(lambda: self.texts == ["Stop."], 20.0, lambda: str(self.texts))

    def test_3_another_recogniser_is_heard_and_the_page_says_no(self) -> None:
        self.texts.clear()
        self.assertTrue(self.listen().success)
        self.speech.publish(LiveSpeech(final="Turn left 90 degrees."))
        self.wait_for_question("Shall I turn left 90 degrees?")
        self.answer.publish(String(data="No."))
        self.wait_for_question("")
        self.assertEqual(self.texts, [])

    def test_4_a_new_ability_can_be_said(self) -> None:
        self.serve("moving", "turning", "following")

        def is_offered() -> bool:
            self.listen()
            self.speech.publish(LiveSpeech(final="follow me"))
            return self.question == "Shall I follow you?"

        wait_until(is_offered, 30.0, lambda: f"asked: {self.question!r}")
        self.answer.publish(String(data="yes"))
        wait_until(lambda: self.texts == ["follow me"], 20.0, lambda: str(self.texts))


if __name__ == "__main__":
    import rostest

    rospy.init_node("test_voice_recognition_node")
    rostest.rosrun("voice_recognition", "voice_recognition_node", VoiceRecognitionNode, sys.argv)
