"""The node of the semantic framer: finds the frames that a parsed command evokes."""

import os
import threading
import time
from dataclasses import dataclass, field, replace
from typing import Dict, Mapping, Optional, Sequence, Tuple

import rospy
from roboframenet_msgs.msg import (
    Command,
    CommandLexicalUnits,
    CommandParse,
    FilledLexicalUnitList,
    Fleet,
    FrameCatalogue,
    FrameServers,
    Learned,
    Reply,
    SourceFile,
    StopReport,
)
from roboframenet_msgs.msg import (
    KnownNames as KnownNamesMessage,
)
from roboframenet_msgs.msg import (
    World as WorldMessage,
)
from roboframenet_msgs.srv import AddLexicalUnit
from std_msgs.msg import String

from nearest_meaning.learned import LearnedUnit
from nearest_meaning.learned_file import default_learned_file
from nearest_meaning.likeness import Likeness
from roboframenet_ros.command_ids import is_of_agent, is_spoken
from roboframenet_ros.health import Health, Level
from roboframenet_ros.replays import OLDEST_OF_ALL_NS
from roboframenet_ros.ros_hand_over import HandOver
from roboframenet_ros.ros_node import StartError, read_parameters, run_node
from roboframenet_ros.ros_place import Place
from roboframenet_ros.ros_replays import ReplayWatch
from roboframenet_ros.ros_robots import OfEachRobot, topic_of
from roboframenet_ros.ros_stage import Stage
from robot_fleet.addressing import listed, others_addressed, spoken
from robot_fleet.robot_names import Names
from semantic_framer.behaviour_2012 import with_habits
from semantic_framer.framer import Heard, hear
from semantic_framer.learning import Learning
from semantic_framer.ros_deeds import Deeds
from semantic_framer.ros_lexicon import SharedLexicon
from semantic_framer.ros_messages import (
    acting_servers,
    to_clauses,
    to_filled_units,
    to_learned,
    to_plan,
    with_beginning,
)
from semantic_framer.settings import Settings
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.heeding import FrameHeeding, heeded_elements
from semantic_framer.values.dialogue import Context
from semantic_framer.values.outcome import Refusal, Understood, reply_outcome
from semantic_frames import load_frame
from semantic_frames.frame import SemanticFrame
from semantic_frames.read_once import ReadOnce
from semantic_types import NoWordNet
from stanford_parser_ros.ros_messages import to_tree
from utterance_passes.engine.trace import Trace
from utterance_passes.trees.tree import DependencyTree
from world_model import World
from world_model.ros_messages import world_from_message

#: How long to wait for a frame that was added together with its lexical unit, seconds.
CATALOGUE_DELAY_S = 1.0


@dataclass
class _Talk:
    """What the framer keeps of its dialogue with one robot.

    Attributes:
        context: what was said
        stamp: of the last command
        stop_stamp: of the last stop
        heeded: what its servers heed; None when it is not known yet
        subscriber: hears of its stops
        deeds: what it has done
    """

    context: Context = Context()
    stamp: rospy.Time = field(default_factory=rospy.Time)
    stop_stamp: rospy.Time = field(default_factory=rospy.Time)
    heeded: Optional[Mapping[str, FrameHeeding]] = None
    subscriber: Optional[rospy.Subscriber] = None
    deeds: Optional[Deeds] = None

    def is_stopped(self, command: Command) -> bool:
        """Whether a stop ended a command. A stop in the future does not count: the clock was set back."""
        return not command.stamp.is_zero() and command.stamp <= self.stop_stamp <= rospy.Time.now()


class SemanticFramer:
    """Understands commands, one at a time. Each robot of a fleet has a dialogue of its own.

    Subscribes:
        command_parse (CommandParse), frame_catalogue (FrameCatalogue, latched), frame_servers (FrameServers, latched),
        stop_report (StopReport), tried_frames (TriedFrame), known_names (KnownNames, latched), world (World, latched),
        fleet (Fleet, latched)
    Publishes:
        command_lexical_units (CommandLexicalUnits), filled_lexical_units (FilledLexicalUnitList),
        lexicon (Lexicon, latched), learned (Learned, latched), learned_frames (FrameCatalogue, latched),
        file_problems (FileProblems, latched), stage_events (StageEvent)
    Services:
        add_lexical_unit
    Parameters: see :class:`semantic_framer.settings.Settings`.
    """

    def __init__(self, settings: Settings, place: Place) -> None:
        self._settings = settings
        self._lock = threading.Condition()
        self._frames: Dict[str, SemanticFrame] = {}
        self._servers = FrameServers()
        self._frame_files: ReadOnce[SemanticFrame] = ReadOnce(load_frame)
        # Each robot has its own dialogue, and its own servers.
        self._talks: OfEachRobot[_Talk] = OfEachRobot(self._meet)
        self._talks.get("")
        self._units = HandOver("command_lexical_units", CommandLexicalUnits)
        self._units_2012 = rospy.Publisher("filled_lexical_units", FilledLexicalUnitList, queue_size=100)
        self._stage = Stage("semantic_framer")
        self._replays = ReplayWatch(self._stage, oldest_ns=OLDEST_OF_ALL_NS)
        self._robots = Names({})
        self._world = World()
        self._speaker = settings.speaker
        self._shared = SharedLexicon(settings, place, self._lock)
        self._lexicon = self._shared.units
        self._likeness = Likeness()
        self._learned = rospy.Publisher("learned", Learned, queue_size=1, latch=True)
        self._learned_frames = rospy.Publisher("learned_frames", FrameCatalogue, queue_size=1, latch=True)
        self._learning = Learning(
            os.path.expanduser(settings.learned_file or default_learned_file()),
            self._lexicon,
            self._shared.files,
            warn=rospy.logwarn,
            now=time.time,
            tell=self._tell_learned,
        )
        rospy.on_shutdown(self._learning.close)
        self._subscribers = [
            rospy.Subscriber("frame_catalogue", FrameCatalogue, self._on_catalogue, queue_size=1),
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1),
            rospy.Subscriber("command_parse", CommandParse, self._on_command, queue_size=100),
            rospy.Subscriber("known_names", KnownNamesMessage, self._shared.on_names, queue_size=1),
            rospy.Subscriber("fleet", Fleet, self._on_fleet, queue_size=1),
            rospy.Subscriber("speaker", String, self._on_speaker, queue_size=1),
            rospy.Subscriber("world", WorldMessage, self._on_world, queue_size=1),
        ]
        self._service = rospy.Service("add_lexical_unit", AddLexicalUnit, self._shared.on_add)
        rospy.loginfo(
            "ready: %d lexical units, %d verbs, %d problems, %s",
            len(self._lexicon.units),
            len(self._lexicon.verbs),
            self._shared.problem_count,
            settings,
        )

    def health(self) -> Health:
        """How the node is."""
        values = {"lexical units": len(self._lexicon.units), "frames": len(self._frames)}
        if not self._frames:
            return Health(Level.WARN, "No frame is known: frame_registrar has published none.", values)
        if self._shared.problem_count:
            return Health(Level.WARN, f"Problems in files: {self._shared.problem_count}; see file_problems.", values)
        return Health(values=values)

    def _tell_learned(self, units: Sequence[LearnedUnit]) -> None:
        frames = [SourceFile(path=unit.path, text=unit.frame_text) for unit in units if unit.frame_text]
        self._learned_frames.publish(FrameCatalogue(files=frames))
        self._learned.publish(to_learned(units))

    def _on_fleet(self, message: Fleet) -> None:
        named: Dict[str, Sequence[str]] = {robot.name: robot.spoken_names for robot in message.robots}
        self._robots = Names({**dict.fromkeys(message.absent, ()), **named})

    def _on_speaker(self, message: String) -> None:
        with self._lock:
            self._speaker = message.data or self._settings.speaker

    def _on_world(self, message: WorldMessage) -> None:
        # The categories of the objects are looked up here, and not while a command waits.
        world = world_from_message(message).prepare()
        with self._lock:
            self._world = world

    def _on_catalogue(self, message: FrameCatalogue) -> None:
        contents, refused = self._frame_files.contents((file.path, file.text) for file in message.files)
        for reason in refused:
            rospy.logwarn("the catalogue holds a frame that cannot be read: %s", reason)
        frames = {frame.name: frame for frame in contents}
        with self._lock:
            self._frames = frames
            self._forget_heeded()
            self._lock.notify_all()

    def _on_servers(self, message: FrameServers) -> None:
        with self._lock:
            self._servers = message
            self._forget_heeded()

    def _forget_heeded(self) -> None:
        """The servers or the frames changed. Called with the lock."""
        for robot in self._talks:
            talk = self._talks.get(robot)
            if talk is not None:
                talk.heeded = None
        # The next command of the only robot does not wait for it.
        self._heeded_by(self._talk(""), "")

    def _heeded_by(self, talk: _Talk, robot: str) -> Mapping[str, FrameHeeding]:
        """Return what the servers of a robot heed. Called with the lock."""
        if talk.heeded is None:
            talk.heeded = heeded_elements(self._frames, acting_servers(self._servers, robot))
        return talk.heeded

    def _meet(self, robot: str) -> _Talk:
        """A robot is heard of: its stops end its dialogue."""
        talk = _Talk()

        def on_stop(report: StopReport) -> None:
            """Forget the open question and the last command: after a stop, nothing answers or repeats them."""
            with self._lock:
                talk.stop_stamp = report.stop_stamp
                if talk.stamp <= report.stop_stamp:
                    talk.context = talk.context.stopped()

        talk.subscriber = rospy.Subscriber(topic_of(robot, "stop_report"), StopReport, on_stop, queue_size=100)
        talk.deeds = Deeds(robot)
        return talk

    def _talk(self, robot: str) -> _Talk:
        """Return the dialogue with a robot; that of the only one if this is no name of a robot."""
        talk = self._talks.get(robot) or self._talks.get("")
        assert talk is not None
        return talk

    def _on_command(self, message: CommandParse) -> None:
        if self._replays.refuses(message.command):
            return
        robot = message.command.robot
        others = others_addressed(message.command.text, robot, self._robots, self._lexicon.verbs) if robot else ()
        if others:
            sentence = f"That is for {listed(others)}. I am {spoken(robot)}."
            self._end(message.command, outcome=Reply.REFUSED, code="NOT_ADDRESSED", sentence=sentence)
            return
        if self._talk(robot).is_stopped(message.command):
            # It is answered already. What is said next does not wait until it is understood.
            self._end(message.command, outcome=Reply.SUPERSEDED, code="STOPPED", sentence="A stop ended it.")
            return
        try:
            tree = to_tree(message.command.text, message.words, message.alternatives)
            self._learning.refresh()
            heard, trace = self._read(tree, message.command)
            self._learning.take(heard.lessons, self._speaker)
            outcome = heard.outcome
        except Exception as error:  # boundary: the command gets its reply even if anything fails here
            rospy.logerr("cmd=%s failed", message.command.id, exc_info=True)
            self._end(
                message.command,
                outcome=Reply.FAILED,
                code="STAGE_ERROR",
                sentence=f"The semantic framer failed: {type(error).__name__}: {error}",
            )
            return
        if isinstance(outcome, Understood):
            self._pass_on(message, outcome, tree, trace)
        else:
            kind = getattr(Reply, reply_outcome(outcome))
            self._end(message.command, outcome=kind, code=outcome.code, sentence=outcome.sentence, trace=trace)

    def _read(self, tree: DependencyTree, command: Command) -> Tuple[Heard, str]:
        """Return what an utterance means, and the trace of the rules."""
        end = time.monotonic() + CATALOGUE_DELAY_S
        talk = self._talk(command.robot)
        with self._lock:
            while True:
                frames, names = self._frames, self._learning.names
                trace = Trace() if self._settings.trace else None
                heard = hear(
                    tree,
                    FramedLexicon(
                        self._lexicon,
                        frames,
                        names.types_with(self._shared.names.types),
                        self._heeded_by(talk, command.robot),
                        names.world_with(self._world),
                        self._speaker,
                        talk.deeds.done(frames) if talk.deeds is not None else None,
                        likeness=self._likeness,
                        declined=self._learning.declined,
                        taught=names,
                    ),
                    context=talk.context,
                    policy=self._settings.policy,
                    now_s=time.monotonic(),
                    said_s=command.stamp.to_sec(),
                    is_at_page=not is_spoken(command.id),
                    may_teach=not is_of_agent(command.id),
                    trace=trace,
                )
                outcome = heard.outcome
                if (
                    not isinstance(outcome, Refusal)
                    or outcome.code != "UNKNOWN_FRAME"
                    or not self._lock.wait_for(
                        lambda read_with=frames: self._frames is not read_with, timeout=max(0.0, end - time.monotonic())
                    )
                ):
                    outcome, context = with_habits(
                        outcome,
                        heard.context,
                        arguments=self._settings.arguments,
                        questions=self._settings.questions,
                        trace=trace,
                    )
                    # A command that is stopped while it is understood asks nothing.
                    talk.context = context.stopped() if talk.is_stopped(command) else context
                    talk.stamp = command.stamp
                    return replace(heard, outcome=outcome), str(trace) if trace is not None else ""

    def _pass_on(self, message: CommandParse, understood: Understood, tree: DependencyTree, trace: str) -> None:
        # The next stage works while the others are told.
        self._units.publish(
            CommandLexicalUnits(
                command=message.command,
                clauses=to_clauses(understood.clauses, tree),
                plan=with_beginning(to_plan(understood, message.command.text), understood.beginning),
            )
        )
        described = "; then ".join(" or ".join(map(str, readings[:3])) for readings in understood.clauses)
        self._stage.passes_on(
            message.command,
            " ".join(part for part in (described, understood.warning and f"({understood.warning})") if part),
            trace=trace,
        )
        self._units_2012.publish(to_filled_units(understood.clauses))

    def _end(self, command: Command, *, outcome: int, code: str, sentence: str, trace: str = "") -> None:
        rospy.loginfo("cmd=%s ends here: %s", command.id, sentence)
        self._stage.ends(command, outcome=outcome, code=code, sentence=sentence, trace=trace)


def start(place: Place) -> SemanticFramer:
    """Start the stage.

    Raises:
        ParameterError: a parameter is wrong
        StartError: the database of nouns is not installed
    """
    try:
        return SemanticFramer(read_parameters(Settings, prefix=place.private), place)
    except NoWordNet as error:
        raise StartError(str(error)) from error


def main() -> None:
    """Run the node until ROS shuts down; exit with a message if it cannot start."""
    run_node("semantic_framer", lambda: start(Place()))
