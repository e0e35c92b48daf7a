"""What can be said: follows the frames, units, servers and names, and makes the searches anew when they change."""

import threading
import time
from dataclasses import replace
from typing import FrozenSet, Optional, Sequence, Union

import rospy
from roboframenet_msgs.msg import Fleet, FrameCallback, FrameCatalogue, FrameServers, KnownNames, Lexicon
from roboframenet_msgs.msg import World as WorldMessage

from roboframenet_ros.ros_robots import own_robot
from semantic_frames.ros_server_profile import profile_from_message
from semantic_types import NoWordNet
from stanford_parser_ros.inference import ModelError
from voice_recognition.calling import Calls
from voice_recognition.command_reading import CommandReader
from voice_recognition.ears import Ears, make_shipped_ears
from voice_recognition.live_language import Knowledge, LanguageMaker
from voice_recognition.live_reader import ReaderMaker
from voice_recognition.recogniser import NoRecogniser
from voice_recognition.ros_search_thread import SearchThread
from voice_recognition.whisper_ears import Hearer, WhisperEars, make_whisper_ears
from world_model import World
from world_model.ros_messages import world_from_message

AnyEars = Union[Ears, WhisperEars]

#: Seconds of quiet on the topics before the searches are made again: servers register one after the other.
SETTLE_S = 1.0


class SpeakableCommands:
    """Makes the searches for the commands that the robot can carry out now.

    Subscribes:
        lexicon (Lexicon), frame_catalogue (FrameCatalogue), frame_servers (FrameServers), known_names (KnownNames),
        world (World), fleet (Fleet), if Whisper hears
    """

    def __init__(self, maker_thread: SearchThread, whisper: Optional[Hearer], names: Sequence[str]) -> None:
        """
        Args:
            maker_thread: makes the searches
            whisper: hears; None if pocketsphinx does
            names: by which the robot is called
        """
        own = own_robot()
        self._is_of_one_robot = bool(own)
        self._names = (*names, own)
        self._maker_thread = maker_thread
        self._whisper = whisper
        self._world = World()
        self._new_world: Optional[WorldMessage] = None
        self._readers = ReaderMaker()
        self._reader: Optional[CommandReader] = None
        self._lock = threading.Lock()
        self._knowledge = Knowledge()
        self._changed_at: Optional[float] = None
        self._maker = LanguageMaker()
        self._ears: Optional[AnyEars] = None
        self._subscribers = [
            rospy.Subscriber("lexicon", Lexicon, self._on_lexicon, queue_size=1),
            rospy.Subscriber("frame_catalogue", FrameCatalogue, self._on_catalogue, queue_size=1),
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1),
            rospy.Subscriber("known_names", KnownNames, self._on_names, queue_size=1),
        ]
        if whisper is not None:
            self._subscribers.append(rospy.Subscriber("world", WorldMessage, self._on_world, queue_size=1))
            self._subscribers.append(rospy.Subscriber("fleet", Fleet, self._on_fleet, queue_size=1))

    @property
    def ears(self) -> Optional[AnyEars]:
        """The searches for what can be said; None before there are any."""
        return self._ears

    @property
    def calls(self) -> Calls:
        """The names by which the robot is called, or the robots are."""
        return Calls((*self._names, *self._knowledge.robots))

    def turn(self) -> None:
        """Make the searches anew if what can be said has changed, and changes no more; called now and then."""
        self._take_world()
        with self._lock:
            is_due = self._changed_at is not None and time.monotonic() - self._changed_at >= SETTLE_S
            if is_due:
                self._changed_at = None
        if is_due:
            self._maker_thread.later(self._make_ears)

    def _on_world(self, message: WorldMessage) -> None:
        self._new_world = message

    def _take_world(self) -> None:
        """Read texts with the last world."""
        message, self._new_world = self._new_world, None
        if message is None:
            return
        world = world_from_message(message)
        with self._lock:
            are_names_new = _names(world) != _names(self._world)
            self._world = world
        self._maker_thread.later(lambda: self._read_in(world, has_new_names=are_names_new))

    def _read_in(self, world: World, *, has_new_names: bool) -> None:
        """The searches of pocketsphinx do not change: they follow the names that the robot tells."""
        ears = self._ears
        if self._whisper is None or self._reader is None or not isinstance(ears, WhisperEars):
            return
        self._reader = self._reader.in_world(world, has_new_names=has_new_names)
        if has_new_names:
            self._ears = make_whisper_ears(ears.by_pocketsphinx, self._whisper, self._reader, world, self.calls.names)
        else:
            ears.read_by(self._reader)

    def _on_lexicon(self, message: Lexicon) -> None:
        self._know(unit_files=tuple((file.path, file.text) for file in message.files))

    def _on_catalogue(self, message: FrameCatalogue) -> None:
        self._know(frame_files=tuple((file.path, file.text) for file in message.files))

    def _on_servers(self, message: FrameServers) -> None:
        alive = [one for one in message.callbacks if one.is_alive]
        servers = {(one.frame_name, _topic(one)): one.profile for one in alive}
        self._know(
            served=frozenset(one.frame_name for one in alive),
            # What any robot of a fleet can do can be said: who is to do it is decided later.
            servers=tuple(
                (frame, topic, replace(profile_from_message(profile), robot=""))
                for (frame, topic), profile in servers.items()
            ),
        )

    def _on_fleet(self, message: Fleet) -> None:
        if not self._is_of_one_robot:
            names = (name for robot in message.robots for name in (robot.name, *robot.spoken_names))
            self._know(robots=tuple(dict.fromkeys(names)))

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
            knowledge, world = self._knowledge, self._world
        began = time.monotonic()
        try:
            language = self._maker.make(knowledge)
            ears: AnyEars = make_shipped_ears(language)
            if self._whisper is not None:
                calls = self.calls
                self._reader = self._readers.make(knowledge, ears.finder, world, calls)
                ears = make_whisper_ears(ears, self._whisper, self._reader, world, calls.names)
            self._ears = ears
        except (NoRecogniser, NoWordNet, ModelError) as reason:
            rospy.logerr("no command can be heard: %s", reason)
            return
        rospy.loginfo(
            "can hear %d commands, %d words (%.1f s)",
            len(language.templates),
            len(language.vocabulary()),
            time.monotonic() - began,
        )


def _topic(callback: FrameCallback) -> str:
    """Return the topic of a server in the namespace of its robot."""
    robot, topic = callback.profile.robot, str(callback.callback_topic)
    return topic[len(f"/{robot}/") :] if robot and topic.startswith(f"/{robot}/") else topic


def _names(world: World) -> FrozenSet[str]:
    """Return the names of what the robot knows of."""
    return frozenset(name for one in world.objects for name in (one.id, one.category, *one.names))
