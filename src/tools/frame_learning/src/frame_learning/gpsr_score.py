"""Compares what the system does for drawn commands with what they mean: frames, their order, and slots in elements."""

import re
from dataclasses import dataclass
from enum import Enum
from typing import Counter, Dict, FrozenSet, Iterable, List, Mapping, Sequence, Tuple

from frame_learning.gpsr_commands import DrawnCommand
from frame_learning.gpsr_meaning import GpsrMapping, Meaning, MeantElement, MeantFrame
from offline_pipeline.pipeline import Pipeline, Understanding
from semantic_framer.values.reading import Reading
from semantic_frames.semantic_type import with_parents
from typed_arguments import TypedArgument
from utterance_passes.trees.tree import DependencyTree
from word_classes import word_class

_WORD = re.compile(r"[\w'-]+")
_ARTICLES = word_class("articles") | {"some"}


class Verdict(Enum):
    """What became of a command.

    Attributes:
        RIGHT: the right frames in the right order, each slot in the right element with the right semantic type; or a
            question where something lacks
        WRONG: would be carried out with another frame, or with a slot in another element or none
        ASKED: leads to a question
        REFUSED: is refused
        UNMAPPED: the mapping has no meaning for it
    """

    RIGHT = "right"
    WRONG = "wrong"
    ASKED = "asked"
    REFUSED = "refused"
    UNMAPPED = "unmapped"


@dataclass(frozen=True)
class Judged:
    """A command, its verdict, and the cause if it is not right; names in the cause stand for slots: ``{name}``."""

    command: DrawnCommand
    verdict: Verdict
    cause: str = ""


def judge(pipeline: Pipeline, mapping: GpsrMapping, command: DrawnCommand) -> Judged:
    """Understand a command and compare the result with its meaning."""
    meanings = mapping.meanings(command)
    if not meanings:
        return Judged(command, Verdict.UNMAPPED, _with_slots(command, command.text))
    understanding = pipeline.understand_safely(command.text)
    outcome = understanding.reply.outcome
    asks = meanings[0].asks
    mistakes = [_mistake(mapping, command, meaning, understanding) for meaning in meanings]
    is_question = outcome == "NEEDS_INFORMATION"
    if "" in mistakes and (outcome == "DONE" or (asks and is_question)):
        return Judged(command, Verdict.RIGHT)
    if outcome == "DONE":
        return Judged(command, Verdict.WRONG, mistakes[0])
    verdict = Verdict.ASKED if is_question else Verdict.REFUSED
    # The sentence repeats the clause after what is not understood.
    said = understanding.reply.sentence.split('" in "')[0]
    return Judged(command, verdict, f"{understanding.reply.code}: {_with_slots(command, said)}")


def _mistake(mapping: GpsrMapping, command: DrawnCommand, meaning: Meaning, understanding: Understanding) -> str:
    """Return what is wrong with an understanding; empty if it is right."""
    names = [reading.unit.frame_name for reading in understanding.readings]
    wanted = ["|".join(frame.names) for frame in meaning.frames]
    if len(names) != len(wanted) or any(name not in frame.names for name, frame in zip(names, meaning.frames)):
        return f"frames: {', '.join(names) or 'none'} for {', '.join(wanted)}"
    tree = understanding.tree
    if tree is None:
        return "frames: none"
    words = _Words(mapping, command, tree)
    for reading, frame in zip(understanding.readings, meaning.frames):
        mistake = _mistake_in(words, reading, frame)
        if mistake:
            return _with_slots(command, f"{reading.unit.frame_name}: {mistake}")
    return ""


def _mistake_in(words: "_Words", reading: Reading, frame: MeantFrame) -> str:
    given = {value.name: words.of_value(value) for value in reading.arguments if value.positions}
    wanted: Dict[Tuple[str, ...], FrozenSet[int]] = {}
    for element in frame.elements:
        wanted[element.names] = wanted.get(element.names, frozenset()) | words.of_element(element)
    for names, expected in wanted.items():
        found = next((given.pop(name) for name in names if name in given), frozenset())
        if found != expected:
            lost = "lacks" if not found else f'has "{words.text(found)}" for'
            return f'{"|".join(names)} {lost} "{words.text(expected)}"'
    for name, found in given.items():
        if found and not words.are_performer(found):
            return f'{name} has "{words.text(found)}" for nothing'
    return _wrong_type(words, reading, frame) or _wrong_referent(words, reading, frame)


def _wrong_type(words: "_Words", reading: Reading, frame: MeantFrame) -> str:
    """Return the slot whose value has another semantic type than its kind; empty if there is none."""
    for element in frame.elements:
        wanted = words.semantic_types(element)
        value = next((value for value in reading.arguments if value.name in element.names), None)
        if not wanted or value is None or value.members:
            continue
        found = value.semantic_type
        if not found or not frozenset(wanted) & with_parents(found):
            return f'{value.name} "{value.text}" is a {found or "thing of no type"}, no {" or ".join(wanted)}'
    return ""


def _wrong_referent(words: "_Words", reading: Reading, frame: MeantFrame) -> str:
    """Return the pronoun that stands for something else than in the grammar; empty if there is none."""
    for element in frame.elements:
        referent = words.referent(element)
        value = next((value for value in reading.arguments if value.name in element.names), None)
        if not referent or value is None or words.is_as_said(value):
            continue
        if referent.lower() not in value.text.lower():
            return f'{value.name} "{value.head}" stands for "{value.text}", not for "{referent}"'
    return ""


class _Words:
    """The words of a command that count, by their position in its text."""

    def __init__(self, mapping: GpsrMapping, command: DrawnCommand, tree: DependencyTree) -> None:
        self._command = command
        self._tree = tree
        self._performer = mapping.performer
        self._types = mapping.types
        matches = list(_WORD.finditer(command.text))
        behind = [match.group().lower() for match in matches[1:]] + [""]
        # "Personal items" and "items" make "personal items items".
        self._words = {
            match.start(): match
            for match, following in zip(matches, behind)
            if match.group().lower() not in mapping.words_left_out | {following}
        }

    def of_element(self, element: MeantElement) -> FrozenSet[int]:
        first, last = element.span
        return self._between(self._command.spans[first][0], self._command.spans[last - 1][1])

    def is_as_said(self, value: TypedArgument) -> bool:
        return value.text.lower() in (self._tree.word(position).said for position in value.positions)

    def of_value(self, value: TypedArgument) -> FrozenSet[int]:
        found: FrozenSet[int] = frozenset()
        for position in value.positions:
            word = self._tree.word(position)
            found |= self._between(word.start_character, word.end_character)
        return found

    def _between(self, start: int, end: int) -> FrozenSet[int]:
        return frozenset(at for at, match in self._words.items() if at < end and start < match.end())

    def text(self, words: FrozenSet[int]) -> str:
        return " ".join(self._words[at].group() for at in sorted(words))

    def are_performer(self, words: FrozenSet[int]) -> bool:
        return all(self._words[at].group().lower() in self._performer for at in words)

    def semantic_types(self, element: MeantElement) -> Tuple[str, ...]:
        """Return the types of an element that is one slot, apart from articles; none for other elements."""
        pieces = self._command.pieces[element.span[0] : element.span[1]]
        kinds = [piece.kind for piece in pieces if piece.kind]
        words = [piece.text.lower() for piece in pieces if not piece.kind]
        is_slot = len(kinds) == 1 and frozenset(words) <= _ARTICLES
        return self._types.get(kinds[0], ()) if is_slot else ()

    def referent(self, element: MeantElement) -> str:
        """Return what the pronoun of an element stands for; empty if the element is no pronoun."""
        pieces = self._command.pieces[element.span[0] : element.span[1]]
        return pieces[0].referent if len(pieces) == 1 else ""


def _with_slots(command: DrawnCommand, text: str) -> str:
    """Return a text in which the slots of a command are named instead of filled, so that causes can be counted."""
    for piece in sorted((piece for piece in command.pieces if piece.kind), key=lambda piece: -len(piece.text)):
        text = re.sub(rf"\b{re.escape(piece.text)}(?!\w)", f"{{{piece.kind}}}", text, flags=re.IGNORECASE)
    return text


def by_category(judged: Iterable[Judged]) -> Mapping[str, Counter[Verdict]]:
    """Count the verdicts of each category: a grammar, and a grammar with a task."""
    found: Dict[str, Counter[Verdict]] = {}
    for item in judged:
        for category in (item.command.grammar, f"{item.command.grammar} {item.command.task}"):
            found.setdefault(category, Counter())[item.verdict] += 1
    return dict(sorted(found.items()))


def causes(judged: Iterable[Judged], verdicts: Sequence[Verdict]) -> List[Tuple[int, Verdict, str, str]]:
    """Return number, verdict, cause and an example of all failures, the most frequent first."""
    groups: Dict[Tuple[Verdict, str], List[Judged]] = {}
    for item in judged:
        if item.verdict in verdicts:
            groups.setdefault((item.verdict, item.cause), []).append(item)
    return sorted(
        ((len(items), verdict, cause, items[0].command.text) for (verdict, cause), items in groups.items()),
        key=lambda row: (verdicts.index(row[1]), -row[0], row[2]),
    )
