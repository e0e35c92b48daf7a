"""The sound of a ROS topic in place of a microphone: of audio_capture of audio_common, or of the page."""

import math
import queue
import time
from typing import Iterator

import rospy

from voice_recognition.microphone import NoSound, in_parts, sound_of_message
from voice_recognition.recogniser import RATE

#: Seconds without a message after which what was said has ended, and the quiet that is heard then.
SILENT_S = 1.0
QUIET = bytes(RATE)
#: Seconds between two looks at whether ROS shuts down.
LOOK_S = 0.5
#: Messages that wait, at most; the oldest ones are dropped.
MOST_WAITING = 100


class TopicMicrophone:
    """Reads 16 kHz, 16 bit, mono from audio_common_msgs/AudioData or std_msgs/UInt8MultiArray."""

    def __init__(self, topic: str) -> None:
        """
        Args:
            topic: its name
        """
        self.complaint = ""
        self._topic = topic
        self._waiting: queue.Queue[rospy.AnyMsg] = queue.Queue(MOST_WAITING)
        rospy.loginfo("waiting for sound on %s", topic)
        self._subscriber = rospy.Subscriber(topic, rospy.AnyMsg, self._take, queue_size=MOST_WAITING)

    def parts(self) -> Iterator[bytes]:
        """Yield the parts of the stream as long as they come, and wait while none do."""
        return in_parts(self._messages())

    def close(self) -> None:
        """Unsubscribe."""
        self._subscriber.unregister()

    def _take(self, message: rospy.AnyMsg) -> None:
        try:
            self._waiting.put_nowait(message)
        except queue.Full:
            self._waiting.get_nowait()
            self._waiting.put_nowait(message)

    def _messages(self) -> Iterator[bytes]:
        until = math.inf
        while not rospy.is_shutdown():
            try:
                message = self._waiting.get(timeout=LOOK_S)
            except queue.Empty:
                if time.monotonic() >= until:
                    until = math.inf
                    yield QUIET
                continue
            until = time.monotonic() + SILENT_S
            try:
                yield sound_of_message(str(message._connection_header.get("type", "")), bytes(message._buff))
            except NoSound as reason:
                self.complaint = f"{self._topic}: {reason}"
                return
