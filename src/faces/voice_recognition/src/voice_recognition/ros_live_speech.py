"""LiveSpeech of REP 155, in both directions: any other recogniser works in front of this node."""

import threading
from typing import Callable, Dict

import rospy
from hri_msgs.msg import IdsList, LiveSpeech

#: The topics of REP 155 are absolute.
VOICES = "/humans/voices"


class LiveSpeechTopics:
    """Publishes what this node heard, and hears what other nodes published.

    Subscribes:
        /humans/voices/tracked (IdsList), and for each other voice /humans/voices/ID/speech (LiveSpeech)
    Publishes:
        /humans/voices/tracked (IdsList, latched), /humans/voices/ID/speech (LiveSpeech) of the own id
    """

    def __init__(self, voice_id: str, on_final: Callable[[str], None]) -> None:
        """
        Args:
            voice_id: of this node
            on_final: called with each sentence that another node heard
        """
        self._own = voice_id
        self._on_final = on_final
        self._lock = threading.Lock()
        self._voices: Dict[str, rospy.Subscriber] = {}
        self._speech = rospy.Publisher(f"{VOICES}/{voice_id}/speech", LiveSpeech, queue_size=10)
        self._tracked = rospy.Publisher(f"{VOICES}/tracked", IdsList, queue_size=1, latch=True)
        message = IdsList(ids=[voice_id])
        message.header.stamp = rospy.Time.now()
        self._tracked.publish(message)
        self._subscriber = rospy.Subscriber(f"{VOICES}/tracked", IdsList, self._on_tracked, queue_size=10)

    def heard(self, words: str, confidence: float) -> None:
        """Publish a sentence that this node heard."""
        message = LiveSpeech(final=words, confidence=confidence)
        message.header.stamp = rospy.Time.now()
        self._speech.publish(message)

    def _on_tracked(self, message: IdsList) -> None:
        if message._connection_header.get("callerid") == rospy.get_name():
            return
        wanted = {name for name in message.ids[:32] if name and name != self._own}
        with self._lock:
            for gone in set(self._voices) - wanted:
                self._voices.pop(gone).unregister()
            for new in wanted - set(self._voices):
                self._voices[new] = rospy.Subscriber(
                    f"{VOICES}/{new}/speech", LiveSpeech, self._on_speech, queue_size=10
                )

    def _on_speech(self, message: LiveSpeech) -> None:
        if message.final.strip():
            self._on_final(message.final.strip())
