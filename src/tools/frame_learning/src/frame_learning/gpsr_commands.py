"""Draws commands from generator grammars; each command knows which slots the grammar filled, and with what."""

import random
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, FrozenSet, Iterator, List, Optional, Sequence, Set, Tuple

from frame_learning.gpsr_grammar import MAIN, Choice, Grammar, Node, Reference, Slot, Word, find_grammars
from frame_learning.gpsr_grammar import Sequence as InSequence
from frame_learning.gpsr_world import Value, World, read_world

#: Attempts to draw a command that no other has the text of.
_ATTEMPTS = 50
#: Rules that every command of a grammar comes from, and what is said around a command.
_NO_TASKS = frozenset([MAIN, "main", "pmain", "task", "ptask", "cat3", "pcat3", "polite", "please"])
_OBJECTIVE = {"male": "him", "female": "her", "": "it"}
_SUBJECTIVE = {"male": "he", "female": "she", "": "it"}
_POSSESSIVE = {"male": "his", "female": "her", "": "its"}
_OTHER_FORMS = {"sub": _SUBJECTIVE, "pos": _POSSESSIVE, "paj": _POSSESSIVE, "posadj": _POSSESSIVE}


@dataclass(frozen=True)
class Piece:
    """A part of a command: a word of the grammar, or a filled slot.

    Attributes:
        text: as it is said
        kind: of the slot: name, room, beacon, placement, location, object, category, gesture, question, whattosay,
            pron, or the name of a rule that counts as a slot; empty for a word
        referent: for a pronoun: the text of the slot that it stands for
    """

    text: str
    kind: str = ""
    referent: str = ""


@dataclass(frozen=True)
class DrawnCommand:
    """A command that a grammar generates.

    Attributes:
        grammar: its name
        task: the rule that the command comes from, "deliver"
        text: as it is said
        pieces: the words and slots
        spans: first and one past the last character of each piece in the text
    """

    grammar: str
    task: str
    text: str
    pieces: Tuple[Piece, ...]
    spans: Tuple[Tuple[int, int], ...]


class _NothingFits(Exception):
    """No value fits a slot, or a rule is not defined."""


def draw_commands(folder: str, count: int, seed: int, slot_rules: FrozenSet[str]) -> Tuple[DrawnCommand, ...]:
    """Draw different commands, equally many from each grammar below a folder, as far as a grammar has so many.

    Args:
        folder: holds the grammars, in any depth
        count: number of commands
        seed: of the random generator
        slot_rules: rules whose words count as one slot: ``pose``
    Raises:
        CorpusError: the grammars or their values cannot be read
    """
    chance = random.Random(seed)
    grammars = find_grammars(folder)
    worlds = [read_world(Path(grammar.path).parent) for grammar in grammars]
    drawn: List[DrawnCommand] = []
    texts: Set[str] = set()
    for number, (grammar, world) in enumerate(zip(grammars, worlds)):
        share = count * (number + 1) // len(grammars) - count * number // len(grammars)
        for command in _different(grammar, world, chance, slot_rules, texts):
            if share <= 0:
                break
            drawn.append(command)
            share -= 1
    return tuple(drawn)


def _different(
    grammar: Grammar, world: World, chance: random.Random, slot_rules: FrozenSet[str], texts: Set[str]
) -> Iterator[DrawnCommand]:
    misses = 0
    while misses < _ATTEMPTS:
        command = _Drawing(grammar, world, chance, slot_rules).command()
        key = command.text.lower().rstrip(".") if command is not None else ""
        if command is None or key in texts:
            misses += 1
            continue
        misses = 0
        texts.add(key)
        yield command


class _Drawing:
    """One command while it is drawn."""

    def __init__(self, grammar: Grammar, world: World, chance: random.Random, slot_rules: FrozenSet[str]) -> None:
        self._grammar = grammar
        self._world = world
        self._chance = chance
        self._slot_rules = slot_rules
        self._values: Dict[Tuple[str, str], Value] = {}
        self._pieces: List[Piece] = []
        self._last: Dict[str, Tuple[str, str]] = {}
        self._rules: List[str] = []

    def command(self) -> Optional[DrawnCommand]:
        """Return the command; None if a slot has no value."""
        try:
            self._expand(Reference(MAIN))
        except _NothingFits:
            return None
        pieces = [piece for piece in self._pieces if piece.text]
        text, spans = _joined(pieces)
        if self._chance.random() < 0.5:
            text = text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")
        task = next((rule for rule in self._rules if rule not in self._slot_rules | _NO_TASKS), "other")
        return DrawnCommand(self._grammar.name, task, text, tuple(pieces), tuple(spans))

    def _expand(self, node: Node) -> None:
        if isinstance(node, Word):
            self._pieces.append(Piece(node.text))
        elif isinstance(node, Slot):
            self._fill(node)
        elif isinstance(node, InSequence):
            for item in node.items:
                self._expand(item)
        elif isinstance(node, Choice):
            self._expand(self._chance.choice(node.options))
        else:
            self._rule(node.rule)

    def _rule(self, name: str) -> None:
        options = self._grammar.rules.get(name)
        if not options:
            raise _NothingFits(name)
        self._rules.append(name)
        first = len(self._pieces)
        self._expand(self._chance.choice(options))
        if name in self._slot_rules:
            inner = [piece for piece in self._pieces[first:] if piece.text]
            self._pieces[first:] = [Piece(_joined(inner)[0], name)]

    def _fill(self, slot: Slot) -> None:
        if slot.kind == "void":
            return
        if slot.kind == "question":
            self._pieces.append(Piece("question", "question"))
            return
        if slot.kind == "pron":
            self._pronoun(slot)
            return
        kind = (slot.restriction or slot.kind) if slot.kind == "location" else slot.kind
        key = (kind, slot.number)
        value = self._values[key] if slot.number and key in self._values else self._choose(slot, kind)
        self._values[key] = value
        text = value.text
        if slot.is_obscured:
            text, kind = (value.group, "category") if slot.kind == "object" else (value.group or text, "room")
        self._pieces.append(Piece(text, kind))
        if slot.kind in ("name", "object"):
            gender = value.properties.get("gender", "") or slot.restriction
            if slot.kind == "name" and gender not in ("male", "female"):
                gender = self._chance.choice(("male", "female"))
            self._last[slot.kind] = (text, gender if slot.kind == "name" else "")
        else:
            self._last["other"] = (text, "")

    def _choose(self, slot: Slot, kind: str) -> Value:
        taken = {value.text for value in self._values.values()}
        fitting = [
            value for value in _candidates(self._world, slot, kind) if value.text not in taken and _meets(value, slot)
        ]
        if not fitting:
            raise _NothingFits(str(slot))
        return self._chance.choice(fitting)

    def _pronoun(self, slot: Slot) -> None:
        text, gender = self._last.get("name") or self._last.get("object") or self._last.get("other") or ("", "")
        forms = _OTHER_FORMS.get(slot.restriction, _OBJECTIVE)
        self._pieces.append(Piece(forms[gender], "pron", text))


def _candidates(world: World, slot: Slot, kind: str) -> Sequence[Value]:
    if kind == "beacon":
        return [value for value in world.of("place") if value.properties.get("isbeacon") == "true"]
    if kind == "placement":
        return [value for value in world.of("place") if value.properties.get("isplacement") == "true"]
    if kind == "location":
        return world.of("room") + world.of("place")
    if kind == "name" and slot.restriction:
        return [value for value in world.of("name") if value.properties.get("gender") in ("", slot.restriction)]
    if kind == "object" and slot.restriction:
        return [value for value in world.of("object") if value.properties.get("type") == slot.restriction]
    return world.of(kind)


def _meets(value: Value, slot: Slot) -> bool:
    return all(
        (value.properties.get(name.lower(), "false").lower() == wanted.lower()) == (sign == "=")
        for name, sign, wanted in slot.conditions
    )


def _joined(pieces: Sequence[Piece]) -> Tuple[str, List[Tuple[int, int]]]:
    text = ""
    spans = []
    for piece in pieces:
        if text and piece.text not in (",", ".") and not piece.text.startswith("'"):
            text += " "
        spans.append((len(text), len(text) + len(piece.text)))
        text += piece.text
    return text, spans
