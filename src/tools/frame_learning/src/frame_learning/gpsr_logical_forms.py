"""Reads the logical forms that are published for some commands of the GPSR generators, and compares the mapping with
them: the forms are the generators' own account of what a command means."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterable, List, Mapping, Optional, Tuple

from frame_learning.annotated_commands import CorpusError
from frame_learning.gpsr_commands import DrawnCommand
from frame_learning.gpsr_grammar import Choice, Node, Reference, Slot, Word, find_grammars, read_expression
from frame_learning.gpsr_grammar import Sequence as InSequence
from frame_learning.gpsr_meaning import GpsrMapping, Meaning

_PREDICATE = re.compile(r"\((\w+)")


@dataclass(frozen=True)
class LogicalForm:
    """A published logical form, and the tokens of the commands that have it."""

    form: str
    pattern: "re.Pattern[str]"

    def predicates(self, known: Iterable[str]) -> Tuple[str, ...]:
        """Return those of some predicates that it has, in their order."""
        names = frozenset(known)
        return tuple(name for name in _PREDICATE.findall(self.form) if name in names)


def read_logical_forms(folder: str) -> Mapping[str, Tuple[LogicalForm, ...]]:
    """Read all logical forms (``X_semantics.txt``) below a folder, by the name of their grammar (``X_grammar.txt``).

    Raises:
        CorpusError: a file cannot be read
    """
    found: Dict[str, Tuple[LogicalForm, ...]] = {}
    for grammar in find_grammars(folder):
        path = Path(re.sub(r"_grammar\.txt$", "_semantics.txt", grammar.path))
        if str(path) != grammar.path and path.exists():
            found[grammar.name] = tuple(_read(path, grammar.rules))
    return found


def _read(path: Path, rules: Mapping[str, Tuple[Node, ...]]) -> List[LogicalForm]:
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise CorpusError(f"{path}: no logical forms: {error!r}") from error
    forms = []
    for line in lines:
        said, equals, form = line.partition(" = ")
        if not equals or line.lstrip().startswith("#"):
            continue
        try:
            pattern = re.compile(_pattern(read_expression(said), rules))
        except (ValueError, KeyError) as error:
            raise CorpusError(f"{path}: {line.strip()!r}: {error!r}") from error
        forms.append(LogicalForm(form.strip(), pattern))
    return forms


def _pattern(node: Node, rules: Mapping[str, Tuple[Node, ...]]) -> str:
    """Return a regular expression over the tokens of ``_tokens``."""
    if isinstance(node, Word):
        return re.escape(node.text.lower()) + " "
    if isinstance(node, Slot):
        if node.kind == "void":
            return ""
        kind = (node.restriction or node.kind) if node.kind == "location" else node.kind
        return "<category> " if node.is_obscured and kind == "object" else f"<{kind}> "
    if isinstance(node, Reference):
        options = rules[node.rule]
        return f"(?:{'|'.join(_pattern(option, rules) for option in options)})"
    if isinstance(node, Choice):
        return f"(?:{'|'.join(_pattern(option, rules) for option in node.options)})"
    assert isinstance(node, InSequence)
    return "".join(_pattern(item, rules) for item in node.items)


def _tokens(command: DrawnCommand, slot_rules: Iterable[str]) -> str:
    as_words = frozenset(slot_rules) - {"whattosay"}
    tokens = ""
    for piece in command.pieces:
        is_slot = piece.kind and piece.kind not in as_words
        tokens += f"<{piece.kind}> " if is_slot else "".join(f"{word.lower()} " for word in piece.text.split())
    return tokens


def find_logical_form(
    forms: Mapping[str, Tuple[LogicalForm, ...]], command: DrawnCommand, mapping: GpsrMapping
) -> Optional[LogicalForm]:
    """Return the logical form of a command; None if none is published."""
    tokens = _tokens(command, mapping.slot_rules)
    return next((form for form in forms.get(command.grammar, ()) if form.pattern.fullmatch(tokens)), None)


def agrees(form: LogicalForm, meaning: Meaning, mapping: GpsrMapping) -> bool:
    """Whether a meaning has a frame for each predicate of a logical form."""
    named = [frozenset(frame.names) for frame in meaning.frames]
    return all(
        any(names & mapping.logical_forms[predicate] for names in named)
        for predicate in form.predicates(mapping.logical_forms)
    )
