"""Reads the grammars of the command generators of RoboCup@Home (GPSR, EGPSR), in the format of GPSRCmdGen.

The format has no library: a slot holds free text after ``meta:``, with brackets and quotes that need not match, so a
grammar of tokens does not fit it.
"""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Mapping, Optional, Tuple, Union

from frame_learning.annotated_commands import CorpusError

#: The rule that a grammar starts with.
MAIN = "Main"
_COMMENT = re.compile(r"^\s*(?:[#;%]|//)")
_IMPORT = re.compile(r"^\s*;\s*(?:import|load)\s+\"?([^\"\s]+)\"?\s*$")
_RULE = re.compile(r"^\s*\$(\w+)\s*=(.*)$")
_WORD = re.compile(r"[^\s(){}|$,.]+")
_RULE_NAME = re.compile(r"\$(\w+)")
_CONDITION = re.compile(r"(\w+)\s*(!?=)\s*(\"[^\"]*\"|\w+)")
#: Slots with a short name: kind, and restriction.
_SHORT_SLOTS: Mapping[str, Tuple[str, str]] = {
    "aobject": ("object", "alike"),
    "kobject": ("object", "known"),
    "sobject": ("object", "special"),
    "beacon": ("location", "beacon"),
    "placement": ("location", "placement"),
    "room": ("location", "room"),
    "female": ("name", "female"),
    "male": ("name", "male"),
}


@dataclass(frozen=True)
class Word:
    """A word, a comma or a full stop."""

    text: str


@dataclass(frozen=True)
class Reference:
    """The place of another rule: ``$vbfind``."""

    rule: str


@dataclass(frozen=True)
class Slot:
    """A place that the generator fills with a value: ``{object 1 where Category="food"}``.

    Attributes:
        kind: name, location, object, category, gesture, question, whattosay, pron or void
        restriction: beacon, placement or room; known, alike or special; male or female; sub, pos ...; or empty
        number: slots of one kind with one number have one value; empty for a value of its own
        is_obscured: whether the value is replaced by its category or room: ``{object?}``
        conditions: property, "=" or "!=", and value
    """

    kind: str
    restriction: str = ""
    number: str = ""
    is_obscured: bool = False
    conditions: Tuple[Tuple[str, str, str], ...] = ()


@dataclass(frozen=True)
class Sequence:
    """Items one after the other."""

    items: Tuple["Node", ...]


@dataclass(frozen=True)
class Choice:
    """One of several options."""

    options: Tuple["Node", ...]


Node = Union[Word, Reference, Slot, Sequence, Choice]


@dataclass(frozen=True)
class Grammar:
    """The rules of a file, with those that it imports.

    Attributes:
        name: of its folder and file, for people
        path: of its file
        rules: the right sides of each rule
        undefined: rules that are named and not defined; what needs them is never drawn
    """

    name: str
    path: str
    rules: Mapping[str, Tuple[Node, ...]]
    undefined: Tuple[str, ...] = ()


def find_grammars(folder: str) -> Tuple[Grammar, ...]:
    """Read all grammars below a folder that have a main rule.

    Raises:
        CorpusError: there is none, or one of them cannot be read
    """
    found = []
    for path in sorted(Path(folder).rglob("*.txt")):
        if any(re.match(rf"\s*\${MAIN}\s*=", line) for line in _lines(path)):
            found.append(read_grammar(path))
    if not found:
        raise CorpusError(f"{folder}: no *.txt file with a rule $Main; expected generator grammars")
    return tuple(found)


def read_grammar(path: Path) -> Grammar:
    """Read a grammar and what it imports; rules that it does not define are taken from the common rules beside it.

    Raises:
        CorpusError: a file cannot be read, or a rule has brackets that do not match
    """
    rules: Dict[str, List[Node]] = {}
    imports = _read_into(rules, path)
    for name in imports:
        beside = _imported(path.parent, name)
        if beside is None:
            raise CorpusError(f"{path}: imports {name}, which is not beside it")
        _read_into(rules, beside, without=MAIN)
    common = _imported(path.parent, "common.txt")
    if not imports and common is not None:
        others: Dict[str, List[Node]] = {}
        _read_into(others, common, without=MAIN)
        rules.update({name: options for name, options in others.items() if name not in rules})
    used = {name for options in rules.values() for option in options for name in _references(option)}
    return Grammar(
        name=f"{path.parent.parent.name if path.parent.name == 'Resources' else path.parent.name}/{path.stem}",
        path=str(path),
        rules={name: tuple(options) for name, options in rules.items()},
        undefined=tuple(sorted(used - set(rules))),
    )


def _lines(path: Path) -> List[str]:
    try:
        return path.read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise CorpusError(f"{path}: no grammar: {error!r}") from error


def _imported(folder: Path, name: str) -> Optional[Path]:
    """Find an imported file. The published folders name ``common.txt`` otherwise ("common_rules.txt",
    "CommonRules.txt")."""
    stem = Path(name).stem.lower()
    names = (stem, f"{stem}rules")
    return next(
        (path for path in sorted(folder.glob("*.txt")) if path.stem.lower().replace("_", "") in names),
        None,
    )


def _read_into(rules: Dict[str, List[Node]], path: Path, without: str = "") -> List[str]:
    """Add the rules of a file; return what it imports."""
    imports = []
    for number, line in enumerate(_lines(path), start=1):
        imported = _IMPORT.match(line)
        rule = _RULE.match(line)
        if imported is not None:
            imports.append(imported.group(1))
        elif rule is not None and not _COMMENT.match(line) and rule.group(1) != without:
            try:
                rules.setdefault(rule.group(1), []).extend(options_of(read_expression(rule.group(2))))
            except ValueError as error:
                raise CorpusError(f"{path}:{number}: {error}") from error
    return imports


def options_of(node: Node) -> Tuple[Node, ...]:
    """Return the options of a choice, or the node itself."""
    return node.options if isinstance(node, Choice) else (node,)


def read_expression(text: str) -> Node:
    """Read the right side of a rule.

    Raises:
        ValueError: brackets do not match
    """
    node, end = _choice(text, 0)
    if end < len(text):
        raise ValueError(f"unexpected {text[end:]!r}")
    return node


def _choice(text: str, start: int) -> Tuple[Node, int]:
    options = []
    while True:
        node, start = _sequence(text, start)
        options.append(node)
        if start >= len(text) or text[start] != "|":
            return (Choice(tuple(options)) if len(options) > 1 else options[0]), start
        start += 1


def _sequence(text: str, start: int) -> Tuple[Node, int]:
    items: List[Node] = []
    while start < len(text) and text[start] not in "|)":
        character = text[start]
        if character.isspace():
            start += 1
        elif character == "(":
            node, start = _choice(text, start + 1)
            if start >= len(text):
                raise ValueError(f"a bracket is not closed: {text.strip()!r}")
            items.append(node)
            start += 1
        elif character == "{":
            end = _end_of_braces(text, start)
            items.append(read_slot(text[start + 1 : end - 1]))
            start = end
        elif character == "$":
            name = _RULE_NAME.match(text, start)
            if name is None:
                raise ValueError(f"a rule without a name: {text[start:]!r}")
            items.append(Reference(name.group(1)))
            start = name.end()
        else:
            word = _WORD.match(text, start)
            items.append(Word(word.group() if word is not None else character))
            start = word.end() if word is not None else start + 1
    return (items[0] if len(items) == 1 else Sequence(tuple(items))), start


def _end_of_braces(text: str, start: int) -> int:
    depth = 0
    for position in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[position], 0)
        if depth == 0:
            return position + 1
    raise ValueError(f"a brace is not closed: {text[start:]!r}")


def read_slot(text: str) -> Slot:
    """Read what is inside the braces of a slot; what follows ``meta:`` is for the referee."""
    text = text.split("meta:", 1)[0]
    named, _, conditions = text.partition(" where ")
    words = named.replace("?", " ? ").split()
    if not words:
        raise ValueError("a slot without a kind")
    is_obscured = "?" in words
    kind, restriction = _SHORT_SLOTS.get(words[0], (words[0], ""))
    for word in words[1:]:
        if word.isalpha():
            kind, restriction = _SHORT_SLOTS.get(word, (kind, word)) if kind == "location" else (kind, word)
    return Slot(
        kind=kind,
        restriction=restriction,
        number=next((word for word in words if word.isdigit()), ""),
        is_obscured=is_obscured,
        conditions=tuple(
            (match.group(1), match.group(2), match.group(3).strip('"')) for match in _CONDITION.finditer(conditions)
        ),
    )


def _references(node: Node) -> Tuple[str, ...]:
    if isinstance(node, Reference):
        return (node.rule,)
    if isinstance(node, Sequence):
        return tuple(name for item in node.items for name in _references(item))
    if isinstance(node, Choice):
        return tuple(name for option in node.options for name in _references(option))
    return ()
