"""Maps the names of frames and elements to those of a corpus; each corpus has a readable file."""

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, FrozenSet, Mapping, Optional

import yaml

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text
from frame_learning.argument_convention import ArgumentConvention, read_convention
from offline_pipeline.knowledge import shipped_domains
from semantic_frames.frame import SemanticFrame

#: Marks an element that a corpus does not annotate.
NOT_ANNOTATED = "-"


@dataclass(frozen=True)
class CorpusMapping:
    """Names of a corpus for ours. A name that is not listed is the one that ``framenet`` gives in the frame file.

    Attributes:
        frames: name in the corpus by name of our frame
        elements: name in the corpus by name of our frame and of its element; under the frame ``all`` for every frame
        words_left_out: words that the spans of the corpus do not begin with (articles, prepositions), lower case
        transparent_nouns: nouns whose "of" phrase contains the head in the corpus, like FrameNet's transparent nouns:
            the door is the head of "the front of the door"
        is_head_span: whether a span of the corpus ends with its head ("the mug" of "the mug on the table")
        has_descriptions: whether relative clauses are annotated ("the tv that is on the table" is located)
        arguments: how the corpus writes arguments; None if it is not scored in its own convention
    """

    frames: Mapping[str, str]
    elements: Mapping[str, Mapping[str, str]]
    words_left_out: FrozenSet[str] = frozenset()
    transparent_nouns: FrozenSet[str] = frozenset()
    is_head_span: bool = False
    has_descriptions: bool = True
    arguments: Optional[ArgumentConvention] = None

    def frame_name(self, frame: SemanticFrame) -> str:
        """Return the name of a frame in the corpus."""
        return self.frames.get(frame.name) or frame.framenet or frame.name

    def element_name(self, frame: SemanticFrame, name: str) -> Optional[str]:
        """Return the name of an element in the corpus, None for one that the corpus does not annotate."""
        listed = self.elements.get(frame.name, {}).get(name) or self.elements.get("all", {}).get(name)
        element = frame.element(name)
        found = listed or (element.framenet if element is not None else "") or name
        return None if found == NOT_ANNOTATED else found


def shipped_mapping(file_name: str) -> str:
    """Return the path of a shipped mapping ("huric.yaml")."""
    return os.path.join(str(Path(shipped_domains()).parent), "corpora", file_name)


def load_mapping(path: str) -> CorpusMapping:
    """Read a mapping.

    Raises:
        FileRefused: the file cannot be read, or has another form
    """
    reader = Reader(path)
    root = reader.compose(read_text(path), "a mapping with frames and frame_elements")
    entries = reader.mapping(
        root,
        "",
        (
            "frames",
            "frame_elements",
            "words_left_out",
            "transparent_nouns",
            "head_spans",
            "descriptions",
            "arguments",
        ),
    )
    elements = {
        name: _names(reader, node, f"frame_elements.{name}")
        for name, node in _pairs(reader, entries.get("frame_elements"), "frame_elements").items()
    }
    mapping = CorpusMapping(
        frames=_names(reader, entries.get("frames"), "frames"),
        elements=elements,
        words_left_out=frozenset(reader.texts(entries.get("words_left_out"), "words_left_out")),
        transparent_nouns=frozenset(reader.texts(entries.get("transparent_nouns"), "transparent_nouns")),
        is_head_span=reader.boolean(entries.get("head_spans"), "head_spans"),
        has_descriptions=reader.boolean(entries.get("descriptions"), "descriptions", default=True),
        arguments=read_convention(reader, entries.get("arguments"), "arguments"),
    )
    reader.refuse_if_wrong()
    return mapping


def _pairs(reader: Reader, node: Optional[yaml.Node], key: str) -> Dict[str, yaml.Node]:
    if node is None:
        return {}
    names = [str(name.value) for name, _ in node.value] if isinstance(node, yaml.MappingNode) else []
    return reader.mapping(node, key, names)


def _names(reader: Reader, node: Optional[yaml.Node], key: str) -> Dict[str, str]:
    return {name: reader.name(value, f"{key}.{name}") for name, value in _pairs(reader, node, key).items()}
