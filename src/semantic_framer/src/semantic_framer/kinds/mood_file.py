"""Reads the file of moods: rules that find the kind of a clause from the words before its verb."""

import re
from dataclasses import dataclass
from enum import Enum
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Dict, FrozenSet, Mapping, Optional, Pattern, Tuple

import yaml

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text
from word_classes import fill_pattern, read_pattern

#: Next to this module in the source, devel and install space.
MOODS_FILE = Path(__file__).resolve().parent / "moods.yaml"
_WORD = re.compile(r"[a-z]+")
_SECTIONS = ("spellings", "parts", "acting", "telling")
_KEYS = ("name", "kind", "pattern", "example")


class UtteranceKind(Enum):
    """The purpose of an utterance.

    Cries are found earlier (``command_server.stop_words``), corrections later: only what cannot be carried out as it
    was said may correct what runs (``semantic_framer.changing.objections``).
    """

    COMMAND = "command"
    REQUEST = "request"  # "could you ..."
    QUESTION = "question"
    REPORT = "report"  # of an event or a state
    WISH = "wish"  # to do something oneself: "I want to go home"
    PROHIBITION = "prohibition"
    CORRECTION = "correction"  # "no, the office"
    ANSWER = "answer"  # no clause: "two feet"
    TALK = "talk"


_KINDS = tuple(kind.value for kind in UtteranceKind)


@dataclass(frozen=True)
class MoodRule:
    """A pattern of the words before a verb, and the kind of clause that they make.

    Attributes:
        name: the name in the trace
        kind: the kind of the clause
        pattern: matches formula words
        example: formula words that match
        is_fact: whether the clause describes a present state
    """

    name: str
    kind: UtteranceKind
    pattern: Pattern[str]
    example: str
    is_fact: bool = False


@dataclass(frozen=True)
class Moods:
    """The content of the file.

    Attributes:
        spellings: the full form of each short form: "not" for "n't"
        acting: rules for clauses that ask for something to be done
        telling: rules for the others
    """

    spellings: Mapping[str, str]
    acting: Tuple[MoodRule, ...]
    telling: Tuple[MoodRule, ...]

    @cached_property
    def words(self) -> FrozenSet[str]:
        """The words of the patterns; a small word that stands in none of them says nothing of a mood."""
        return frozenset(_WORD.findall(" ".join(rule.pattern.pattern for rule in (*self.acting, *self.telling))))


def load_moods(text: str, path: str) -> Moods:
    """Read a file of moods.

    Args:
        text: content of the file
        path: path of the file, for problems
    Raises:
        FileRefused: the file is wrong; it lists every mistake
    """
    reader = Reader(path)
    sections = reader.mapping(reader.compose(text, "a mapping of rules"), "", _SECTIONS, required=_SECTIONS)
    spellings: Dict[str, str] = {}
    parts: Dict[str, str] = {}
    for full_node, node in reader.free_mapping(sections.get("spellings"), "spellings"):
        full = reader.name(full_node, "spellings")
        spellings.update({reader.name(item, key): full for key, item in reader.sequence(node, f"spellings.{full}")})
    for name_node, node in reader.free_mapping(sections.get("parts"), "parts"):
        name = reader.name(name_node, "parts")
        parts[name] = f"(?:{fill_pattern(reader, node, f'parts.{name}', parts)})"
    acting, telling = (_rules(reader, sections.get(name), name, parts) for name in ("acting", "telling"))
    reader.refuse_if_wrong()
    return Moods(spellings, acting, telling)


def _rules(reader: Reader, node: Optional[yaml.Node], section: str, parts: Mapping[str, str]) -> Tuple[MoodRule, ...]:
    rules = []
    for key, item in reader.sequence(node, section):
        entries = reader.mapping(item, key, (*_KEYS, "is_fact"), required=_KEYS)
        kind = reader.choice(entries.get("kind"), f"{key}.kind", _KINDS, UtteranceKind.TALK.value)
        is_fact = reader.boolean(entries.get("is_fact"), f"{key}.is_fact")
        name, example = (reader.name(entries.get(name), f"{key}.{name}") for name in ("name", "example"))
        if "pattern" in entries:
            pattern = read_pattern(reader, entries["pattern"], f"{key}.pattern", parts)
            rules.append(MoodRule(name, UtteranceKind(kind), pattern, example, is_fact))
    return tuple(rules)


@lru_cache(maxsize=None)
def shipped_moods() -> Moods:
    """Return the moods of ``moods.yaml``, read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_moods(read_text(str(MOODS_FILE)), str(MOODS_FILE))
