"""Where things and persons are: "under the table", "in the kitchen"."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Mapping, Tuple

import yaml

from home_servers.memory import Known, Memory

#: The relations that a thing may have to a place for each relation that is said; the likeliest first.
RELATIONS: Mapping[str, Tuple[str, ...]] = {
    said: tuple(meant)
    for said, meant in yaml.safe_load(
        Path(__file__).resolve().with_name("relations.yaml").read_text(encoding="utf-8")
    ).items()
}
#: Furniture in which things are kept, by its category.
HOLDING = frozenset("basket cupboard drawer fridge wardrobe box machine sink oven dishwasher".split())
#: A person is at furniture whose middle is so near, metres.
_AT_M = 2.0
#: What is meant by "on the table" and by "in the sink" is not told apart of things that are there.
_UPON = frozenset(["on", "in"])
#: Things stand on each other so deep at most.
_DEEPEST = 6


def is_inside(relation: str) -> bool:
    """Whether a relation says that something is in something: "into"."""
    return RELATIONS.get(relation, ("",))[0] == "in"


def is_beside(relation: str) -> bool:
    """Whether a relation says that something is around something: "near"."""
    return RELATIONS.get(relation) == ("beside",)


@dataclass(frozen=True)
class Place:
    """A place that was named.

    Attributes:
        known: the room, the furniture or the thing
        relation: "under"; empty when none was said
    """

    known: Known
    relation: str = ""

    @property
    def _exact(self) -> Tuple[str, ...]:
        """The relations of which one must hold; empty for a relation that leaves open how things are placed."""
        meant = RELATIONS.get(self.relation, ())
        return () if is_beside(self.relation) or _UPON.intersection(meant) else meant

    @property
    def words(self) -> str:
        """The place in a sentence."""
        return f"{(self.relation if self._exact else 'at').replace('_', ' ')} {self.known.the_name}"

    def has(self, one: Known, memory: Memory) -> bool:
        """Whether something is there; a person is at what is near."""
        place, exact = self.known, self._exact
        if place.sort == "room":
            return not exact and one.room == place.id
        if one.sort == "person":
            is_near = math.hypot(one.x_m - place.x_m, one.y_m - place.y_m) <= _AT_M
            return not exact and one.room == place.room and is_near
        for _ in range(_DEEPEST):
            if one.holder == place.id:
                return not exact or one.relation in exact
            holder = memory.get(one.holder)
            if holder is None:
                return False
            one = holder
        return False
