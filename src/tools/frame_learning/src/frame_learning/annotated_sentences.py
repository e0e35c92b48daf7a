"""Annotated sentences, from which lexical units are learned: YAML files, and commands of a corpus.

    - text: Water the roses in the front garden.
      frame_name: watering
      verb: Water
      frame_elements: {plant: the roses, place: in the front garden}

``verb`` holds the words of the verb as they occur in the text ("pick up" also for "Pick it up"); each element holds the
words that fill it. A preposition may be left out, because the parse shows it.
"""

import re
from dataclasses import dataclass
from typing import Dict, Iterable, List, Mapping, Optional, Sequence, Tuple

import yaml

from checked_files.marked_yaml import Reader, line_of
from checked_files.source_files import read_text
from frame_learning.annotated_commands import AnnotatedCommand, AnnotatedElement, AnnotatedFrame
from frame_learning.corpus_mapping import CorpusMapping
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit

Span = Tuple[int, int]
SENTENCE_KEYS = ("text", "frame_name", "verb", "frame_elements")


@dataclass(frozen=True)
class AnnotatedSentence:
    """A sentence and one frame that it evokes.

    Attributes:
        text: the sentence
        frame_name: the name of our frame
        verb: characters of the words of the verb
        elements: characters of the words of each element, by name
        place: file and line, "garden.yaml:3"
    """

    text: str
    frame_name: str
    verb: Tuple[Span, ...]
    elements: Mapping[str, Tuple[Span, ...]]
    place: str


def read_sentences(path: str) -> Tuple[AnnotatedSentence, ...]:
    """Read a file of annotated sentences.

    Raises:
        FileRefused: the file has mistakes, such as a verb or an element that is not in its text; the exception carries
            all of them
    """
    reader = Reader(path)
    root = reader.compose(read_text(path), "a list of sentences with text, frame_name, verb and frame_elements")
    if not isinstance(root, yaml.SequenceNode):
        reader.report("WRONG_TYPE", root, "file", "no list", "a list of sentences")
    sentences = [_sentence(reader, node, key) for key, node in reader.sequence(root, "")]
    reader.refuse_if_wrong()
    return tuple(sentences)


def _sentence(reader: Reader, node: yaml.Node, key: str) -> AnnotatedSentence:
    entries = reader.mapping(node, key, SENTENCE_KEYS, required=("text", "frame_name", "verb"))
    text = reader.name(entries.get("text"), f"{key}.text")
    verb = _words(text, reader.name(entries.get("verb"), f"{key}.verb"))
    if "verb" in entries and not verb:
        reader.report("NOT_IN_TEXT", entries["verb"], f"{key}.verb", "words that are not there", f'words of "{text}"')
    elements: Dict[str, Tuple[Span, ...]] = {}
    filled = entries.get("frame_elements")
    names = [name.value for name, _ in filled.value] if isinstance(filled, yaml.MappingNode) else []
    for name, value in reader.mapping(filled, f"{key}.frame_elements", names).items() if filled is not None else ():
        span = _phrase(text, reader.name(value, f"{key}.frame_elements.{name}"))
        if span is None:
            reader.report(
                "NOT_IN_TEXT", value, f"{key}.frame_elements.{name}", "words that are not there", f'words of "{text}"'
            )
        else:
            elements[name] = (span,)
    frame_name = reader.name(entries.get("frame_name"), f"{key}.frame_name")
    return AnnotatedSentence(text, frame_name, verb, elements, f"{reader.path}:{line_of(node)}")


def _phrase(text: str, words: str) -> Optional[Span]:
    found = re.search(rf"(?<!\w){re.escape(words)}(?!\w)", text, re.IGNORECASE) if words else None
    return (found.start(), found.end()) if found else None


def _words(text: str, words: str) -> Tuple[Span, ...]:
    """Return the places of some words in this order, with or without other words between them; empty if one is
    missing."""
    spans: List[Span] = []
    for word in words.split():
        start = spans[-1][1] if spans else 0
        found = _phrase(text[start:], word)
        if found is None:
            return ()
        spans.append((start + found[0], start + found[1]))
    return tuple(spans)


def sentences_of(
    commands: Iterable[AnnotatedCommand],
    mapping: CorpusMapping,
    frames: Mapping[str, SemanticFrame],
    units: Sequence[LexicalUnit] = (),
) -> Tuple[Tuple[AnnotatedSentence, ...], Tuple[str, ...]]:
    """Make annotated sentences from commands of a corpus.

    Args:
        commands: of the corpus
        mapping: to the names of the corpus
        frames: ours, by name
        units: decide which of several frames a verb evokes when the corpus has one name for them
    Returns:
        sentences, and one line for each frame of the corpus that has no frame here
    """
    sentences: List[AnnotatedSentence] = []
    unexplained: List[str] = []
    for command in commands:
        for annotated in command.frames:
            frame = _our_frame(command, annotated, mapping, frames, units)
            if not annotated.lexical_unit:
                unexplained.append(f'{command.name}: no word evokes {annotated.name}: "{command.text}"')
                continue
            if frame is None:
                unexplained.append(f'{command.name}: no frame of ours is {annotated.name}: "{command.text}"')
                continue
            names = _our_elements(frame, mapping)
            elements: Dict[str, Tuple[Span, ...]] = {}
            for element in annotated.elements:
                if element.name in names:
                    elements[names[element.name]] = tuple(command.spans[at - 1] for at in sorted(element.tokens))
                else:
                    unexplained.append(
                        f'{command.name}: {frame.name} has no element for {element.name}: "{command.text}"'
                    )
            verb = tuple(command.spans[at - 1] for at in annotated.lexical_unit)
            sentences.append(AnnotatedSentence(command.text, frame.name, verb, elements, command.name))
    return tuple(sentences), tuple(unexplained)


def _our_elements(frame: SemanticFrame, mapping: CorpusMapping) -> Dict[str, str]:
    found: Dict[str, str] = {}
    for element in frame.frame_elements:
        name = mapping.element_name(frame, element.name)
        if name is not None:
            found.setdefault(name, element.name)
    return found


def _our_frame(
    command: AnnotatedCommand,
    annotated: AnnotatedFrame,
    mapping: CorpusMapping,
    frames: Mapping[str, SemanticFrame],
    units: Sequence[LexicalUnit],
) -> Optional[SemanticFrame]:
    """Return the frame of that name with the most elements of the sentence, the fewest missing ones, and a unit of the
    verb."""
    words = {command.tokens[at - 1].lower() for at in annotated.lexical_unit}
    wanted = {element.name for element in annotated.elements}
    best: Optional[Tuple[Tuple[int, int, bool, str], SemanticFrame]] = None
    for frame in frames.values():
        if mapping.frame_name(frame) != annotated.name:
            continue
        names = _our_elements(frame, mapping)
        if not all(_may_be(frame, names.get(element.name), command, element) for element in annotated.elements):
            continue
        filled = {names[name] for name in wanted if name in names}
        units_of_measure = {element.unit_element for element in frame.frame_elements}
        missing = [
            element
            for element in frame.frame_elements
            if element.is_core and not element.default and element.name not in units_of_measure
        ]
        has_unit = any(
            unit.frame_name == frame.name and any(verb.split()[0] in words for verb in unit.verbs) for unit in units
        )
        rank = (-len(filled), sum(element.name not in filled for element in missing), not has_unit, frame.name)
        if best is None or rank < best[0]:
            best = (rank, frame)
    return best[1] if best is not None else None


def _may_be(frame: SemanticFrame, name: Optional[str], command: AnnotatedCommand, element: AnnotatedElement) -> bool:
    """Whether words may fill an element; an element that lists its values takes no others."""
    known = frame.element(name) if name is not None else None
    words = {command.tokens[at - 1].lower() for at in element.tokens}
    return known is None or not known.values or bool(words & set(known.values))
