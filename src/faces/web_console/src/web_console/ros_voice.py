"""Shows what the voice hears, and pushes to talk."""

from dataclasses import replace
from typing import Callable

import rospy
from std_msgs.msg import Empty, String, UInt8MultiArray

from web_console.ros_hearing import show
from web_console.views import VoiceView


class VoiceTap:
    """What voice_recognition tells. Its methods are for the thread of the event loop.

    Subscribes: ``voice_state``, ``voice_question``, ``voice_heard``. Publishes: ``push_to_talk``, ``page_sound``.
    """

    def __init__(self, *, call_soon: Callable[..., None], on_voice: Callable[[VoiceView], None]) -> None:
        """Prepare; `start` subscribes.

        Args:
            call_soon: calls a function in the thread of the event loop, from any thread
            on_voice: called in that thread after each change
        """
        self._call_soon = call_soon
        self._on_voice = on_voice
        self._view = VoiceView()
        # Whoever takes the sound may connect after the last message of the voice.
        hearers = _Hearers(lambda: call_soon(self._tell))
        self._sound = rospy.Publisher("page_sound", UInt8MultiArray, subscriber_listener=hearers, queue_size=20)
        self._push = rospy.Publisher("push_to_talk", Empty, queue_size=1)

    def start(self) -> None:
        """Subscribe."""
        self._subscribers = [
            rospy.Subscriber(topic, String, lambda message, tell=tell: self._call_soon(show, tell, message))
            for topic, tell in (
                ("voice_state", lambda message: self._tell(state=message.data)),
                ("voice_question", lambda message: self._tell(question=message.data)),
                # The verdict, what was chosen, and what was heard.
                ("voice_heard", lambda message: self._tell(heard=message.data.rpartition("| ")[2])),
            )
        ]

    def listen(self) -> None:
        """Have the robot listen to one command."""
        self._push.publish(Empty())

    def hear(self, pcm: bytes) -> None:
        """Pass on sound of the microphone of a page: 16 kHz, 16 bit, mono."""
        self._sound.publish(UInt8MultiArray(data=pcm))

    def _tell(self, **changes: str) -> None:
        takes_sound = self._sound.get_num_connections() > 0
        self._view = replace(self._view, takes_sound=takes_sound, **changes)
        self._on_voice(self._view)


class _Hearers(rospy.SubscribeListener):  # type: ignore[misc]
    """Calls back when a subscriber has come or gone, from a thread of rospy."""

    def __init__(self, on_change: Callable[[], None]) -> None:
        self._on_change = on_change

    def peer_subscribe(self, *_told: object) -> None:
        self._on_change()

    def peer_unsubscribe(self, *_told: object) -> None:
        self._on_change()
