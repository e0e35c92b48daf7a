"""Sentences for training: compact files, labels, batches, and speech without marks."""

import json
import lzma
import random
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Dict, Iterable, Iterator, List, Sequence, Tuple

from command_models.conllu import Sentence
from stanford_parser_ros.joint.pieces import PieceVocabulary

COLUMNS = ("form", "upos", "xpos", "feats", "head", "deprel")
#: Label that is not learnt.
IGNORED = -100


@dataclass(frozen=True, eq=False)
class Example:
    """A sentence: a tuple for each column, heads counted from 1; ``source`` names where it is from.

    Two are equal only if they are the same object, so that looking one up costs no time.
    """

    source: str
    form: Tuple[str, ...]
    upos: Tuple[str, ...]
    xpos: Tuple[str, ...]
    feats: Tuple[str, ...]
    head: Tuple[int, ...]
    deprel: Tuple[str, ...]


def example(sentence: Sentence, source: str) -> Example:
    """Return a sentence as an example."""
    return Example(source, *(tuple(getattr(word, column) for word in sentence.words) for column in COLUMNS))


def write_examples(path: Path, examples: Iterable[Example]) -> None:
    """Write examples to a compressed file."""
    with lzma.open(path, "wt", encoding="utf-8") as stream:
        for one in examples:
            stream.write(json.dumps([one.source, *(getattr(one, column) for column in COLUMNS)]) + "\n")


def read_examples(path: Path) -> List[Example]:
    """Read what :func:`write_examples` wrote."""
    with lzma.open(path, "rt", encoding="utf-8") as stream:
        return [Example(row[0], *map(tuple, row[1:])) for row in map(json.loads, stream)]


def as_spoken(one: Example) -> Example:
    """Return a sentence as it is heard: in lower case, without the marks that govern nothing."""
    governs = set(one.head)
    kept = [n for n in range(len(one.form)) if one.upos[n] not in ("PUNCT", "SYM") or n + 1 in governs]
    if not kept or len(kept) > 60:
        return one
    moved = {old + 1: new for new, old in enumerate(kept, 1)}
    moved[0] = 0
    columns: Dict[str, Any] = {column: tuple(getattr(one, column)[n] for n in kept) for column in COLUMNS}
    columns["head"] = tuple(moved[head] for head in columns["head"])
    columns["form"] = tuple(form.lower() for form in columns["form"])
    return replace(one, **columns)


@dataclass(frozen=True)
class Labels:
    """The labels of each kind, by their numbers."""

    upos: Tuple[str, ...]
    xpos: Tuple[str, ...]
    feats: Tuple[str, ...]
    deprel: Tuple[str, ...]

    @classmethod
    def of(cls, examples: Sequence[Example]) -> "Labels":
        """Collect the labels of sentences."""
        found = []
        for column in ("upos", "xpos", "feats", "deprel"):
            found.append(tuple(sorted({label for one in examples for label in getattr(one, column)})))
        return cls(*found)

    def as_json(self) -> Dict[str, List[str]]:
        return {column: list(getattr(self, column)) for column in ("upos", "xpos", "feats", "deprel")}


class Batches:
    """Makes batches of tensors."""

    def __init__(self, vocabulary: PieceVocabulary, labels: Labels, *, pooling: str, device: str) -> None:
        self._vocabulary, self._pooling, self._device = vocabulary, pooling, device
        self._numbers = {
            column: {label: n for n, label in enumerate(getattr(labels, column))}
            for column in ("upos", "xpos", "feats", "deprel")
        }
        self._kept: Dict[Example, Any] = {}

    def _prepared(self, one: Example) -> Any:
        found = self._kept.get(one)
        if found is None:
            pieces = self._vocabulary.of_sentence(one.form)
            tags = {
                column: [self._numbers[column].get(label, IGNORED) for label in getattr(one, column)]
                for column in ("upos", "xpos", "deprel")
            }
            # Only the written treebank has features that are right.
            tags["feats"] = [
                self._numbers["feats"].get(label, IGNORED) if one.source == "ewt" else IGNORED for label in one.feats
            ]
            found = self._kept[one] = (pieces, tags, list(one.head))
        return found

    def length(self, one: Example) -> int:
        """Return the number of pieces of a sentence."""
        return len(self._prepared(one)[0].numbers)

    def batch(self, examples: Sequence[Example]) -> Dict[str, Any]:
        """Return the tensors of some sentences."""
        import torch

        rows = [self._prepared(one) for one in examples]
        length = max(len(pieces.numbers) for pieces, _, _ in rows)
        words = max(len(heads) for _, _, heads in rows)
        count = len(rows)
        numbers = torch.zeros(count, length, dtype=torch.long)
        shapes = torch.zeros(count, length, dtype=torch.long)
        pool = torch.zeros(count, words + 1, length)
        bias = torch.zeros(count, 1, 1, length)
        tensors = {
            column: torch.full((count, words), IGNORED, dtype=torch.long)
            for column in ("upos", "xpos", "feats", "deprel", "head")
        }
        no_head = torch.zeros(count, 1, words + 1, dtype=torch.bool)
        for row, (pieces, tags, heads) in enumerate(rows):
            size = len(pieces.numbers)
            numbers[row, :size] = torch.tensor(pieces.numbers)
            shapes[row, :size] = torch.tensor(pieces.shapes)
            bias[row, :, :, size:] = -1e4
            pool[row, 0, 0] = 1.0
            ends = [*pieces.first[1:], size - 1]
            for word, (start, end) in enumerate(zip(pieces.first, ends), 1):
                if self._pooling == "first":
                    pool[row, word, start] = 1.0
                else:
                    pool[row, word, start:end] = 1.0 / (end - start)
            for column, values in tags.items():
                tensors[column][row, : len(values)] = torch.tensor(values)
            tensors["head"][row, : len(heads)] = torch.tensor(heads)
            no_head[row, 0, len(heads) + 1 :] = True
        tensors.update(numbers=numbers, shapes=shapes, pool=pool, bias=bias, no_head=no_head)
        return {name: tensor.to(self._device, non_blocking=True) for name, tensor in tensors.items()}

    def epoch(self, examples: Sequence[Example], pieces: int, chooser: random.Random) -> Iterator[List[Example]]:
        """Return lists of sentences of like length, of about so many pieces, in an order that is drawn."""
        order = sorted(examples, key=lambda one: self.length(one) + chooser.random() * 4)
        lists: List[List[Example]] = [[]]
        longest = 0
        for one in order:
            size = self.length(one)
            longest = max(longest, size)
            if lists[-1] and longest * (len(lists[-1]) + 1) > pieces:
                lists.append([])
                longest = size
            lists[-1].append(one)
        chooser.shuffle(lists)
        return iter(lists)
