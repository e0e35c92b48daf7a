"""The names that the types of words need: persons, rooms and things that have a name, with their semantic types."""

from typing import Dict, Iterator, List, Tuple

from semantic_frames.semantic_type import SEMANTIC_TYPES
from semantic_types import shipped_nouns, spoken
from semantic_types.name_file import LONGEST_NAME, MOST_NAMES
from world_model.world import World
from world_model.world_object import Sort, WorldObject

#: What an object is when its category does not say it.
TYPES_OF_SORT = {
    Sort.PLACE: ("Room", "Location"),
    Sort.PERSON: ("Human",),
    Sort.DOOR: ("Physical_object",),
    Sort.DEVICE: ("Device",),
    Sort.THING: ("Physical_object",),
}


def known_names(world: World) -> Tuple[Tuple[str, Tuple[str, ...]], ...]:
    """Return each name with its semantic types, each once, places and persons first.

    A name that is a noun of the language keeps the types of the noun: a place called "fridge" can still be opened.
    """
    found: Dict[str, List[str]] = {}
    for one in sorted(world.objects, key=lambda one: one.sort not in (Sort.PLACE, Sort.PERSON)):
        for name in _names(one):
            types = found.setdefault(name, [])
            types += [kind for kind in _types(one) if kind not in types]
    return tuple((name, tuple(types[:8])) for name, types in list(found.items())[:MOST_NAMES])


def _names(one: WorldObject) -> Iterator[str]:
    is_person = one.sort is Sort.PERSON
    for name in map(spoken, one.names) if one.sort is not Sort.ROBOT else ():
        if 0 < len(name) <= LONGEST_NAME and (is_person or not shipped_nouns().types(name).types):
            yield name


def _types(one: WorldObject) -> Tuple[str, ...]:
    return (one.category,) if one.category in SEMANTIC_TYPES else TYPES_OF_SORT.get(one.sort, ())
