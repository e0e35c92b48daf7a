"""Measures objects of the world: their size, height and distance, as far as they are known, and orders by them."""

from typing import Iterable, NamedTuple, Optional, Tuple

from phrase_meanings.meaning_file import measure_of
from world_model import World, WorldObject

Objects = Tuple[WorldObject, ...]


class Measure(NamedTuple):
    """What an adjective measures.

    Attributes:
        name: "height", or another of ``meanings.yaml``
        is_little: whether it means little of it: "small"
    """

    name: str
    is_little: bool


def measure(adjective: str) -> Optional[Measure]:
    """Return what an adjective in any degree measures; None for an adjective of another kind."""
    name = measure_of(adjective.lower())
    return Measure(name.lstrip("-"), name.startswith("-")) if name else None


def measured(one: WorldObject, name: str, world: World) -> Optional[float]:
    """Return how much of a measure an object has: metres, cubic metres for its size; None when it is not known.

    Nobody tells the world how heavy, warm or old things are.
    """
    width_m, depth_m, height_m = one.size_m
    if name == "size":
        return width_m * depth_m * height_m or None
    if name == "height":
        return height_m or None
    if name == "length":
        return max(width_m, depth_m) or None
    if name == "width":
        return min(width_m, depth_m) or None
    return distance_m(one, world.robot) if name == "distance" else None


def in_order(objects: Iterable[WorldObject], wanted: Measure, world: World) -> Objects:
    """Return the objects of which a measure is known, those with the most of it first, or with the least."""
    known = [(value, one) for one in objects for value in [measured(one, wanted.name, world)] if value is not None]
    return tuple(one for _, one in sorted(known, key=lambda pair: pair[0], reverse=not wanted.is_little))


def distance_m(one: WorldObject, other: Optional[WorldObject]) -> Optional[float]:
    """Return the distance between two objects in metres; None when it is not known."""
    if other is None or one.pose is None or other.pose is None:
        return None
    return other.pose.distance_m(one.pose)
