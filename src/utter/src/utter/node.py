"""RFNServers that speak: the frames *saying* and *telling*."""

import datetime
from dataclasses import dataclass
from typing import Callable

import rospy
from roboframenet_msgs.msg import FilledSemanticFrame

from rfnserver import RFNServer
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import read_parameters, run_node
from utter.ros_voice import Voice
from utter.speech import NothingToSay, spoken_text, told_fact


def elements(frame: FilledSemanticFrame) -> dict:
    """Return the arguments of a frame by the names of its elements."""
    return {element.name: element.argument for element in frame.frame_elements}


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        aloud: make sound with espeak-ng, if it is installed
        timeout_s: when a sound is cut off

    Raises:
        ParameterError: a value of another type
    """

    aloud: bool = parameter(True)
    timeout_s: float = parameter(30.0)


class UtterServer:
    """Says the text that a frame asks for.

    Actions:
        saying, telling (roboframenet_msgs/FilledSemanticFrameAction)
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
        self._servers = [
            self._serve(
                "saying",
                lambda frame: spoken_text(elements(frame).get("message", ""), elements(frame).get("addressee", "")),
            ),
            self._serve(
                "telling",
                lambda frame: told_fact(
                    elements(frame).get("message", ""), datetime.datetime.now(), elements(frame).get("addressee", "")
                ),
            ),
        ]

    def _serve(self, name: str, sentence_of: Callable[[FilledSemanticFrame], str]) -> RFNServer:
        def callback(frame: FilledSemanticFrame) -> None:
            try:
                sentence = sentence_of(frame)
            except NothingToSay as reason:
                server.set_aborted(None, str(reason))
                return
            self._voice.say(sentence, is_wanted=lambda: not (server.is_preempt_requested() or rospy.is_shutdown()))
            if server.is_preempt_requested():
                server.set_preempted(None, "I was interrupted.")

        # It heeds all elements of its frames, and no manner: it speaks as it speaks.
        server = RFNServer(name, callback, occupies=["voice"])
        server.register_with_frame(name)
        server.start()
        return server


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("utter", UtterServer)
