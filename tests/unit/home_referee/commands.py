"""Draws commands with their logical forms from the published grammars, filled with what a home has."""

import random
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, List, Mapping, Optional, Sequence, Tuple

from frame_learning.gpsr_grammar import (
    MAIN,
    Choice,
    Grammar,
    Node,
    Reference,
    Slot,
    Word,
    find_grammars,
    read_expression,
)
from frame_learning.gpsr_grammar import Sequence as InSequence

from .home_slots import MOST_KG, HomeSlots, Value
from .logical_forms import Description, Form, NotInThisHome, read_form

_OBJECTIVE = {"male": "him", "female": "her", "": "it"}
#: Attempts to fill a production.
_ATTEMPTS = 20


@dataclass(frozen=True)
class Command:
    """A command with its annotation.

    Attributes:
        text: as it is said
        form: its logical form
        production: where it comes from, for people
        arranged: how the home must be before it: "bob": "at sofa standing", "apple": "on desk"
        destination: where somebody who is followed goes, as a slot of the command says; empty if none does
        tokens: words and kinds of slots, each with a blank behind it; empty for our own commands
    """

    text: str
    form: Form
    production: str
    arranged: Mapping[str, str] = field(default_factory=dict)
    destination: str = ""
    tokens: str = ""


@dataclass(frozen=True)
class Production:
    """A kind of command and the form of all its commands, with slots."""

    grammar: Grammar
    said: Node
    form: str
    name: str


def read_productions(folder: str) -> Tuple[Production, ...]:
    """Read the kinds of commands that have a logical form: those of ``X_semantics.txt`` beside ``X_grammar.txt``.

    Raises:
        CorpusError: the grammars cannot be read
    """
    found: List[Production] = []
    for grammar in find_grammars(folder):
        path = Path(grammar.path.replace("_grammar.txt", "_semantics.txt"))
        if str(path) == grammar.path or not path.exists():
            continue
        for line in path.read_text(encoding="utf-8-sig").splitlines():
            said, equals, form = line.partition(" = ")
            if equals and not line.lstrip().startswith("#"):
                found.append(Production(grammar, read_expression(said), form.strip(), said.strip()))
    return tuple(found)


def draw(folder: str, slots: HomeSlots, *, count: int, seed: int) -> Tuple[Tuple[Command, ...], Tuple[str, ...]]:
    """Draw different commands, each kind as often as the others.

    Returns:
        the commands, and the kinds that this home has nothing for
    """
    chance = random.Random(seed)
    productions = {(one.grammar.name, one.name): one for one in read_productions(folder)}.values()
    left_out: Dict[str, str] = {}
    usable: List[Production] = []
    for production in productions:
        try:
            _command(production, slots, random.Random(0))
            usable.append(production)
        except (NotInThisHome, LookupError) as reason:
            left_out[production.name] = str(reason)
    generated = {one.grammar.name: re.compile(_pattern(Reference(MAIN), one.grammar.rules)) for one in productions}
    drawn: Dict[str, Command] = {}
    while len(drawn) < count and usable:
        order = chance.sample(usable, len(usable))
        for production in order:
            command = _different(production, slots, chance, drawn, generated[production.grammar.name])
            if command is None:
                usable.remove(production)
            elif len(drawn) < count:
                drawn[command.text.lower()] = command
    return tuple(drawn.values()), tuple(f"{name}: {reason}" for name, reason in left_out.items())


def _different(
    production: Production,
    slots: HomeSlots,
    chance: random.Random,
    drawn: Mapping[str, Command],
    generated: "re.Pattern[str]",
) -> Optional[Command]:
    """Return a command that is new, and that its grammar generates: some forms are published for others as well."""
    for _ in range(_ATTEMPTS):
        command = _command(production, slots, chance)
        if command.text.lower() not in drawn and generated.fullmatch(command.tokens):
            return command
    return None


def _pattern(node: Node, rules: Mapping[str, Tuple[Node, ...]]) -> str:
    """Return a regular expression for all that a rule generates, over tokens that each end with a blank."""
    if isinstance(node, Word):
        return re.escape(node.text.lower()) + " "
    if isinstance(node, Slot):
        return "" if node.kind == "void" else f"<{_kind(node)}> "
    if isinstance(node, Reference):
        options = rules.get(node.rule, ())
        return f"(?:{'|'.join(_pattern(option, rules) for option in options)})" if options else "(?!)"
    if isinstance(node, Choice):
        return f"(?:{'|'.join(_pattern(option, rules) for option in node.options)})"
    return "".join(_pattern(item, rules) for item in node.items)


def _kind(slot: Slot) -> str:
    """Return which values fill a slot: the things of a home are alike and known."""
    kind = (slot.restriction or slot.kind) if slot.kind == "location" else slot.kind
    return kind + ("?" if slot.is_obscured else "")


def _command(production: Production, slots: HomeSlots, chance: random.Random) -> Command:
    drawing = _Drawing(production.grammar, slots, chance)
    drawing.expand(production.said)
    text = drawing.text
    form = read_form(drawing.filled(production.form))
    if production.form == "UNKNOWN":
        form = Form("UNKNOWN")
    return Command(
        text[:1].upper() + text[1:] + ".",
        form,
        production.name,
        arrangement(form, slots, chance),
        drawing.destination,
        drawing.tokens,
    )


class _Drawing:
    """One command while it is drawn."""

    def __init__(self, grammar: Grammar, slots: HomeSlots, chance: random.Random) -> None:
        self._grammar = grammar
        self._slots = slots
        self._chance = chance
        self._words: List[str] = []
        self.tokens = ""
        #: By what the form calls it: "{name 1}", "$object".
        self._values: Dict[str, Value] = {}
        self._said: Dict[Tuple[str, str], Value] = {}
        self._person: Optional[Value] = None

    @property
    def text(self) -> str:
        """The command."""
        return " ".join(self._words).replace(" ,", ",").replace(" '", "'").rstrip(" .")

    @property
    def destination(self) -> str:
        """The room that is said to be the end."""
        value = self._said.get(("room", "2"))
        return value.ident if value is not None else ""

    def filled(self, form: str) -> str:
        """Return a form with ids in place of slots."""
        for name, value in sorted(self._values.items(), key=lambda item: -len(item[0])):
            form = form.replace(name, f" {value.ident} ")
        return form

    def expand(self, node: Node) -> None:
        """Say a part of the grammar."""
        if isinstance(node, Word):
            self._words.append(node.text)
            self.tokens += f"{node.text.lower()} "
        elif isinstance(node, Slot):
            self._fill(node)
        elif isinstance(node, InSequence):
            for item in node.items:
                self.expand(item)
        elif isinstance(node, Choice):
            self.expand(self._chance.choice(node.options))
        else:
            self._rule(node)

    def _rule(self, node: Reference) -> None:
        options = self._grammar.rules.get(node.rule)
        if not options:
            raise NotInThisHome(f"${node.rule} is not defined")
        before = len(self._words)
        option = self._chance.choice(options)
        self.expand(option)
        if isinstance(option, Slot) and node.rule == "object" and self._said:
            self._values[f"${node.rule}"] = list(self._said.values())[-1]
        elif node.rule == "oprop":
            self._values[f"${node.rule}"] = Value(" ".join(self._words[before:]), self._words[before])

    def _fill(self, slot: Slot) -> None:
        if slot.kind == "void":
            return
        if slot.kind == "pron":
            self._words.append(_OBJECTIVE[self._person.gender if self._person is not None else ""])
            self.tokens += "<pron> "
            return
        if slot.kind == "gesture":
            raise NotInThisHome("gestures")
        kind = _kind(slot)
        key = (kind, slot.number)
        value = self._said.get(key) if slot.number else None
        if value is None:
            taken = frozenset(one.ident for one in self._said.values())
            value = self._slots.choose(kind, self._chance, taken)
            # Kinds that are said once have no number.
            self._said[key if slot.number else (kind, f"_{len(self._said)}")] = value
        if kind == "name":
            self._person = value
        self._words.append(value.text)
        self.tokens += f"<{kind}> "
        for name in _names(slot):
            self._values[name] = value


def _names(slot: Slot) -> Sequence[str]:
    """Return what forms call a slot."""
    short = {"alike": "aobject", "known": "kobject", "special": "sobject"}.get(slot.restriction)
    base = short or (slot.restriction if slot.kind == "location" else slot.kind)
    return [f"{{{base}{'?' if slot.is_obscured else ''}{' ' + slot.number if slot.number else ''}}}"]


def arrangement(form: Form, slots: HomeSlots, chance: random.Random) -> Dict[str, str]:
    """Return how the home must be before a command: what its form says to be somewhere is there."""
    wanted: Dict[str, str] = {}
    count = next((int(one) for one in form.arguments if isinstance(one, str) and one.isdigit()), 1)
    for argument in form.arguments:
        if isinstance(argument, Form):
            wanted.update(arrangement(argument, slots, chance))
        elif isinstance(argument, Description):
            wanted.update(_arranged(argument, slots, chance, count))
    return wanted


def _arranged(one: Description, slots: HomeSlots, chance: random.Random, count: int) -> Dict[str, str]:
    if one.is_person:
        return _arranged_people(one, slots, chance)
    things = [ident for ident in slots.of_category(one.is_a) if slots.home["things"][ident]["mass_kg"] <= MOST_KG]
    if len(things) < count:
        raise NotInThisHome(f"{count} of {one.is_a or 'any object'}")
    if not one.at:
        return {}
    found = {}
    for thing in chance.sample(things, count):
        place = one.at
        if place in slots.home["rooms"]:
            place = chance.choice(slots.surfaces_in(place) or [place])
        found[thing] = f"{'on' if slots.is_surface(place) else 'in'} {place}"
    return found


def _arranged_people(one: Description, slots: HomeSlots, chance: random.Random) -> Dict[str, str]:
    if not one.at:
        return {}
    others = [ident for ident in slots.home["persons"] if ident != slots.speaker]
    person = one.name or chance.choice(others)
    # Who is not meant is elsewhere.
    away = "bedroom" if slots.room_of(one.at) != "bedroom" else "office"
    return {
        **{other: f"at {away} standing" for other in others if other != person},
        person: f"at {one.at} {one.posture or 'standing'}",
    }
