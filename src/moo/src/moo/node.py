"""An RFNServer that moos: the frame *mooing*."""

import os
import tempfile

import rospy
from roboframenet_msgs.msg import FilledSemanticFrame

from moo.sound import moo, write_wave
from rfnserver import RFNServer
from utter.ros_voice import Voice
from utter.sound_process import wave_command


class MooServer:
    """Moos on request.

    Actions:
        mooing (roboframenet_msgs/FilledSemanticFrameAction)
    Publishes:
        said (std_msgs/String)
    Parameters:
        ~aloud (bool, default true): play the sound with aplay, if it is installed
        ~timeout_s (float, default 5, seconds): when the sound is cut off
    """

    def __init__(self, parameters: str = "~") -> None:
        """
        Args:
            parameters: prefix of the names of the parameters
        """
        # The file is deleted with the process that made it.
        self._folder = tempfile.TemporaryDirectory(prefix="moo_")
        self._path = os.path.join(self._folder.name, "moo.wav")
        write_wave(moo(), self._path)
        self._voice = Voice(
            is_aloud=rospy.get_param(parameters + "aloud", True),
            timeout_s=float(rospy.get_param(parameters + "timeout_s", 5.0)),
        )
        self._server = RFNServer("mooing", self._on_frame)
        self._server.register_with_frame("mooing")
        self._server.start()

    def _on_frame(self, _frame: FilledSemanticFrame) -> None:
        self._voice.emit(
            "Moo!",
            wave_command(self._path),
            is_wanted=lambda: not (self._server.is_preempt_requested() or rospy.is_shutdown()),
        )
        if self._server.is_preempt_requested():
            self._server.set_preempted(None, "I was interrupted.")


def main() -> None:
    """Run the node."""
    rospy.init_node("moo")
    MooServer()
    rospy.spin()
