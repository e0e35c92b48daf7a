"""RFNServers that speak: the frames *saying* and *telling*."""

import datetime
from typing import Callable

import rospy
from roboframenet_msgs.msg import FilledSemanticFrame

from rfnserver import RFNServer
from utter.ros_voice import Voice
from utter.speech import NothingToSay, spoken_text, told_fact


def elements(frame: FilledSemanticFrame) -> dict:
    """Return the arguments of a frame by the names of its elements."""
    return {element.name: element.argument for element in frame.frame_elements}


class UtterServer:
    """Says the text that a frame asks for.

    Actions:
        saying, telling (roboframenet_msgs/FilledSemanticFrameAction)
    Publishes:
        said (std_msgs/String)
    Parameters:
        ~aloud (bool, default true): make sound with espeak-ng, if it is installed
        ~timeout_s (float, default 30, seconds): when a sound is cut off
    """

    def __init__(self, parameters: str = "~") -> None:
        """
        Args:
            parameters: prefix of the names of the parameters
        """
        self._voice = Voice(
            is_aloud=rospy.get_param(parameters + "aloud", True),
            timeout_s=float(rospy.get_param(parameters + "timeout_s", 30.0)),
        )
        self._servers = [
            self._serve(
                "saying",
                lambda frame: spoken_text(elements(frame).get("message", ""), elements(frame).get("addressee", "")),
            ),
            self._serve(
                "telling", lambda frame: told_fact(elements(frame).get("message", ""), datetime.datetime.now())
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

        server = RFNServer(name, callback)
        server.register_with_frame(name)
        server.start()
        return server


def main() -> None:
    """Run the node."""
    rospy.init_node("utter")
    UtterServer()
    rospy.spin()
