"""The table of constructions: name, how often it is drawn, its final mark, and whether it is for scoring alone."""

from dataclasses import dataclass
from typing import Callable, Dict

from command_models.trees import Node

from .phrases import Phrases

#: Relation of a preposition at the end to its verb, until it hangs on the question word in front, where it belongs.
STRANDED = "stranded"
Build = Callable[[Phrases], Node]


@dataclass(frozen=True)
class Construction:
    """A construction.

    Attributes:
        name: in the table of scores
        build: makes a tree without final punctuation
        mark: final punctuation
        weight: how often it is drawn, beside the others
        scored: it is for scoring alone, and no training sentence is made with it
        projective: whether its arcs never cross
    """

    name: str
    build: Build
    mark: str
    weight: float
    scored: bool
    projective: bool


#: All of the modules that have been imported, by name.
ENTERED: Dict[str, Construction] = {}


def construction(
    mark: str = ".", *, weight: float = 1.0, scored: bool = False, projective: bool = True
) -> Callable[[Build], Build]:
    """Enter a function into the table, under its own name."""

    def enter(build: Build) -> Build:
        name = build.__name__
        if name in ENTERED:
            raise ValueError(f"two constructions are named {name}")
        ENTERED[name] = Construction(name, build, mark, weight, scored, projective)
        return build

    return enter
