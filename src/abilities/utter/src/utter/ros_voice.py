"""The voice of the robot: publishes every text, and says it aloud if the machine can."""

import threading
from pathlib import Path
from typing import Callable, List, Optional

import rospy
from std_msgs.msg import Bool, String

from utter.piper import NoPiper, Piper, installed_voice, piper_command
from utter.sound_process import run_bounded, speech_command, wave_command


class Voice:
    """Says texts on the topic ``said`` and aloud.

    Publishes:
        said (std_msgs/String, latched): the last text
        speaking (std_msgs/Bool): True when a sound begins, False when it has ended
    """

    def __init__(self, *, is_aloud: bool, timeout_s: float) -> None:
        """
        Args:
            is_aloud: whether to make sound; the text is always published
            timeout_s: seconds after which a sound is cut off
        """
        self._is_aloud = is_aloud
        self._lock = threading.Lock()
        self._has_looked = False
        self._piper: Optional[Piper] = None
        self._timeout_s = timeout_s
        self._said = rospy.Publisher("said", String, queue_size=10, latch=True)
        self._speaking = rospy.Publisher("speaking", Bool, queue_size=10)

    def say(self, text: str, *, is_wanted: Callable[[], bool]) -> None:
        """Say a text; return when it is said or no longer wanted."""
        wave = self._wave_of(text) if self._is_aloud else ""
        if not wave:
            self.emit(text, speech_command(text), is_wanted=is_wanted)
            return
        try:
            self.emit(text, wave_command(wave), is_wanted=is_wanted)
        finally:
            Path(wave).unlink()

    def _wave_of(self, text: str) -> str:
        """Return the sound of a text by Piper; empty where espeak-ng speaks."""
        with self._lock:
            if not self._has_looked:
                self._has_looked = True
                self._piper = _piper()
        return self._piper.wave_of(text) if self._piper is not None else ""

    def emit(self, text: str, command: Optional[List[str]], *, is_wanted: Callable[[], bool]) -> None:
        """Publish a text, and run the program that makes its sound.

        A machine without a sound card still publishes its texts: a failed sound is logged and is not an error.
        """
        rospy.loginfo("says: %s", text)
        self._said.publish(String(data=text))
        if not self._is_aloud:
            return
        if command is None:
            rospy.loginfo_once("no program for sound is installed (espeak-ng, aplay): texts go to the topic only")
            return
        self._speaking.publish(Bool(data=True))
        try:
            has_sounded = run_bounded(command, timeout_s=self._timeout_s, is_wanted=is_wanted)
        finally:
            self._speaking.publish(Bool(data=False))
        if not has_sounded and is_wanted():
            rospy.logwarn_once("%s made no sound: is there a sound card?", command[0])


def _piper() -> Optional[Piper]:
    """Return Piper where it is installed; say what speaks."""
    try:
        command, environment = piper_command(installed_voice())
    except NoPiper as reason:
        rospy.loginfo("speaks by espeak-ng: %s", reason)
        return None
    rospy.loginfo("speaks by Piper")
    piper = Piper(command, environment)
    rospy.on_shutdown(piper.close)
    return piper
