"""The voice of the robot: every text on a topic, and aloud where the machine can."""

from typing import Callable, List, Optional

import rospy
from std_msgs.msg import String

from utter.sound_process import run_bounded, speech_command


class Voice:
    """Says texts on the topic ``said``, and aloud.

    Publishes:
        said (std_msgs/String, latched): the last text
    """

    def __init__(self, *, is_aloud: bool, timeout_s: float) -> None:
        """
        Args:
            is_aloud: whether to make sound; the topic is published always
            timeout_s: after so long a sound is cut off
        """
        self._is_aloud = is_aloud
        self._timeout_s = timeout_s
        self._said = rospy.Publisher("said", String, queue_size=10, latch=True)

    def say(self, text: str, *, is_wanted: Callable[[], bool]) -> None:
        """Say a text; return when it was said or is no longer wanted."""
        self.emit(text, speech_command(text), is_wanted=is_wanted)

    def emit(self, text: str, command: Optional[List[str]], *, is_wanted: Callable[[], bool]) -> None:
        """Publish a text, and run the program that makes its sound.

        A machine without a sound card still says its texts: a sound that fails is logged, not an error.
        """
        rospy.loginfo("says: %s", text)
        self._said.publish(String(data=text))
        if not self._is_aloud:
            return
        if command is None:
            rospy.loginfo_once("no program for sound is installed (espeak-ng, aplay): texts go to the topic only")
        elif not run_bounded(command, timeout_s=self._timeout_s, is_wanted=is_wanted) and is_wanted():
            rospy.logwarn_once("%s made no sound: is there a sound card?", command[0])
