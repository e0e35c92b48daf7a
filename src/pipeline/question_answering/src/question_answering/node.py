"""Answers questions: the stage that asks servers, and the server that knows the robot and its world."""

import threading
from collections import deque
from dataclasses import dataclass
from datetime import datetime
from typing import Deque, Dict, FrozenSet, Tuple

import rospy
from roboframenet_msgs.msg import (
    Command,
    CommandStatus,
    FilledSemanticFrameResult,
    FrameCatalogue,
    FrameServers,
    WorldUpdate,
)
from roboframenet_msgs.msg import (
    Lexicon as LexiconMessage,
)
from roboframenet_msgs.msg import (
    World as WorldMessage,
)
from std_msgs.msg import String

from question_answering.answers import ANSWERS, BEING_NAMED, answer, person_named
from question_answering.answers_about_events import was_done
from question_answering.robot_knowledge import RobotKnowledge, examples_of, served_frames
from question_answering.ros_asking import Asking
from question_answering.ros_history import History
from rfnserver import ConditionServer, ConditionUnknown, RFNServer, TypedFrame
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_place import Place
from semantic_frames import load_frame, load_lexical_units
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from semantic_frames.read_once import ReadOnce
from world_model import World, WorldObject
from world_model.ros_messages import object_to_message, world_from_message

#: The frame that says that the robot did something, and how often the log is asked while somebody waits for it.
CONDITION_OF_DEED = "condition_of_deed"
_WATCH_PERIOD_S = 0.2
# How long a question waits for the status that tells of it, seconds; it comes by another way, and earlier as a rule.
_STATUS_WAIT_S = 0.5
# How long the first question waits for what the node has not heard since it started, seconds. A graph without a world
# model never tells of a world; then only the first question waits.
_START_WAIT_S = 3.0


@dataclass(frozen=True)
class Settings(Parameters):
    """The private parameters, after validation.

    Attributes:
        name: of the robot
        timeout_s: for a server to answer a question
        speaker: id of the person who speaks until the topic says another; empty: nobody known

    Raises:
        ParameterError: a value is not allowed
    """

    name: str = parameter("Robo", may_be_empty=False)
    timeout_s: float = parameter(5.0, least=0.1, most=60.0)
    speaker: str = parameter("")


class QuestionAnswering:
    """Knows the robot, and answers questions.

    Actions:
        question_answering (roboframenet_msgs/FilledSemanticFrameAction): every frame of :data:`answers.ANSWERS`
        deeds_watch (roboframenet_msgs/FilledSemanticFrameAction): watches ``condition_of_deed``
    Subscribes:
        world (World), frame_catalogue (FrameCatalogue), frame_servers (FrameServers), lexicon (Lexicon),
        status (CommandStatus), command_question (CommandPlan), speaker (std_msgs/String), and those of
        :class:`.ros_history.History`
    Publishes:
        stage_events (StageEvent), speaker (std_msgs/String, latched), world_updates (WorldUpdate)
    Parameters: see :class:`Settings`.
    """

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._lock = threading.Lock()
        self._is_told = threading.Condition(self._lock)
        self._unheard = {"world", "frame_catalogue", "frame_servers", "lexicon"}
        self._world_message = WorldMessage()
        self._world = World()
        self._frames: Dict[str, SemanticFrame] = {}
        self._units: Tuple[LexicalUnit, ...] = ()
        self._frame_files: ReadOnce[SemanticFrame] = ReadOnce(load_frame)
        self._unit_files: ReadOnce[Tuple[LexicalUnit, ...]] = ReadOnce(load_lexical_units)
        #: Frames with a living server, and of those the ones that can be carried out or answered.
        self._alive: FrozenSet[str] = frozenset()
        self._served: FrozenSet[str] = frozenset()
        self._status = CommandStatus()
        self._said: Deque[Command] = deque(maxlen=2)
        self._speaker = settings.speaker
        self._speakers = rospy.Publisher("speaker", String, queue_size=5, latch=True)
        self._updates = rospy.Publisher("world_updates", WorldUpdate, queue_size=5)
        self._history = History()
        self._subscribers = [
            rospy.Subscriber("world", WorldMessage, self._on_world, queue_size=1),
            rospy.Subscriber("frame_catalogue", FrameCatalogue, self._on_catalogue, queue_size=1),
            rospy.Subscriber("speaker", String, self._on_speaker, queue_size=1),
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1),
            rospy.Subscriber("lexicon", LexiconMessage, self._on_lexicon, queue_size=1),
            rospy.Subscriber("status", CommandStatus, self._on_status, queue_size=20),
        ]
        self._server = RFNServer("question_answering", self._on_question)
        for name in ANSWERS:
            self._server.register_with_frame(name)
        self._server.start()
        self._watch = ConditionServer("deeds_watch", self._holds, period_s=_WATCH_PERIOD_S)
        self._watch.register_with_frame(CONDITION_OF_DEED)
        self._watch.start()
        self._asking = Asking(timeout_s=settings.timeout_s, before=self._wait_until_told)

    def _hear(self, topic: str) -> None:
        """A topic has told what a question may be about. Called with the lock."""
        self._unheard.discard(topic)
        self._is_told.notify_all()

    def _on_world(self, message: WorldMessage) -> None:
        with self._lock:
            self._world_message = message
            self._hear("world")

    def _on_catalogue(self, message: FrameCatalogue) -> None:
        # The registrar has said which it refused.
        contents, _ = self._frame_files.contents((file.path, file.text) for file in message.files)
        frames = {frame.name: frame for frame in contents}
        with self._lock:
            self._frames = frames
            self._served = served_frames(frames, self._alive)
            self._hear("frame_catalogue")

    def _on_speaker(self, message: String) -> None:
        with self._lock:
            self._speaker = message.data or self._settings.speaker

    def _on_servers(self, message: FrameServers) -> None:
        with self._lock:
            self._alive = frozenset(one.frame_name for one in message.callbacks if one.is_alive)
            self._served = served_frames(self._frames, self._alive)
            self._hear("frame_servers")

    def _on_lexicon(self, message: LexiconMessage) -> None:
        # The framer has said which it refused.
        contents, _ = self._unit_files.contents((file.path, file.text) for file in message.files)
        with self._lock:
            self._units = tuple(unit for units in contents for unit in units)
            self._hear("lexicon")

    def _on_status(self, message: CommandStatus) -> None:
        # Not command_text: command_server takes whoever listens to that for the parser.
        with self._lock:
            self._status = message
            # Who was answered within a moment may never be told as active.
            for command in (message.last_reply.command, *message.active):
                if command.id and (not self._said or command.stamp > self._said[-1].stamp):
                    self._said.append(command)
            self._is_told.notify_all()

    def _wait_until_told(self, question: Command) -> None:
        """Wait until the node knows what was said before a question, and what it may be about."""
        with self._is_told:
            self._is_told.wait_for(
                lambda: bool(self._said) and self._said[-1].stamp >= question.stamp, timeout=_STATUS_WAIT_S
            )
            if not self._is_told.wait_for(lambda: not self._unheard, timeout=_START_WAIT_S):
                rospy.logwarn("no data on %s yet; answers omit it", ", ".join(sorted(self._unheard)))
                self._unheard.clear()

    def _on_question(self, frame: TypedFrame) -> None:
        known = self._known()
        sentence = answer(frame.name, frame.arguments, known)
        if frame.name == BEING_NAMED:
            self._meet(person_named(frame["name"].text, known.world), known.world)
        self._server.set_succeeded(FilledSemanticFrameResult(success=True), sentence)

    def _holds(self, frame: TypedFrame) -> bool:
        """Whether the robot has done what a condition says: "if you have closed the door"."""
        deed = frame["deed"]
        if len(deed.frames) != 1:
            raise ConditionUnknown(f'I do not know what "{deed.text}" means')
        return was_done(deed, self._known())

    def _meet(self, person: WorldObject, world: World) -> None:
        """Somebody has said who they are."""
        if world.get(person.id) is None:
            self._updates.publish(WorldUpdate(objects=[object_to_message(person)]))
        self._speakers.publish(String(data=person.id))

    def _known(self) -> RobotKnowledge:
        with self._lock:
            if self._world.version != self._world_message.version:
                self._world = world_from_message(self._world_message)
            question = self._said[-1].id if self._said else ""
            doing = [command.text for command in self._status.active if command.id != question]
            acting = [name for name in self._served if not self._frames[name].is_question]
            running, planned = self._history.running_and_planned
            return RobotKnowledge(
                world=self._world,
                name=self._settings.name,
                abilities=examples_of(self._frames, self._units, self._served),
                ability_count=len(acting),
                doing=doing[0] if doing else "",
                last_words=self._said[0].text if len(self._said) > 1 else "",
                last_reply=self._status.last_reply.sentence,
                now=datetime.now(),
                deeds=self._history.deeds,
                next_steps=self._history.next_steps,
                speaker=self._speaker,
                tried=self._history.tried,
                running=running,
                planned=planned,
                frames=self._frames,
                served=self._served,
            )


def start(place: Place) -> QuestionAnswering:
    """Start the node.

    Raises:
        ParameterError: a parameter is wrong
    """
    return QuestionAnswering(read_parameters(Settings, prefix=place.private))


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("question_answering", lambda: start(Place()))
