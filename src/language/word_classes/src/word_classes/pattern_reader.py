"""Patterns in files: regular expressions in which ``<name>`` stands for any word of a class."""

import re
from types import MappingProxyType
from typing import Iterable, Mapping, Pattern

import yaml

from checked_files.marked_yaml import Reader, did_you_mean
from word_classes.shipped import word_class, word_classes

#: Not the name of a group, "(?P<name>...)".
_NAME = re.compile(r"(?<!\?P)<(\w+)>")
_NO_PARTS: Mapping[str, str] = MappingProxyType({})


def read_pattern(reader: Reader, node: yaml.Node, key: str, parts: Mapping[str, str] = _NO_PARTS) -> Pattern[str]:
    """Read a pattern; a mistake is reported to the reader, and the pattern is empty then.

    Args:
        reader: of the file
        node: with the pattern
        key: of the node, for problems
        parts: patterns by name that ``<name>`` may stand for as well
    """
    try:
        return re.compile(fill_pattern(reader, node, key, parts))
    except re.error as error:
        found = reader.name(node, key)
        reader.report("BAD_PATTERN", node, key, f"'{found}'", "a regular expression", str(error))
        return re.compile("")


def fill_pattern(reader: Reader, node: yaml.Node, key: str, parts: Mapping[str, str] = _NO_PARTS) -> str:
    """Return the text of a pattern with the parts and the words of the classes that it names."""
    text = reader.name(node, key)
    known = {**dict.fromkeys(word_classes(), ""), **parts}
    for name in _NAME.findall(text):
        if name not in known:
            hint = did_you_mean(name, known)
            reader.report("UNKNOWN_CLASS", node, key, f"'{name}'", "the name of a word class", hint)
            return ""
    return _NAME.sub(lambda match: parts.get(match[1]) or _any_of(word_class(match[1])), text)


def _any_of(words: Iterable[str]) -> str:
    return f"(?:{'|'.join(map(re.escape, sorted(words)))})"
