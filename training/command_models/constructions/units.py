"""The verbs of a robot and their relations, read from lexical units: YAML files as RoboFrameNet has them."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Iterator, List, Tuple

from command_models.errors import TrainingError

if TYPE_CHECKING:
    from semantic_frames.lexical_unit import LexicalUnit

PARTICLES = frozenset("up down on off out over".split())
ADVERBS = frozenset("back away around round along forward backward backwards".split())


@dataclass(frozen=True)
class Slot:
    """What a verb takes besides its object.

    Attributes:
        role: name of the frame element
        relations: Stanford relations, with their prepositions (``prep_next_to``)
    """

    role: str
    relations: Tuple[str, ...]


@dataclass(frozen=True)
class Unit:
    """A verb with what it takes.

    Attributes:
        verb: base form
        particle: "up" of "pick up", "back" of "bring back"; or empty
        objects: roles of its object; empty if it has none
        slots: what else it takes
    """

    verb: str
    particle: str
    objects: Tuple[str, ...]
    slots: Tuple[Slot, ...]


def read_units(folder: Path) -> List[Unit]:
    """Return the verbs of all ``lexical_units/*.yaml`` below a folder, with what they inherit from their frames.

    Idioms of more than a verb and a particle are left out: their words are no construction.

    Raises:
        TrainingError: there are none
        FileRefused: a file has mistakes
    """
    from semantic_frames import load_frame, load_lexical_units
    from semantic_frames.roles import with_inherited

    frames = {}
    for path in sorted(folder.glob("**/frames/*.yaml")):
        frame = load_frame(path.read_text(encoding="utf-8"), str(path))
        frames[frame.name] = frame
    found: List[Unit] = []
    for path in sorted(folder.glob("**/lexical_units/*.yaml")):
        for unit in load_lexical_units(path.read_text(encoding="utf-8"), str(path)):
            found += _units(with_inherited(unit, frames.get(unit.frame_name)))
    if not found:
        raise TrainingError(f"{folder}: no lexical_units/*.yaml with verbs below; expected the domains of a robot")
    return list(dict.fromkeys(found))


def _units(unit: "LexicalUnit") -> Iterator[Unit]:
    objects: List[str] = []
    slots: List[Slot] = []
    for element in unit.relations:
        relations = [path.steps[0] for path in element.relations if len(path.steps) == 1]
        if "dobj" in relations:
            objects.append(element.name)
        kept = tuple(
            relation
            for relation in relations
            if relation.startswith("prep_") or relation in ("iobj", "advmod", "measure", "tmod")
        )
        if kept:
            slots.append(Slot(element.name, kept))
    for verb in unit.verbs:
        first, *others = verb.split()
        if not first.isalpha() or first in ("be", "need", "want") or len(others) > 1:
            continue
        if others and others[0] not in PARTICLES | ADVERBS:
            continue
        yield Unit(first, others[0] if others else "", tuple(objects), tuple(slots))
