"""The lexicon of the framer on its topics: files that are added, what is wrong with them, and known names."""

import uuid
from typing import ContextManager, List

import rospy
from roboframenet_msgs.msg import FileProblem, SourceFile
from roboframenet_msgs.msg import KnownNames as KnownNamesMessage
from roboframenet_msgs.msg import Lexicon as LexiconMessage
from roboframenet_msgs.srv import AddLexicalUnitRequest, AddLexicalUnitResponse

from checked_files.source_files import LEXICAL_UNITS_FOLDER, yaml_files
from roboframenet_ros.ros_place import Place
from semantic_framer.settings import Settings
from semantic_framer.units.known_names import KnownNames
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.units.lexicon_files import LexiconFiles, LexiconState

#: The node keeps the files that were added while it ran in this private parameter.
ADDED_LEXICAL_UNITS = "_added_lexical_units"


class SharedLexicon:
    """The lexicon and the known names, as other nodes hear of them and add to them.

    Attributes:
        units: the lexicon; readers hold the lock
        names: what is known by a name
        files: adds files to the lexicon
        problem_count: of problems in the files, and in the file of names
    """

    def __init__(self, settings: Settings, place: Place, lock: ContextManager[object]) -> None:
        """
        Args:
            settings: of the framer
            place: where it runs
            lock: held while the lexicon changes
        """
        self._place = place
        self._id = uuid.uuid4().hex
        self._publisher = rospy.Publisher("lexicon", LexiconMessage, queue_size=1, latch=True)
        place.problems.advertise()
        self._configured = tuple(yaml_files(settings.lexical_unit_paths, LEXICAL_UNITS_FOLDER))
        self._added: List[str] = rospy.get_param(place.private + ADDED_LEXICAL_UNITS, [])
        self._is_announced = False
        self.problem_count = 0
        self.names = KnownNames(settings.names_file)
        for problem in self.names.problems:
            rospy.logerr("refused: %s", problem)
        self.units = Lexicon()
        self.files = LexiconFiles(self.units, lock, self._announce)
        self.files.add(self._configured + tuple(self._added))

    def _announce(self, state: LexiconState) -> None:
        """Publish the current state. Only one thread at a time calls this, so the latched message is the newest."""
        for problem in state.refused:
            rospy.logerr("refused: %s", problem)
        self.problem_count = len(self.names.problems) + len(state.problems)
        self._place.problems.publish(
            "semantic_framer",
            [
                FileProblem(
                    code=problem.code,
                    path=problem.path,
                    line=problem.line,
                    key=problem.key,
                    found=problem.found,
                    expected=problem.expected,
                    hint=problem.hint,
                )
                for problem in self.names.problems + state.problems
            ],
        )
        if state.accepted or state.is_learned or not self._is_announced:
            # Servers look at each lexicon for what is missing: a refused file changes nothing for them.
            self._is_announced = True
            self._publisher.publish(
                LexiconMessage(
                    framer_id=self._id,
                    files=[SourceFile(path=path, text=text) for path, text in state.files.items()],
                )
            )
        new = [path for path in state.accepted if path not in self._configured and path not in self._added]
        if new:
            self._added += new
            rospy.set_param(self._place.private + ADDED_LEXICAL_UNITS, self._added)

    def on_add(self, request: AddLexicalUnitRequest) -> AddLexicalUnitResponse:
        """Add the file of a request; the service ``add_lexical_unit``."""
        return AddLexicalUnitResponse(success=not self.files.add([request.absolute_file_path]).refused)

    def on_names(self, message: KnownNamesMessage) -> None:
        """Take over known names; those of a wrong message are refused."""
        source = message._connection_header.get("callerid", "known_names")
        problems = self.names.hear(((known.name, known.semantic_types) for known in message.names), source)
        if problems:
            rospy.logerr("rejected new names, keeping the old ones: %s", problems[0])
