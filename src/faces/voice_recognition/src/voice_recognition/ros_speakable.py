"""What can be said: follows the frames, units, servers and names, and makes the searches anew when they change."""

import threading
import time
from dataclasses import replace
from typing import Optional

import rospy
from roboframenet_msgs.msg import FrameCatalogue, FrameServers, KnownNames, Lexicon

from semantic_types import NoWordNet
from voice_recognition.ears import Ears, make_shipped_ears
from voice_recognition.live_language import Knowledge, LanguageMaker
from voice_recognition.recogniser import NoRecogniser
from voice_recognition.ros_search_thread import SearchThread

#: Seconds of quiet on the topics before the searches are made again: servers register one after the other.
SETTLE_S = 1.0


class SpeakableCommands:
    """Makes the searches for the commands that the robot can carry out now.

    Subscribes:
        lexicon (Lexicon), frame_catalogue (FrameCatalogue), frame_servers (FrameServers), known_names (KnownNames)
    """

    def __init__(self, maker_thread: SearchThread) -> None:
        """
        Args:
            maker_thread: makes the searches
        """
        self._maker_thread = maker_thread
        self._lock = threading.Lock()
        self._knowledge = Knowledge()
        self._changed_at: Optional[float] = None
        self._maker = LanguageMaker()
        self._ears: Optional[Ears] = None
        self._subscribers = [
            rospy.Subscriber("lexicon", Lexicon, self._on_lexicon, queue_size=1),
            rospy.Subscriber("frame_catalogue", FrameCatalogue, self._on_catalogue, queue_size=1),
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1),
            rospy.Subscriber("known_names", KnownNames, self._on_names, queue_size=1),
        ]

    @property
    def ears(self) -> Optional[Ears]:
        """The searches for what can be said; None before there are any."""
        return self._ears

    def turn(self) -> None:
        """Make the searches anew if what can be said has changed, and changes no more; called now and then."""
        with self._lock:
            is_due = self._changed_at is not None and time.monotonic() - self._changed_at >= SETTLE_S
            if is_due:
                self._changed_at = None
        if is_due:
            self._maker_thread.later(self._make_ears)

    def _on_lexicon(self, message: Lexicon) -> None:
        self._know(unit_files=tuple((file.path, file.text) for file in message.files))

    def _on_catalogue(self, message: FrameCatalogue) -> None:
        self._know(frame_files=tuple((file.path, file.text) for file in message.files))

    def _on_servers(self, message: FrameServers) -> None:
        self._know(served=frozenset(one.frame_name for one in message.callbacks if one.is_alive))

    def _on_names(self, message: KnownNames) -> None:
        self._know(names=tuple((known.name, tuple(known.semantic_types)) for known in message.names))

    def _know(self, **changes: object) -> None:
        with self._lock:
            knowledge = replace(self._knowledge, **changes)
            if knowledge != self._knowledge:
                self._knowledge = knowledge
                self._changed_at = time.monotonic()

    def _make_ears(self) -> None:
        with self._lock:
            knowledge = self._knowledge
        began = time.monotonic()
        try:
            language = self._maker.make(knowledge)
            self._ears = make_shipped_ears(language)
        except (NoRecogniser, NoWordNet) as reason:
            rospy.logerr("no command can be heard: %s", reason)
            return
        rospy.loginfo(
            "can hear %d commands, %d words (%.1f s)",
            len(language.templates),
            len(language.vocabulary()),
            time.monotonic() - began,
        )
