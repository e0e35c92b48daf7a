"""The semantic framer: from the parse of a command to the frames that it evokes."""

import threading
import time
import uuid
from dataclasses import dataclass
from typing import Dict, List, Tuple

import rospy
from roboframenet_msgs.msg import (
    Command,
    CommandLexicalUnits,
    CommandParse,
    FileProblem,
    FileProblems,
    FilledLexicalUnitList,
    FrameCatalogue,
    Lexicon as LexiconMessage,
    Reply,
    SourceFile,
)
from roboframenet_msgs.srv import AddLexicalUnit, AddLexicalUnitRequest, AddLexicalUnitResponse
from semantic_frames import FileRefused, load_frame
from semantic_frames.frame import SemanticFrame
from semantic_frames.source_files import LEXICAL_UNITS_FOLDER, yaml_files
from stage_events.ros_stage import Stage
from stanford_parser_ros.ros_messages import to_tree
from stanford_parser_ros.tree import DependencyTree

from semantic_framer.behaviour_2012 import Arguments, Questions, with_habits
from semantic_framer.dialogue import Context
from semantic_framer.framer import Alternatives, LeftOverWords, Outcome, Policy, Question, Refusal, Understood, read
from semantic_framer.lexicon import Lexicon
from semantic_framer.lexicon_files import LexiconFiles, LexiconState
from semantic_framer.matching import Reading
from semantic_framer.ros_messages import to_clauses, to_filled_units
from semantic_framer.sentence import Sentence

#: Kept on the master by the node for itself: files that were added while it ran.
ADDED_LEXICAL_UNITS = "~_added_lexical_units"
#: A frame that was added together with its lexical unit may be on its way still, seconds.
CATALOGUE_DELAY_S = 1.0


@dataclass(frozen=True)
class Settings:
    """Parameters of the node, checked.

    Attributes:
        lexical_unit_paths: files, and folders with folders named ``lexical_units``
        policy: how careful to be
        arguments: which words become arguments
        questions: what to do when something must be known first
    """

    lexical_unit_paths: Tuple[str, ...]
    policy: Policy
    arguments: Arguments
    questions: Questions

    @classmethod
    def from_parameters(cls) -> "Settings":
        """Read the node's private parameters.

        Raises:
            ValueError: a value that is not allowed
        """
        paths = rospy.get_param("~lexical_unit_paths", [])
        timeout_s = float(rospy.get_param("~question_timeout_s", 30.0))
        if not 1.0 <= timeout_s <= 3600.0:
            raise ValueError(f"~question_timeout_s must be 1 to 3600 s, got {timeout_s}")
        return cls(
            lexical_unit_paths=tuple([paths] if isinstance(paths, str) else paths),
            policy=Policy(
                left_over_words=LeftOverWords(rospy.get_param("~left_over_words", "strict")),
                alternatives=Alternatives(rospy.get_param("~alternatives", "either")),
                question_timeout_s=timeout_s,
            ),
            arguments=Arguments(rospy.get_param("~arguments", "phrases")),
            questions=Questions(rospy.get_param("~questions", "ask")),
        )


class SemanticFramer:
    """Understands one command after the other.

    Subscribes:
        command_parse (CommandParse), frame_catalogue (FrameCatalogue, latched)
    Publishes:
        command_lexical_units (CommandLexicalUnits), filled_lexical_units (FilledLexicalUnitList), lexicon (Lexicon, latched),
        file_problems (FileProblems, latched), stage_events (StageEvent)
    Services:
        add_lexical_unit
    Parameters: see :class:`Settings`.
    """

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._lock = threading.Condition()
        self._lexicon = Lexicon()
        self._frames: Dict[str, SemanticFrame] = {}
        self._frame_of_file: Dict[Tuple[str, str], SemanticFrame] = {}
        self._context = Context()
        self._id = uuid.uuid4().hex
        self._units = rospy.Publisher("command_lexical_units", CommandLexicalUnits, queue_size=100)
        self._units_2012 = rospy.Publisher("filled_lexical_units", FilledLexicalUnitList, queue_size=100)
        self._lexicon_publisher = rospy.Publisher("lexicon", LexiconMessage, queue_size=1, latch=True)
        self._file_problems = rospy.Publisher("file_problems", FileProblems, queue_size=5, latch=True)
        self._stage = Stage("semantic_framer")
        self._configured = tuple(yaml_files(settings.lexical_unit_paths, LEXICAL_UNITS_FOLDER))
        self._added: List[str] = rospy.get_param(ADDED_LEXICAL_UNITS, [])
        self._files = LexiconFiles(self._lexicon, self._lock, self._announce)
        state = self._files.add(self._configured + tuple(self._added))
        self._subscribers = [
            rospy.Subscriber("frame_catalogue", FrameCatalogue, self._on_catalogue, queue_size=1),
            rospy.Subscriber("command_parse", CommandParse, self._on_command, queue_size=100),
        ]
        self._service = rospy.Service("add_lexical_unit", AddLexicalUnit, self._on_add_lexical_unit)
        rospy.loginfo(
            "ready: %d lexical units, %d verbs, %d problems, %s",
            len(self._lexicon.units),
            len(self._lexicon.verbs),
            len(state.problems),
            settings,
        )

    def _announce(self, state: LexiconState) -> None:
        """Publish what there is now; called by one thread at a time, so that the latched message is the newest."""
        for problem in state.refused:
            rospy.logerr("refused: %s", problem)
        self._file_problems.publish(
            FileProblems(
                problems=[
                    FileProblem(
                        code=problem.code,
                        path=problem.path,
                        line=problem.line,
                        key=problem.key,
                        found=problem.found,
                        expected=problem.expected,
                        hint=problem.hint,
                    )
                    for problem in state.problems
                ]
            )
        )
        self._lexicon_publisher.publish(
            LexiconMessage(
                framer_id=self._id,
                files=[SourceFile(path=path, text=text) for path, text in state.files.items()],
            )
        )
        new = [path for path in state.accepted if path not in self._configured and path not in self._added]
        if new:
            self._added += new
            rospy.set_param(ADDED_LEXICAL_UNITS, self._added)

    def _on_add_lexical_unit(self, request: AddLexicalUnitRequest) -> AddLexicalUnitResponse:
        return AddLexicalUnitResponse(success=not self._files.add([request.absolute_file_path]).refused)

    def _on_catalogue(self, message: FrameCatalogue) -> None:
        known = self._frame_of_file
        of_file = {}
        for file in message.files:
            try:
                # One registration must not cost the reading of every file again.
                of_file[file.path, file.text] = known.get((file.path, file.text)) or load_frame(file.text, file.path)
            except FileRefused as refused:
                rospy.logwarn("the catalogue holds a frame that cannot be read: %s", refused)
        self._frame_of_file = of_file
        with self._lock:
            self._frames = {frame.name: frame for frame in of_file.values()}
            self._lock.notify_all()

    def _on_command(self, message: CommandParse) -> None:
        try:
            tree = to_tree(message.command.text, message.words)
            outcome = self._read(tree)
        except Exception as error:  # boundary: whatever fails here, the command gets its reply
            rospy.logerr("cmd=%s failed", message.command.id, exc_info=True)
            self._end(
                message.command,
                outcome=Reply.FAILED,
                code="STAGE_ERROR",
                sentence=f"The semantic framer failed: {type(error).__name__}: {error}",
            )
            return
        if isinstance(outcome, Refusal):
            self._end(message.command, outcome=Reply.REFUSED, code=outcome.code, sentence=outcome.sentence)
        elif isinstance(outcome, Question):
            self._end(message.command, outcome=Reply.NEEDS_INFORMATION, code=outcome.code, sentence=outcome.sentence)
        else:
            self._pass_on(message, outcome, Sentence(tree))

    def _read(self, tree: DependencyTree) -> Outcome:
        end = time.monotonic() + CATALOGUE_DELAY_S
        with self._lock:
            while True:
                frames = self._frames
                outcome, context = read(
                    tree,
                    self._lexicon,
                    frames,
                    context=self._context,
                    policy=self._settings.policy,
                    now_s=time.monotonic(),
                )
                if (
                    not isinstance(outcome, Refusal)
                    or outcome.code != "UNKNOWN_FRAME"
                    or not self._lock.wait_for(
                        lambda: self._frames is not frames, timeout=max(0.0, end - time.monotonic())
                    )
                ):
                    outcome, self._context = with_habits(
                        outcome, context, arguments=self._settings.arguments, questions=self._settings.questions
                    )
                    return outcome

    def _pass_on(self, message: CommandParse, understood: Understood, sentence: Sentence) -> None:
        described = "; then ".join(
            " or ".join(describe(reading) for reading in readings[:3]) for readings in understood.clauses
        )
        self._stage.passes_on(
            message.command,
            " ".join(part for part in (described, understood.warning and f"({understood.warning})") if part),
        )
        self._units_2012.publish(to_filled_units(understood.clauses))
        self._units.publish(
            CommandLexicalUnits(command=message.command, clauses=to_clauses(understood.clauses, sentence))
        )

    def _end(self, command: Command, *, outcome: int, code: str, sentence: str) -> None:
        rospy.loginfo("cmd=%s ends here: %s", command.id, sentence)
        self._stage.ends(command, outcome=outcome, code=code, sentence=sentence)


def describe(reading: Reading) -> str:
    """Return a reading in a line: "turning(direction=left, angle=120)"."""
    return f"{reading.unit.frame_name}({', '.join(f'{value.name}={value.argument}' for value in reading.values)})"


def main() -> None:
    """Run the node."""
    rospy.init_node("semantic_framer")
    try:
        SemanticFramer(Settings.from_parameters())
    except ValueError as error:
        rospy.logfatal("cannot start: %s", error)
        raise SystemExit(1) from error
    rospy.spin()
