"""Finds what a command of the GPSR generators means in our frames, by the clauses of a mapping file."""

import os
import re
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Dict, FrozenSet, List, Mapping, Optional, Tuple

import yaml

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text
from frame_learning.gpsr_commands import DrawnCommand
from frame_learning.gpsr_grammar import Choice, Node, Reference, Slot, Word, read_expression
from frame_learning.gpsr_grammar import Sequence as InSequence
from offline_pipeline.knowledge import shipped_domains

_ELEMENT = re.compile(r"\[(?:(\d)\.)?([\w|]+)\s")
#: Marks the beginning of an element in an expression; a number follows.
_MARK = "@"


@dataclass(frozen=True)
class MeantElement:
    """An element that a command fills.

    Attributes:
        names: any of these names is right
        span: first and one past the last piece of the command
    """

    names: Tuple[str, ...]
    span: Tuple[int, int]


@dataclass(frozen=True)
class MeantFrame:
    """A frame that a command means; any of its names is right."""

    names: Tuple[str, ...]
    elements: Tuple[MeantElement, ...]


@dataclass(frozen=True)
class Meaning:
    """The frames of a command, in their order; ``asks``: something is missing, so that a question is right."""

    frames: Tuple[MeantFrame, ...]
    asks: bool


@dataclass(frozen=True)
class _Clause:
    pattern: "re.Pattern[str]"
    elements: Tuple[Tuple[int, Tuple[str, ...]], ...]
    frames: Tuple[Tuple[str, ...], ...]
    asks: bool


@dataclass(frozen=True)
class GpsrMapping:
    """What commands mean.

    Attributes:
        slot_rules: rules of the grammars whose words count as one slot
        types: FrameNet's semantic types by kind of slot; one of them is right
        words_left_out: words that do not count when words are compared, lower case
        performer: words for the robot; a unit may list them for the performer, lower case
        logical_forms: for each predicate of the published logical forms, the frames that carry it out
    """

    slot_rules: FrozenSet[str]
    types: Mapping[str, Tuple[str, ...]]
    words_left_out: FrozenSet[str]
    performer: FrozenSet[str]
    logical_forms: Mapping[str, FrozenSet[str]]
    _between: "re.Pattern[str]"
    _clauses: Tuple[_Clause, ...]

    @property
    def frame_names(self) -> FrozenSet[str]:
        """The frames that commands mean."""
        return frozenset(name for clause in self._clauses for names in clause.frames for name in names)

    def meanings(self, command: DrawnCommand) -> Tuple[Meaning, ...]:
        """Return what a command may mean; nothing if the mapping has no clauses for it.

        Clauses of the mapping that fit the same words are alternatives.
        """
        text, starts = _as_tokens(command)
        meanings: Tuple[Meaning, ...] = ()
        for number, fitting in enumerate(self._divide(text) or ()):
            alternatives = [_meant(clause, match, starts) for clause, match in fitting]
            before = meanings if number else (Meaning((), False),)
            meanings = tuple(
                Meaning(first.frames + second.frames, first.asks or second.asks)
                for first in before
                for second in alternatives
            )
        return meanings

    def _divide(self, text: str) -> "Optional[Tuple[_Fitting, ...]]":
        """Divide a command into clauses, the longest first; return the clauses that fit each part."""

        @lru_cache(maxsize=None)
        def rest(start: int) -> "Optional[Tuple[_Fitting, ...]]":
            between = self._between.match(text, start)
            here = between.end() if between is not None else start
            if here == len(text):
                return ()
            matches = [(clause, clause.pattern.match(text, here)) for clause in self._clauses]
            found = [(clause, match) for clause, match in matches if match is not None and match.end() > here]
            for end in sorted({match.end() for _, match in found}, reverse=True):
                behind = rest(end)
                if behind is not None:
                    return (tuple(pair for pair in found if pair[1].end() == end), *behind)
            return None

        return rest(0)


_Fitting = Tuple[Tuple[_Clause, "re.Match[str]"], ...]


def _meant(clause: _Clause, match: "re.Match[str]", starts: List[int]) -> Meaning:
    elements: Dict[int, List[MeantElement]] = {}
    for number, (step, names) in enumerate(clause.elements):
        first, last = match.span(f"e{number}")
        if 0 <= first < last:
            span = (_piece_at(starts, first), _piece_at(starts, last - 1) + 1)
            elements.setdefault(step, []).append(MeantElement(names, span))
    frames = tuple(
        MeantFrame(names, tuple(elements.get(step, ()))) for step, names in enumerate(clause.frames, start=1)
    )
    return Meaning(frames, clause.asks)


def _as_tokens(command: DrawnCommand) -> Tuple[str, List[int]]:
    """Return the command as tokens that each end with a blank, and where the tokens of each piece start."""
    text = ""
    starts = []
    for piece in command.pieces:
        starts.append(len(text))
        text += f"<{piece.kind}> " if piece.kind else f"{piece.text.lower()} "
    return text, starts


def _piece_at(starts: List[int], position: int) -> int:
    return max(number for number, start in enumerate(starts) if start <= position)


def load_gpsr_mapping() -> GpsrMapping:
    """Read the shipped mapping.

    Raises:
        FileRefused: the file is wrong
    """
    return read_gpsr_mapping(os.path.join(str(Path(shipped_domains()).parent), "corpora", "gpsr.yaml"))


def read_gpsr_mapping(path: str) -> GpsrMapping:
    """Read a mapping.

    Raises:
        FileRefused: the file cannot be read, or has another form
    """
    reader = Reader(path)
    root = reader.compose(read_text(path), "a mapping with clauses")
    entries = reader.mapping(
        root,
        "",
        (
            "slot_rules",
            "kinds",
            "types",
            "between",
            "words_left_out",
            "performer",
            "logical_forms",
            "macros",
            "clauses",
        ),
    )
    kinds = {
        name: reader.texts(node, f"kinds.{name}")
        for name, node in _pairs(reader, entries.get("kinds"), "kinds").items()
    }
    types = {
        name: reader.texts(node, f"types.{name}")
        for name, node in _pairs(reader, entries.get("types"), "types").items()
    }
    logical_forms = {
        name: frozenset(reader.texts(node, f"logical_forms.{name}"))
        for name, node in _pairs(reader, entries.get("logical_forms"), "logical_forms").items()
    }
    compiler = _Compiler(kinds)
    for name, node in _pairs(reader, entries.get("macros"), "macros").items():
        compiler.macros[name] = _expression(reader, node, f"macros.{name}")
    clauses = [
        clause
        for key, node in reader.sequence(entries.get("clauses"), "clauses")
        for clause in _clause(reader, compiler, node, key)
    ]
    between = _expression(reader, entries.get("between"), "between")
    reader.refuse_if_wrong()
    return GpsrMapping(
        slot_rules=frozenset(reader.texts(entries.get("slot_rules"), "slot_rules")),
        types=types,
        words_left_out=frozenset(reader.texts(entries.get("words_left_out"), "words_left_out")),
        performer=frozenset(reader.texts(entries.get("performer"), "performer")),
        logical_forms=logical_forms,
        _between=re.compile(f"(?:{compiler.pattern(between)})*"),
        _clauses=tuple(clauses),
    )


def _pairs(reader: Reader, node: Optional[yaml.Node], key: str) -> Dict[str, yaml.Node]:
    names = [str(name.value) for name, _ in node.value] if isinstance(node, yaml.MappingNode) else []
    return reader.mapping(node, key, names) if node is not None else {}


def _expression(reader: Reader, node: Optional[yaml.Node], key: str) -> Node:
    try:
        return read_expression(reader.text(node, key))
    except ValueError as error:
        if node is not None:
            reader.report("NOT_A_RULE", node, key, str(error), "words, {slots}, $macros and [elements]")
        return Word("")


def _clause(reader: Reader, compiler: "_Compiler", node: yaml.Node, key: str) -> List[_Clause]:
    entries = reader.mapping(node, key, ("said", "frames", "asks"))
    elements: List[Tuple[int, Tuple[str, ...]]] = []

    def mark(element: "re.Match[str]") -> str:
        elements.append((int(element.group(1) or 1), tuple(element.group(2).split("|"))))
        return f"({_MARK}{len(elements) - 1} ("

    marked = _ELEMENT.sub(mark, reader.text(entries.get("said"), f"{key}.said")).replace("]", "))")
    try:
        said = read_expression(marked)
    except ValueError as error:
        reader.report("NOT_A_RULE", node, f"{key}.said", str(error), "words, {slots}, $macros and [elements]")
        return []
    frames = reader.texts(entries.get("frames"), f"{key}.frames")
    asks = reader.boolean(entries.get("asks"), f"{key}.asks")
    try:
        pattern = compiler.pattern(said)
    except KeyError as error:
        reader.report("UNKNOWN_MACRO", node, f"{key}.said", str(error), "one of macros")
        return []
    return [
        _Clause(
            # A clause ends where another begins, or the command.
            re.compile(f"{pattern}(?={compiler.end}|$)"),
            tuple(elements),
            tuple(tuple(names.split("|")) for names in frames),
            asks,
        )
    ]


class _Compiler:
    """Makes regular expressions over tokens of clauses."""

    #: What may follow a clause.
    end = r", |\. |and |then |please "

    def __init__(self, kinds: Mapping[str, Tuple[str, ...]]) -> None:
        self._kinds = kinds
        self.macros: Dict[str, Node] = {}

    def pattern(self, node: Node) -> str:
        """
        Raises:
            KeyError: a macro is not defined
        """
        if isinstance(node, Word):
            return re.escape(node.text.lower()) + " "
        if isinstance(node, Slot):
            return f"<(?:{'|'.join(self._kinds.get(node.kind, (node.kind,)))})> "
        if isinstance(node, Reference):
            return self.pattern(self.macros[node.rule])
        if isinstance(node, Choice):
            return f"(?:{'|'.join(self.pattern(option) for option in node.options)})"
        assert isinstance(node, InSequence)
        first = node.items[0] if node.items else None
        if isinstance(first, Word) and first.text.startswith(_MARK):
            return f"(?P<e{first.text[1:]}>{''.join(self.pattern(item) for item in node.items[1:])})"
        return f"(?:{''.join(self.pattern(item) for item in node.items)})"
