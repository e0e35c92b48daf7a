"""RFNServers that speak: the frames *saying* and *telling*; and the voice of answers to questions."""

import contextlib
import datetime
import queue
import threading
from dataclasses import dataclass
from typing import Callable, Optional

import rospy
from roboframenet_msgs.msg import FilledSemanticFrameResult, Reply

from rfnserver import RFNServer, TypedFrame
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import read_parameters, run_node
from typed_arguments import Source
from utter.ros_voice import Voice
from utter.speech import NothingToSay, spoken_text, told_fact, told_statement

#: Answers that wait to be said; more are not said.
_MOST_WAITING = 5
#: The stage that answers questions.
_ANSWERING = "question_answering"


def said(frame: TypedFrame) -> str:
    """Return the sentence for a frame *saying*."""
    return spoken_text(frame["message"].text, frame["addressee"].text)


def told(frame: TypedFrame) -> str:
    """Return the sentence for a frame *telling*: a statement, or something that the robot itself knows."""
    message, addressee = frame["message"], frame["addressee"].text
    if any(part.role == "says" and part.mood == "statement" for part in message.frames):
        return told_statement(message.text, addressee, is_own=message.source is not Source.SAID)
    return told_fact(message.text, datetime.datetime.now(), addressee)


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        aloud: make sound with Piper or espeak-ng, if one is installed
        timeout_s: when a sound is cut off
        serves: whether it carries the frames out; otherwise another node of the robot does
        speaks_answers: whether it says the answers to questions

    Raises:
        ParameterError: a value of another type
    """

    aloud: bool = parameter(True)
    timeout_s: float = parameter(30.0)
    serves: bool = parameter(True)
    speaks_answers: bool = parameter(True)


class UtterServer:
    """Says the text that a frame asks for.

    Actions:
        saying, telling (roboframenet_msgs/FilledSemanticFrameAction)
    Subscribes:
        reply (Reply)
    Publishes:
        said (std_msgs/String)
    Parameters: see :class:`Settings`.
    """

    def __init__(self, parameters: str = "~") -> None:
        """
        Args:
            parameters: prefix of the names of the parameters

        Raises:
            ParameterError: a parameter is wrong
        """
        settings = read_parameters(Settings, prefix=parameters)
        self._voice = Voice(is_aloud=settings.aloud, timeout_s=settings.timeout_s)
        # An answer that takes longer than the next question does not wait.
        self._answers: queue.Queue[Optional[str]] = queue.Queue(_MOST_WAITING)
        if settings.speaks_answers:
            self._thread = threading.Thread(target=self._speak, name="speak answers", daemon=True)
            self._thread.start()
            self._subscriber = rospy.Subscriber("reply", Reply, self._on_reply, queue_size=10)
            rospy.on_shutdown(lambda: self._put(None))
        if not settings.serves:
            return
        self._servers = [
            self._serve("saying", said),
            self._serve("telling", told, is_answer=True),
        ]

    def _on_reply(self, reply: Reply) -> None:
        if reply.outcome == Reply.DONE and reply.stage == _ANSWERING:
            self._put(reply.sentence)

    def _put(self, sentence: Optional[str]) -> None:
        with contextlib.suppress(queue.Full):
            self._answers.put_nowait(sentence)

    def _speak(self) -> None:
        while not rospy.is_shutdown():
            sentence = self._answers.get()
            if sentence is None:
                return
            try:
                self._voice.say(sentence, is_wanted=lambda: not rospy.is_shutdown())
            except Exception as error:  # boundary: the next answer is spoken, whatever fails
                rospy.logerr("an answer was not said: %s: %s", type(error).__name__, error)

    def _serve(self, name: str, sentence_of: Callable[[TypedFrame], str], *, is_answer: bool = False) -> RFNServer:
        def callback(frame: TypedFrame) -> None:
            try:
                sentence = sentence_of(frame)
            except NothingToSay as reason:
                server.set_aborted(None, str(reason))
                return
            self._voice.say(sentence, is_wanted=lambda: not (server.is_preempt_requested() or rospy.is_shutdown()))
            if server.is_preempt_requested():
                server.set_preempted(None)
            elif is_answer:
                # The reply to the command has it too.
                server.set_succeeded(FilledSemanticFrameResult(success=True), sentence)

        # It heeds all elements of its frames, and no manner: it speaks as it speaks.
        server = RFNServer(name, callback, occupies=["voice"])
        server.register_with_frame(name)
        server.start()
        return server


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("utter", UtterServer)
