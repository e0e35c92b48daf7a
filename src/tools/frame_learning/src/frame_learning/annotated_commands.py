"""Annotated commands of a corpus as values, and the positions of their words in a text."""

from dataclasses import dataclass
from typing import FrozenSet, Optional, Sequence, Tuple


class CorpusError(ValueError):
    """A corpus cannot be read; the message names the file and the reason."""


@dataclass(frozen=True)
class AnnotatedElement:
    """A frame element of the corpus.

    Attributes:
        name: as the corpus spells it
        tokens: positions of its words, from 1
        head: position of its head word; None if the corpus names none
    """

    name: str
    tokens: FrozenSet[int]
    head: Optional[int] = None


@dataclass(frozen=True)
class AnnotatedFrame:
    """A frame of the corpus, with the positions of the words that evoke it."""

    name: str
    lexical_unit: Tuple[int, ...]
    elements: Tuple[AnnotatedElement, ...] = ()


@dataclass(frozen=True)
class AnnotatedCommand:
    """A command of a corpus.

    Attributes:
        name: of the file or row, for people
        text: the utterance
        tokens: its words
        spans: first and one past the last character of each word in the text
        frames: in the order of the corpus
    """

    name: str
    text: str
    tokens: Tuple[str, ...]
    spans: Tuple[Tuple[int, int], ...]
    frames: Tuple[AnnotatedFrame, ...]


def command_of(name: str, text: str, tokens: Sequence[str], frames: Sequence[AnnotatedFrame]) -> AnnotatedCommand:
    """Make a command. If its words are not found in its text, the words, separated by blanks, become the text."""
    spans = _find(text, tokens)
    if spans is None:
        text = " ".join(tokens)
        spans = _find(text, tokens)
    return AnnotatedCommand(name, text, tuple(tokens), spans or (), tuple(frames))


def _find(text: str, tokens: Sequence[str]) -> Optional[Tuple[Tuple[int, int], ...]]:
    spans = []
    position = 0
    for token in tokens:
        start = text.find(token, position)
        if start < 0 or text[position:start].strip():
            return None
        position = start + len(token)
        spans.append((start, position))
    return None if text[position:].strip(" .!?,") else tuple(spans)


def positions_at(command: AnnotatedCommand, spans: Sequence[Tuple[int, int]]) -> FrozenSet[int]:
    """Return the positions, from 1, of the words of the command that overlap with some spans of its text."""
    return frozenset(
        position
        for position, (start, end) in enumerate(command.spans, start=1)
        if any(start < other_end and other_start < end for other_start, other_end in spans)
    )
