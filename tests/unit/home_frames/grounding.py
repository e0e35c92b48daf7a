"""Puts together what carries the frames of the domains out in the home, and the sentences of tests that show it."""

from dataclasses import dataclass
from pathlib import Path
from typing import Dict, FrozenSet, List, Mapping, Sequence, Tuple

import yaml

from home_servers.conditions import FRAMES as CONDITIONS
from home_servers.frames import FRAMES
from question_answering.answers import ANSWERS
from question_answering.robot_knowledge import served_frames
from roboframenet_testing.workspace import REPOSITORY, package
from semantic_frames.frame import SemanticFrame

#: Tables of sentences with the frame that each carries out: without ROS, and in the running graph.
TABLES = (package("home_servers") / "test/sentences.yaml", REPOSITORY / "tests/rostest/watching/home_frames.yaml")


@dataclass(frozen=True)
class Grounding:
    """What carries a frame out.

    Attributes:
        frame: its name
        domain: folder of its file
        servers: nodes with a server for it; none for a frame that others make up
        is_composed: whether a sequence of its children carries it out
        sentences: of tests
    """

    frame: str
    domain: str
    servers: Tuple[str, ...]
    is_composed: bool
    sentences: Tuple[str, ...]

    @property
    def is_grounded(self) -> bool:
        """Whether anything carries it out."""
        return bool(self.servers) or self.is_composed


def servers_by_frame() -> Dict[str, Tuple[str, ...]]:
    """Return the nodes that have a server for a frame in the home."""
    nodes: Dict[str, Sequence[str]] = {
        "home_servers": [*FRAMES, *CONDITIONS],
        "question_answering": [*ANSWERS, "condition_of_deed"],
    }
    nodes.update(yaml.safe_load(Path(__file__).with_name("servers.yaml").read_text(encoding="utf-8")))
    found: Dict[str, Tuple[str, ...]] = {}
    for node, frames in nodes.items():
        for frame in frames:
            found[frame] = (*found.get(frame, ()), node)
    return found


def sentences_by_frame() -> Dict[str, Tuple[str, ...]]:
    """Return the sentences of the tables that carry each frame out."""
    found: Dict[str, List[str]] = {}
    for table in TABLES:
        content = yaml.safe_load(table.read_text(encoding="utf-8"))
        for entry in content["cases"] if isinstance(content, dict) else content:
            found.setdefault(entry["frame"], []).append(entry["say"])
    return {frame: tuple(sentences) for frame, sentences in found.items()}


def groundings(frames: Mapping[str, SemanticFrame]) -> Tuple[Grounding, ...]:
    """Return what carries each frame out, by domain and name."""
    servers, sentences = servers_by_frame(), sentences_by_frame()
    served: FrozenSet[str] = served_frames(frames, frozenset(servers))
    found = [
        Grounding(
            name, Path(frame.path).parents[1].name, servers.get(name, ()), name in served, sentences.get(name, ())
        )
        for name, frame in frames.items()
    ]
    return tuple(sorted(found, key=lambda one: (one.domain, one.frame)))
