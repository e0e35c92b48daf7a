"""Recorded answers of the parser's models, so that tests run the passes for real and load no models."""

import os
from pathlib import Path
from typing import Dict, Mapping, Protocol, Sequence, Tuple

from utterance_passes.trees.conllu import from_conllu, to_conllu
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.vocabulary import NamedWord

RECORDING = Path(os.path.realpath(__file__)).parents[2] / "recorded" / "parses.conllu"
#: Comment of a parse by the words that units name: the fields of each ``NamedWord``.
_NAMED_WORDS = "# named words = "
_HEAD = "# newdoc id = answers of the parser's models; 'make record' writes this file\n"

#: A text, and for a second parse the fields of the words that units name.
Key = Tuple[str, Tuple[Tuple[str, ...], ...]]


class NotRecorded(BaseException):
    """The models' answer is not in the recording; the message names the command that records it.

    It is no ``Exception``: no boundary of the code under test may turn it into a reply.
    """


class Models(Protocol):
    """What can be recorded: ``stanford_parser_ros.inference.Inference`` is this."""

    def parse(self, text: str) -> DependencyTree:
        """Tag and parse a text."""

    def with_named_words(self, tree: DependencyTree, named: Sequence[NamedWord]) -> DependencyTree:
        """Parse words again by the words that units name."""


def key_of_text(text: str) -> Key:
    """Return the key of a first parse."""
    return text, ()


def key_of_named_words(tree: DependencyTree, named: Sequence[NamedWord]) -> Key:
    """Return the key of a parse by the words that units name."""
    return tree.text, tuple(tuple(str(int(field)) for field in one) for one in named)


def named_words_of(key: Key) -> Tuple[NamedWord, ...]:
    """Return the words of a key that units name; none for a first parse."""
    words = (tuple(map(int, one)) for one in key[1])
    return tuple(NamedWord(word, length, noun, verb, bool(kind)) for word, length, noun, verb, kind in words)


def _key_of_block(block: str, tree: DependencyTree) -> Key:
    for line in block.split("\n"):
        if line.startswith(_NAMED_WORDS):
            return tree.text, tuple(tuple(one.split()) for one in line[len(_NAMED_WORDS) :].split(";"))
    return key_of_text(tree.text)


def read_recording(text: str) -> Dict[Key, DependencyTree]:
    """Read recorded parses.

    Raises:
        ValueError: a block is no sentence in CoNLL-U
    """
    found: Dict[Key, DependencyTree] = {}
    for block in text.split("\n\n"):
        if block.strip():
            tree = from_conllu(block)
            found[_key_of_block(block, tree)] = tree
    return found


def render_recording(parses: Mapping[Key, DependencyTree]) -> str:
    """Write recorded parses: the same parses give the same text, whatever their order."""
    blocks = []
    for key in sorted(parses):
        block = to_conllu(parses[key])
        if key[1]:
            text, words = block.split("\n", 1)
            block = f"{text}\n{_NAMED_WORDS}{'; '.join(map(' '.join, key[1]))}\n{words}"
        blocks.append(block)
    return _HEAD + "\n".join(blocks)


def read_shipped_recording() -> Dict[Key, DependencyTree]:
    """Return what ``make record`` has recorded; nothing before its first run."""
    return read_recording(RECORDING.read_text(encoding="utf-8")) if RECORDING.exists() else {}


class RecordedInference:
    """Answers from a recording, in the place of the models."""

    def __init__(self, parses: Mapping[Key, DependencyTree]) -> None:
        self._parses = parses

    def parse(self, text: str) -> DependencyTree:
        """Return the recorded parse of a text.

        Raises:
            NotRecorded: there is none
        """
        return self._recorded(key_of_text(text), "")

    def with_named_words(self, tree: DependencyTree, named: Sequence[NamedWord]) -> DependencyTree:
        """Return the recorded parse by the words that units name.

        Raises:
            NotRecorded: there is none
        """
        said = ", ".join(tree.word(one.word).form for one in named)
        return self._recorded(key_of_named_words(tree, named), f" with the named words {said}")

    def _recorded(self, key: Key, how: str) -> DependencyTree:
        try:
            return self._parses[key]
        except KeyError:
            raise NotRecorded(
                f"no parse of {key[0]!r}{how} is recorded: 'make record' asks the models, and records what they say"
            ) from None


class RecordingInference:
    """Asks the models once for each answer, and keeps it."""

    def __init__(self, models: Models, known: Mapping[Key, DependencyTree]) -> None:
        """
        Args:
            models: who is asked
            known: answers that are kept without asking
        """
        self._models = models
        self.parses: Dict[Key, DependencyTree] = dict(known)

    def parse(self, text: str) -> DependencyTree:
        """Return the parse of a text, and keep it."""
        key = key_of_text(text)
        if key not in self.parses:
            self.parses[key] = self._models.parse(text)
        return self.parses[key]

    def with_named_words(self, tree: DependencyTree, named: Sequence[NamedWord]) -> DependencyTree:
        """Return the parse by the words that units name, and keep it."""
        key = key_of_named_words(tree, named)
        if key not in self.parses:
            self.parses[key] = self._models.with_named_words(tree, named)
        return self.parses[key]
