#!/usr/bin/python3
"""What no grammar holds is heard by Whisper, and what the robot knows chooses among what may have been said."""

import sys
import unittest
from pathlib import Path
from typing import List

import rospy
from roboframenet_msgs.msg import (
    FrameCallback,
    FrameCatalogue,
    FrameServers,
    KnownName,
    KnownNames,
    Lexicon,
    SourceFile,
)
from std_msgs.msg import String
from std_srvs.srv import Trigger

from checked_files.source_files import FRAMES_FOLDER, LEXICAL_UNITS_FOLDER, read_text, yaml_files
from offline_pipeline.knowledge import shipped_domains
from roboframenet_testing import wait_until
from voice_recognition.engines import Engine, chosen

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from synthetic_speech import speech, with_silence

ENGINE, REASON = chosen(Engine.AUTO)


def files(folder: str) -> List[SourceFile]:
    return [SourceFile(path=path, text=read_text(path)) for path in yaml_files([shipped_domains()], folder)]


@unittest.skipUnless(ENGINE is Engine.WHISPER, REASON)
class WhisperNode(unittest.TestCase):
    """One robot that can move, turn and follow, and knows Bob."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.texts: List[str] = []
        cls.heard: List[str] = []
        cls.question = "?"
        cls.subscribers = [
            rospy.Subscriber("text", String, lambda message: cls.texts.append(message.data)),
            rospy.Subscriber("voice_heard", String, lambda message: cls.heard.append(message.data)),
            rospy.Subscriber("voice_question", String, cls.on_question),
        ]
        cls.publishers = [
            rospy.Publisher("frame_catalogue", FrameCatalogue, queue_size=1, latch=True),
            rospy.Publisher("lexicon", Lexicon, queue_size=1, latch=True),
            rospy.Publisher("known_names", KnownNames, queue_size=1, latch=True),
            rospy.Publisher("frame_servers", FrameServers, queue_size=1, latch=True),
        ]
        callbacks = [
            FrameCallback(frame_name=name, callback_topic=name, is_alive=True)
            for name in ("moving", "turning", "following")
        ]
        for publisher, message in zip(
            cls.publishers,
            (
                FrameCatalogue(registrar_id="1", files=files(FRAMES_FOLDER)),
                Lexicon(framer_id="1", files=files(LEXICAL_UNITS_FOLDER)),
                KnownNames(names=[KnownName(name="Bob", semantic_types=["Human"])]),
                FrameServers(registrar_id="1", callbacks=callbacks),
            ),
        ):
            publisher.publish(message)
        cls.listen = rospy.ServiceProxy("listen", Trigger)
        cls.listen.wait_for_service(60.0)
        wait_until(lambda: cls.listen().success, 90.0)

    @classmethod
    def on_question(cls, message: String) -> None:
        cls.question = message.data

    def say(self, text: str) -> None:
        folder = Path(rospy.get_param("~folder"))
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / "said.part"
        path.write_bytes(with_silence(speech(text, ("flite", "rms")), before_s=0.3, after_s=0.3))
        path.rename(folder / "said.raw")

    def told(self) -> str:
        return f"asked: {self.question!r}, heard: {self.heard}, told: {self.texts}"

    def asked(self, said: str, question: str) -> None:
        self.assertTrue(self.listen().success)
        self.say(said)
        wait_until(lambda: self.question == question, 30.0, self.told)
        self.assertEqual(self.texts, [])

    def answered(self, said: str, texts: List[str]) -> None:
        self.say(said)
        wait_until(lambda: self.question == "", 30.0, self.told)
        self.assertEqual(self.texts, texts)
        self.texts.clear()

    def test_1_what_no_example_says_is_asked_about_and_confirmed(self) -> None:
        self.asked("go forward two metres", "Shall I go forward 2 metres?")
        self.answered("yes please", ["Go forward 2 metres"])

    def test_2_a_known_person_is_followed_after_a_yes_only(self) -> None:
        self.asked("follow Bob", "Shall I follow Bob?")
        self.answered("no", [])

    def test_3_a_stop_is_heard_without_a_push(self) -> None:
        self.say("stop")
        wait_until(lambda: self.texts == ["Stop."], 30.0, self.told)


if __name__ == "__main__":
    import rostest

    rospy.init_node("test_whisper_node")
    rostest.rosrun("voice_recognition", "voice_recognition_whisper", WhisperNode, sys.argv)
