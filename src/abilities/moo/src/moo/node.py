"""An RFNServer that moos: the frame *mooing*."""

import os
import tempfile
from dataclasses import dataclass

import rospy
from roboframenet_msgs.msg import FilledSemanticFrame

from moo.sound import moo, write_wave
from rfnserver import RFNServer
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import read_parameters, run_node
from utter.ros_voice import Voice
from utter.sound_process import wave_command


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        aloud: play the sound with aplay, if it is installed
        timeout_s: when the sound is cut off

    Raises:
        ParameterError: a value of another type
    """

    aloud: bool = parameter(True)
    timeout_s: float = parameter(5.0)


class MooServer:
    """Moos on request.

    Actions:
        mooing (roboframenet_msgs/FilledSemanticFrameAction)
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
        # The file is deleted with the process that made it.
        self._folder = tempfile.TemporaryDirectory(prefix="moo_")
        self._path = os.path.join(self._folder.name, "moo.wav")
        write_wave(moo(), self._path)
        self._voice = Voice(is_aloud=settings.aloud, timeout_s=settings.timeout_s)
        self._server = RFNServer("mooing", self._on_frame, occupies=["voice"])
        self._server.register_with_frame("mooing")
        self._server.start()

    def _on_frame(self, _frame: FilledSemanticFrame) -> None:
        self._voice.emit(
            "Moo!",
            wave_command(self._path),
            is_wanted=lambda: not (self._server.is_preempt_requested() or rospy.is_shutdown()),
        )
        if self._server.is_preempt_requested():
            self._server.set_preempted(None)


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("moo", MooServer)
