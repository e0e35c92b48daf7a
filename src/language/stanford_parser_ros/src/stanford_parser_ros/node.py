"""The parser node: turns the text of a command into dependencies."""

import enum
import gc
import queue
import threading
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Dict, List, Tuple, Union

import rospy
from roboframenet_msgs.msg import Command, CommandParse, FrameCatalogue, KnownNames, Lexicon, Reply
from stanford_parser_msgs.msg import Parse

from roboframenet_ros.health import Health, Level
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.replays import OLDEST_OF_ALL_NS
from roboframenet_ros.ros_hand_over import HandOver
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_replays import ReplayWatch
from roboframenet_ros.ros_stage import Stage
from semantic_frames import load_frame, load_lexical_units
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from semantic_frames.read_once import ReadOnce
from stanford_parser_ros.early_inference import load_onnx, load_stanza
from stanford_parser_ros.inference import Inference, ModelError, shipped_model_dir
from stanford_parser_ros.model import NO_WORDS, Parser, UnparsableText
from stanford_parser_ros.ros_messages import to_command_parse
from stanford_parser_ros.stanford_dependencies import collapsed
from stanford_parser_ros.unit_words import UnitWords
from utterance_passes.trees.tree import DependencyTree

#: Period in which the worker checks whether to end, seconds.
WAKE_UP_S = 1.0


class Runtime(enum.Enum):
    """What computes the models."""

    ONNX = "onnx"
    STANZA = "stanza"
    LEAN = "lean"


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        model_dir: folder of the Stanza models; empty for the shipped ones
        package: name of a package in it; empty for the default one
        runtime: ONNX Runtime; or Stanza with torch, for other packages than the shipped one, before which ONNX Runtime
            answers while it is loaded; ``lean`` is an older name of ``onnx``
        threads: of ONNX Runtime and torch
        cache_size: number of parses that are kept
        queue_size: number of commands that may wait; one more is refused
        trace: whether events say what the passes changed

    Raises:
        ParameterError: a value out of its range
    """

    model_dir: str = parameter("")
    package: str = parameter("default")
    runtime: Runtime = parameter(Runtime.ONNX)
    threads: int = parameter(1, least=1, most=64)
    cache_size: int = parameter(256, least=1, most=100_000)
    queue_size: int = parameter(100, least=1, most=10_000)
    trace: bool = parameter(True)


class ParserNode:
    """Parses one command after the other, in its own thread.

    Subscribes:
        command_text (Command), lexicon (Lexicon, latched), frame_catalogue (FrameCatalogue, latched),
        known_names (KnownNames, latched)
    Publishes:
        command_parse (CommandParse), parse (stanford_parser_msgs/Parse), stage_events (StageEvent)
    Parameters: see :class:`Settings`.
    """

    def __init__(self, settings: Settings) -> None:
        """
        Raises:
            ModelError: the models cannot be loaded
        """
        self._settings = settings
        # Subscribers connect while the models load, so that the first parse is not lost.
        self._parses = HandOver("command_parse", CommandParse)
        self._parses_2012 = rospy.Publisher("parse", Parse, queue_size=100)
        self._stage = Stage("stanford_parser_ros")
        self._replays = ReplayWatch(self._stage, oldest_ns=OLDEST_OF_ALL_NS)
        # The lexicon arrives while the models load, so that the first command is parsed with it.
        self._known = NO_WORDS
        self._lock = threading.Lock()
        self._units: List[Tuple[LexicalUnit, ...]] = []
        self._unit_words = UnitWords()
        self._frames: Dict[str, SemanticFrame] = {}
        self._unit_files: ReadOnce[Tuple[LexicalUnit, ...]] = ReadOnce(load_lexical_units)
        self._frame_files: ReadOnce[SemanticFrame] = ReadOnce(load_frame)
        self._lexicon = rospy.Subscriber("lexicon", Lexicon, self._on_lexicon, queue_size=1)
        self._catalogue = rospy.Subscriber("frame_catalogue", FrameCatalogue, self._on_catalogue, queue_size=1)
        self._names = rospy.Subscriber("known_names", KnownNames, self._on_names, queue_size=1)
        self._trouble = ""
        begin_s = time.monotonic()
        self._parser = Parser(self._load_models(), cache_size=settings.cache_size)
        self._commands: queue.Queue[Command] = queue.Queue(settings.queue_size)
        self._is_closing = threading.Event()
        self._worker = threading.Thread(target=self._run, name="parser", daemon=True)
        self._worker.start()
        rospy.on_shutdown(self._close)
        self._subscriber = rospy.Subscriber("command_text", Command, self._on_command, queue_size=settings.queue_size)
        rospy.loginfo("ready after %.1f s: %s", time.monotonic() - begin_s, settings)

    def _load_models(self) -> Inference:
        """Load the models into the chosen runtime.

        Raises:
            ModelError: they cannot be loaded
        """
        folder = Path(self._settings.model_dir).expanduser() if self._settings.model_dir else shipped_model_dir()
        package = self._settings.package or Settings.package
        if self._settings.runtime is Runtime.STANZA:
            return load_stanza(
                model_dir=folder,
                package=package,
                threads=self._settings.threads,
                on_loaded=self._on_stanza_loaded,
                on_failed=self._on_stanza_failed,
            )
        if self._settings.runtime is Runtime.LEAN:
            rospy.logwarn("~runtime: lean is now onnx, with other models; say onnx")
        return load_onnx(
            model_dir=folder, package=package, threads=self._settings.threads, on_failed=self._on_onnx_failed
        )

    def _on_stanza_loaded(self, time_s: float) -> None:
        # The models stay until the end: the garbage collector needs a tenth of a second to look at all of them.
        gc.freeze()
        rospy.loginfo("Stanza was loaded in %.1f s, and parses from now on", time_s)

    def _on_onnx_failed(self, error: ModelError) -> None:
        self._trouble = f"Stanza parses, because ONNX Runtime cannot: {error}"
        rospy.logerr("%s", self._trouble)

    def _on_stanza_failed(self, error: ModelError) -> None:
        self._trouble = f"ONNX Runtime parses, because Stanza cannot be loaded: {error}"
        rospy.logerr("%s", self._trouble)

    def health(self) -> Health:
        """How the node is."""
        return Health(
            Level.WARN if self._trouble else Level.OK,
            self._trouble or Health.message,
            values={"waiting commands": self._commands.qsize(), "verbs of the lexicon": len(self._known.verbs)},
        )

    def _on_lexicon(self, message: Lexicon) -> None:
        found, refused = self._unit_files.contents((file.path, file.text) for file in message.files)
        for reason in refused:
            rospy.logwarn("the lexicon holds a file that cannot be read: %s", reason)
        with self._lock:
            self._units = found
            self._learn_words()

    def _on_catalogue(self, message: FrameCatalogue) -> None:
        found, refused = self._frame_files.contents((file.path, file.text) for file in message.files)
        for reason in refused:
            rospy.logwarn("the frame catalogue holds a file that cannot be read: %s", reason)
        with self._lock:
            self._frames = {frame.name: frame for frame in found}
            self._learn_words()

    def _learn_words(self) -> None:
        """Learn the words of the units, with those that they inherit from the roles of their frames."""
        words = self._unit_words.of(self._units, self._frames)
        self._known = replace(self._known, verbs=words.verbs, spellings=words.spellings, hints=words.hints)

    def _on_names(self, message: KnownNames) -> None:
        words = frozenset(word for known in message.names for word in known.name.lower().split())
        with self._lock:
            self._known = replace(self._known, names=words)

    def _on_command(self, command: Command) -> None:
        if self._replays.refuses(command):
            return
        try:
            self._commands.put_nowait(command)
        except queue.Full:
            self._stage.ends(
                command,
                outcome=Reply.FAILED,
                code="BUSY",
                sentence="Too many commands are waiting to be parsed.",
            )

    def _close(self) -> None:
        """Let the current parse end while its reply can still be published."""
        # is_shutdown() is still false while the hooks of a shutdown run.
        self._is_closing.set()
        self._worker.join(2.0 * WAKE_UP_S)

    def _run(self) -> None:
        while not self._is_closing.is_set():
            try:
                command = self._commands.get(timeout=WAKE_UP_S)
            except queue.Empty:
                continue
            self._parse(command)

    def _parse(self, command: Command) -> None:
        try:
            parse = self._parser.traced(command.text, self._known)
            message = to_command_parse(command, parse.tree)
        except UnparsableText as reason:
            code, sentence = reason.refusal
            self._stage.ends(command, outcome=Reply.REFUSED, code=code, sentence=sentence)
            return
        except Exception as error:  # boundary: the command gets its reply even if Stanza fails
            rospy.logerr("cmd=%s cannot be parsed", command.id, exc_info=True)
            self._stage.ends(
                command,
                outcome=Reply.FAILED,
                code="STAGE_ERROR",
                sentence=f"The parser failed: {type(error).__name__}: {error}",
            )
            return
        # The next stage works while the others are told.
        self._parses.publish(message)
        trace = "\n".join(map(str, parse.trace)) if self._settings.trace else ""
        self._stage.passes_on(command, describe(parse.tree), trace=trace)
        self._parses_2012.publish(message.parse)


def describe(tree: DependencyTree) -> str:
    """Return the dependencies in a line: "root(Turn) advmod(Turn, left)"."""
    parts = []
    for dependency in collapsed(tree):
        if dependency.relation != "punct":
            governor = f"{tree.word(dependency.governor).form}, " if dependency.governor else ""
            parts.append(f"{dependency.relation}({governor}{tree.word(dependency.dependent).form})")
    return " ".join(parts)


class ParserWithoutModels:
    """Ends each command with the reason why there is no parser.

    A node that exits would be started again each second, and would never load the models either.

    Subscribes:
        command_text (Command)
    Publishes:
        stage_events (StageEvent)
    """

    def __init__(self, reason: str) -> None:
        self._reason = reason
        self._stage = Stage("stanford_parser_ros")
        self._subscriber = rospy.Subscriber("command_text", Command, self._on_command, queue_size=100)

    def health(self) -> Health:
        """How the node is."""
        return Health(Level.ERROR, f"There is no parser: {self._reason}.")

    def _on_command(self, command: Command) -> None:
        self._stage.ends(
            command,
            outcome=Reply.FAILED,
            code="STAGE_ERROR",
            sentence=f"There is no parser: {self._reason}. Then start the pipeline again.",
        )


def _start() -> Union[ParserNode, ParserWithoutModels]:
    settings = read_parameters(Settings)
    try:
        return ParserNode(settings)
    except ModelError as error:
        rospy.logfatal("%s; every command fails until this node is started again", error)
        return ParserWithoutModels(str(error))


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when it cannot start."""
    run_node("stanford_parser_ros", _start)
