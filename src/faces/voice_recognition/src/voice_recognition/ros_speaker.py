"""The node's own voice: says one sentence after the other in a thread."""

import queue
import threading
from typing import Callable

import rospy

from utter.ros_voice import Voice

#: Sentences that may wait.
MOST_WAITING = 5


class Speaker:
    """Says sentences, and tells when it begins and ends."""

    def __init__(self, voice: Voice, on_speaking: Callable[[bool], None]) -> None:
        """
        Args:
            voice: makes the sound
            on_speaking: called with True before a sentence, and with False after it
        """
        self._voice = voice
        self._on_speaking = on_speaking
        self._waiting: queue.Queue[str] = queue.Queue(MOST_WAITING)
        self._silenced = threading.Event()
        threading.Thread(target=self._run, daemon=True).start()

    def say(self, sentence: str) -> None:
        """Say a sentence after those that wait; it is dropped when too many wait."""
        try:
            self._waiting.put_nowait(sentence)
        except queue.Full:
            rospy.logwarn("too much to say: %s", sentence)

    def be_silent(self) -> None:
        """Break off, and forget what waits."""
        self._silenced.set()
        while True:
            try:
                self._waiting.get_nowait()
            except queue.Empty:
                return

    def _run(self) -> None:
        while not rospy.is_shutdown():
            try:
                sentence = self._waiting.get(timeout=0.5)
            except queue.Empty:
                continue
            self._silenced.clear()
            self._on_speaking(True)
            try:
                self._voice.say(sentence, is_wanted=lambda: not (self._silenced.is_set() or rospy.is_shutdown()))
            finally:
                self._on_speaking(False)
