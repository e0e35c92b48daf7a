"""What the units that act say of their frames: their verbs and examples."""

from dataclasses import dataclass
from functools import cached_property
from typing import Dict, Iterable, List, Mapping, NamedTuple, Tuple

from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit

#: So many units that a person has taught are compared with: those taught last.
_MOST_LEARNED = 200


class DeedExample(NamedTuple):
    """An example, and its unit."""

    unit: LexicalUnit
    text: str


@dataclass(frozen=True)
class Deeds:
    """Verbs and examples, in the order of the files.

    Attributes:
        examples: examples of the units
        verbs: each with its first unit of each frame
    """

    examples: Tuple[DeedExample, ...]
    verbs: Tuple[Tuple[LexicalUnit, str], ...]

    @cached_property
    def texts(self) -> Tuple[str, ...]:
        """The texts of the examples."""
        return tuple(example.text for example in self.examples)

    @cached_property
    def verb_texts(self) -> Tuple[str, ...]:
        """The verbs alone."""
        return tuple(verb for _, verb in self.verbs)


def deeds_of_units(units: Iterable[LexicalUnit], frames: Mapping[str, SemanticFrame]) -> Deeds:
    """Return what units whose frames act say of them."""
    acting = [unit for unit in units if unit.verbs and unit.frame_name in frames and frames[unit.frame_name].acts]
    learned = [unit for unit in acting if unit.is_learned]
    left_out = {id(unit) for unit in learned[:-_MOST_LEARNED]}
    acting = [unit for unit in acting if id(unit) not in left_out]
    verbs: Dict[Tuple[str, str], Tuple[LexicalUnit, str]] = {}
    found: List[DeedExample] = []
    for unit in acting:
        for verb in unit.verbs:
            if verb not in unit.class_verbs:
                verbs.setdefault((unit.frame_name, verb), (unit, verb))
        found += [DeedExample(unit, example.text) for example in unit.examples]
    return Deeds(tuple(found), tuple(verbs.values()))
