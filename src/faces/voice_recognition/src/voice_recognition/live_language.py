"""What can be said to the robot that runs: files and names come by topic, and change."""

from dataclasses import dataclass
from typing import Dict, FrozenSet, Iterable, List, Mapping, Sequence, Tuple

from semantic_frames import FileRefused, load_frame, load_lexical_units
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from semantic_frames.server_profile import ServerProfile
from semantic_types import Names, WordTypes, checked_names, shipped_types
from voice_recognition.spoken_language import SpokenLanguage, grounded_frames, make_language

#: Path and text.
File = Tuple[str, str]


@dataclass(frozen=True)
class Knowledge:
    """What the robot knows, as it is latched on its topics.

    Attributes:
        unit_files: of the lexicon
        frame_files: of the frame catalogue
        served: frames with a live server
        servers: these servers: frame, topic, and what the server states
        robots: names of the robots that are spoken to, if there are several
        names: what it knows, with the semantic types of each
    """

    unit_files: Tuple[File, ...] = ()
    frame_files: Tuple[File, ...] = ()
    served: FrozenSet[str] = frozenset()
    names: Tuple[Tuple[str, Tuple[str, ...]], ...] = ()
    servers: Tuple[Tuple[str, str, ServerProfile], ...] = ()
    robots: Tuple[str, ...] = ()


class LanguageMaker:
    """Makes the language of a robot; files that it has read before are not read again."""

    def __init__(self) -> None:
        self._units: Dict[File, Tuple[LexicalUnit, ...]] = {}
        self._frames: Dict[File, Tuple[SemanticFrame, ...]] = {}

    def make(self, knowledge: Knowledge) -> SpokenLanguage:
        """Make the language.

        Raises:
            NoWordNet: the database of nouns is not installed
        """
        self._units = {file: self._units.get(file) or _units(file) for file in knowledge.unit_files}
        self._frames = {file: self._frames.get(file) or _frames(file) for file in knowledge.frame_files}
        frames = {frame.name: frame for read in self._frames.values() for frame in read}
        units = [unit for read in self._units.values() for unit in read]
        names = known_names(knowledge.names)
        types = WordTypes(shipped_types().nouns, names)
        return make_language(frames, units, grounded_frames(frames, knowledge.served), names, types)


def _units(file: File) -> Tuple[LexicalUnit, ...]:
    try:
        return tuple(load_lexical_units(file[1], file[0]))
    except FileRefused:
        return ()  # the framer has said why


def _frames(file: File) -> Tuple[SemanticFrame, ...]:
    try:
        return (load_frame(file[1], file[0]),)
    except FileRefused:
        return ()  # the registrar has said why


def known_names(pairs: Iterable[Tuple[str, Sequence[str]]]) -> Names:
    """Return names that are well formed; the others are left out."""
    found: Dict[str, Tuple[str, ...]] = {}
    refused: List[str] = []
    for name, types in pairs:
        try:
            checked: Mapping[str, Tuple[str, ...]] = checked_names([(name, types)], "known_names")
        except FileRefused:
            refused.append(name)
            continue
        # `checked_names` writes names as they are compared; the capitals tell persons from things.
        found[name] = next(iter(checked.values()))
    return found
