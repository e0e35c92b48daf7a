"""Reads frames and lexical units from files, in the same way as the registrar and the framer."""

import os
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Callable, Dict, FrozenSet, Iterable, List, Mapping, Tuple

from checked_files.source_files import FRAMES_FOLDER, LEXICAL_UNITS_FOLDER, read_text, yaml_files
from frame_registrar.graph import FrameGraph
from semantic_framer.units.lexicon import Lexicon
from semantic_frames import FileRefused, Problem, load_frame
from semantic_frames.frame import SemanticFrame
from semantic_frames.server_profile import AS_IN_2012, Purpose, ServerProfile
from semantic_types import WordTypes, load_name_file, shipped_types


@dataclass(frozen=True)
class Knowledge:
    """Frames and lexical units of some folders, and the problems of their files.

    ``read_names`` are the frames of all readable files, including those that the graph refused; ``types`` are the
    semantic types of words, with the names that the robot knows.
    """

    graph: FrameGraph
    lexicon: Lexicon
    problems: Tuple[Problem, ...]
    read_names: FrozenSet[str]
    types: WordTypes = field(default_factory=shipped_types)

    @property
    def frames(self) -> Mapping[str, SemanticFrame]:
        """Frames by name."""
        return self.graph.frames


def shipped_domains() -> str:
    """Return the folder of the domains: that of the ROS package, or that of the source tree of this module."""
    # The packages of a group stand in one folder, the groups in another.
    for sources in Path(os.path.realpath(__file__)).parents[3:5]:
        for beside in (sources, *sorted(sources.iterdir())):
            if (beside / "roboframenet_domains" / "package.xml").is_file():
                return str(beside / "roboframenet_domains" / "domains")
    import rospkg  # only an install space needs it

    return os.path.join(rospkg.RosPack().get_path("roboframenet_domains"), "domains")


def load_knowledge(paths: Iterable[str]) -> Knowledge:
    """Read frames and units below some folders."""
    folders = list(paths)
    return load_files(list(yaml_files(folders, FRAMES_FOLDER)), list(yaml_files(folders, LEXICAL_UNITS_FOLDER)))


def load_files(frame_files: Iterable[str], unit_files: Iterable[str]) -> Knowledge:
    """Read frames and units from files; a file with mistakes yields problems."""
    return load_texts(_texts(frame_files), _texts(unit_files))


def _texts(paths: Iterable[str]) -> List[Tuple[str, Callable[[], str]]]:
    return [(path, partial(read_text, path)) for path in paths]


def load_texts(
    frame_files: Iterable[Tuple[str, Callable[[], str]]], unit_files: Iterable[Tuple[str, Callable[[], str]]]
) -> Knowledge:
    """Read frames and units from paths, with a function that returns the text of a path."""
    graph, lexicon = FrameGraph(), Lexicon()
    problems: List[Problem] = []
    owners: Dict[str, SemanticFrame] = {}
    for path, text in frame_files:
        try:
            frame = load_frame(text(), path)
            if frame.name in owners:
                problems.append(
                    Problem(
                        "DUPLICATE_FRAME",
                        path,
                        frame.line,
                        "name",
                        f"'{frame.name}'",
                        "a name of its own",
                        f"also in {owners[frame.name].path}:{owners[frame.name].line}",
                    )
                )
                continue
            owners[frame.name] = frame
            graph.add(frame)
        except FileRefused as error:
            problems += error.problems
    for path, text in unit_files:
        try:
            lexicon.add_file(text(), path)
        except FileRefused as error:
            problems += error.problems
    return Knowledge(graph, lexicon, tuple(problems), frozenset(owners))


def with_names(knowledge: Knowledge, paths: Iterable[str]) -> Knowledge:
    """Add the names of some files, in the same way as the framer; a file with mistakes yields problems."""
    names: Dict[str, Tuple[str, ...]] = {}
    problems = list(knowledge.problems)
    for path in paths:
        try:
            names.update(load_name_file(read_text(path), path))
        except FileRefused as error:
            problems += error.problems
    return replace(knowledge, problems=tuple(problems), types=WordTypes(knowledge.types.nouns, names))


def pretend_servers(graph: FrameGraph) -> None:
    """Register a pretended server of the same name for every frame: offline, the servers of the robot are unknown."""
    for name in graph.frames:
        frame = graph.frame(name)
        watches = frame is not None and frame.is_condition
        graph.register(name, name, ServerProfile(purpose=Purpose.WATCHES) if watches else AS_IN_2012)
