"""Reads the file of word classes: the purpose and the words of each class, and the classes that it includes."""

from dataclasses import dataclass
from typing import Dict, List, Mapping, Optional, Set, Tuple

import yaml

from checked_files.marked_yaml import Reader, did_you_mean, line_of

KEYS = ("for", "includes", "words")


@dataclass(frozen=True)
class WordClass:
    """A class of words.

    Attributes:
        name: name of the class
        purpose: one sentence
        words: in lower case, those of included classes first; an entry of several words is a phrase, "next to"
    """

    name: str
    purpose: str
    words: Tuple[str, ...]


@dataclass(frozen=True)
class _Entry:
    """A class as it is written: included classes and its own words, each with its node."""

    name: yaml.Node
    purpose: str
    includes: Tuple[Tuple[str, yaml.Node], ...]
    own: Tuple[Tuple[str, yaml.Node], ...]


def load_word_classes(text: str, path: str) -> Mapping[str, WordClass]:
    """Read a file of word classes.

    Args:
        text: content of the file
        path: where it came from, for problems
    Returns:
        the classes by name
    Raises:
        FileRefused: the file has mistakes; the exception carries all of them
    """
    reader = Reader(path)
    root = reader.compose(text, "a mapping of word classes")
    entries = _entries(reader, root)
    reader.refuse_if_wrong()
    _check_inclusion(reader, entries)
    reader.refuse_if_wrong()
    words = {name: _words(reader, name, entries) for name in entries}
    first: Dict[Tuple[str, ...], str] = {}
    for name, found in words.items():
        same = first.setdefault(tuple(sorted(found)), name)
        if same != name:
            node = entries[name].name
            reader.report("SAME_WORDS", node, name, f"the words of '{same}'", "words of its own", "use one")
    reader.refuse_if_wrong()
    return {name: WordClass(name, entry.purpose, words[name]) for name, entry in entries.items()}


def _entries(reader: Reader, root: yaml.Node) -> Dict[str, _Entry]:
    entries: Dict[str, _Entry] = {}
    for name_node, node in root.value if isinstance(root, yaml.MappingNode) else ():
        name = reader.name(name_node, "class")
        keys = reader.mapping(node, name, KEYS, required=("for",))
        if name in entries:
            first = line_of(entries[name].name)
            expected = f"one, the first is in line {first}"
            reader.report("DUPLICATE_CLASS", name_node, name, f"a second '{name}'", expected)
            continue
        included = reader.sequence(keys.get("includes"), f"{name}.includes")
        entry = _Entry(
            name=name_node,
            purpose=reader.name(keys.get("for"), f"{name}.for"),
            includes=tuple((reader.name(item, key), item) for key, item in included),
            own=_own_words(reader, keys.get("words"), f"{name}.words"),
        )
        if not entry.own and len(entry.includes) < 2 and isinstance(node, yaml.MappingNode):
            reader.report("EMPTY_CLASS", name_node, name, "no words of its own", "words, or two classes to include")
        entries[name] = entry
    if not isinstance(root, yaml.MappingNode):
        reader.mapping(root, "", ("name",))
    return entries


def _own_words(reader: Reader, node: Optional[yaml.Node], key: str) -> Tuple[Tuple[str, yaml.Node], ...]:
    """Return the words of a text, or the entries of a list, which may be phrases."""
    found: List[Tuple[str, yaml.Node]] = []
    if isinstance(node, yaml.ScalarNode):
        found = [(word, node) for word in reader.text(node, key).split()]
    else:
        for item_key, item in reader.sequence(node, key):
            found.append((" ".join(reader.name(item, item_key).split()), item))
    seen: Set[str] = set()
    for word, item in found:
        if word != word.lower():
            reader.report("NOT_LOWER_CASE", item, key, f"'{word}'", f"'{word.lower()}'")
        if word in seen:
            reader.report("DUPLICATE_WORD", item, key, f"a second '{word}'", "each word once")
        seen.add(word)
    return tuple(found)


def _check_inclusion(reader: Reader, entries: Mapping[str, _Entry]) -> None:
    """Report unknown classes and cycles."""
    for name, entry in entries.items():
        for other, node in entry.includes:
            if other not in entries:
                hint = did_you_mean(other, entries)
                reader.report("UNKNOWN_CLASS", node, f"{name}.includes", f"'{other}'", "the name of a class", hint)
            elif _reaches(entries, other, name):
                reader.report("CIRCLE", node, f"{name}.includes", f"'{other}', which includes '{name}'", "no circle")


def _reaches(entries: Mapping[str, _Entry], start: str, goal: str) -> bool:
    seen: Set[str] = set()
    pending = [start]
    while pending:
        name = pending.pop()
        if name == goal:
            return True
        if name in entries and name not in seen:
            seen.add(name)
            pending += [other for other, _ in entries[name].includes]
    return False


def _words(reader: Reader, name: str, entries: Mapping[str, _Entry]) -> Tuple[str, ...]:
    """Return the words of a class, those of included classes first; its own words must be new."""
    entry = entries[name]
    found: Dict[str, str] = {}
    for other, _ in entry.includes:
        for word in _words(Reader(reader.path), other, entries):
            found.setdefault(word, other)
    for word, node in entry.own:
        if word in found:
            expected = f"none, '{found[word]}' has it"
            reader.report("DUPLICATE_WORD", node, f"{name}.words", f"'{word}'", expected)
        found.setdefault(word, name)
    return tuple(found)
