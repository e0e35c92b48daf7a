"""A snapshot of what the robot knows, and the queries on it."""

from dataclasses import dataclass
from functools import cached_property
from typing import Dict, FrozenSet, Iterator, List, Mapping, Optional, Tuple

from semantic_types import shipped_nouns, spoken
from world_model.world_object import ROBOT_ID, Pose, Sort, WorldObject

#: Objects of a snapshot.
MOST_OBJECTS = 5000
#: What fits less into a full snapshot comes later in this order, and then by age.
_FIRST = (Sort.ROBOT, Sort.PLACE, Sort.PERSON, Sort.DOOR, Sort.DEVICE, Sort.THING)
#: What is beside another thing is at most so far from it.
NEAR_M = 1.5
#: Objects on or in each other; a longer chain is a mistake of whoever perceived it.
_MOST_LEVELS = 16

#: Relations that say the same of a place.
_ALIKE: Tuple[FrozenSet[str], ...] = (
    frozenset(["on", "onto", "on_top_of", "over", "above"]),
    frozenset(["in", "into", "inside", "within"]),
    frozenset(["near", "beside", "next_to", "by", "at", "close_to", "around"]),
    frozenset(["under", "below", "underneath", "beneath"]),
    frozenset(["held_by", "with"]),
)
_IN, _ON, _NEAR, _UNDER, _HELD = "in", "on", "near", "under", "held_by"
#: Whoever is carried by one of these goes where the other one goes.
_CARRYING = frozenset([_IN, _ON, _HELD, _UNDER])
_STANDARD: Mapping[str, str] = {
    word: standard for words, standard in zip(_ALIKE, (_ON, _IN, _NEAR, _UNDER, _HELD)) for word in words
}


def standard_relation(relation: str) -> str:
    """Return the common name of a relation of place: "near" for "beside"; the relation itself for others."""
    return _STANDARD.get(relation, relation)


@dataclass(frozen=True, eq=False)
class World:
    """What the robot knows at a time. No object means that it knows of nothing.

    Attributes:
        version: another one for each change; empty when nothing was heard
        objects: ascending by id
        left_out: objects that are known and did not fit
    """

    version: str = ""
    objects: Tuple[WorldObject, ...] = ()
    left_out: int = 0

    @cached_property
    def by_id(self) -> Mapping[str, WorldObject]:
        """The objects by id."""
        return {one.id: one for one in self.objects}

    def get(self, name: str) -> Optional[WorldObject]:
        """Return the object of an id; None if there is none."""
        return self.by_id.get(name)

    @property
    def robot(self) -> Optional[WorldObject]:
        """The robot itself."""
        return self.get(ROBOT_ID)

    @cached_property
    def _by_name(self) -> Mapping[str, Tuple[WorldObject, ...]]:
        found: Dict[str, List[WorldObject]] = {}
        for one in self.objects:
            for name in dict.fromkeys(spoken(name) for name in one.names):
                found.setdefault(name, []).append(one)
        return {name: tuple(objects) for name, objects in found.items()}

    @cached_property
    def _by_category(self) -> Mapping[str, Tuple[WorldObject, ...]]:
        found: Dict[str, List[WorldObject]] = {}
        for one in self.objects:
            found.setdefault(category_of(one), []).append(one)
        return {category: tuple(objects) for category, objects in found.items()}

    @cached_property
    def _categories_below(self) -> Mapping[object, Tuple[str, ...]]:
        """The categories below each synset of WordNet, and those that end with a word."""
        found: Dict[object, List[str]] = {}
        for category, objects in self._by_category.items():
            is_person = objects[0].sort is Sort.PERSON
            last = category.split()[-1] if category else ""
            above = shipped_nouns().kinds(category, is_person=is_person)
            if not above and last != category:
                above = shipped_nouns().kinds(last, is_person=is_person)
            for key in (last, *above):
                found.setdefault(key, []).append(category)
        return {key: tuple(categories) for key, categories in found.items()}

    def named(self, name: str) -> Tuple[WorldObject, ...]:
        """Return the objects with a name; upper and lower case mean the same."""
        return self._by_name.get(spoken(name), ())

    def exactly(self, noun: str) -> Tuple[WorldObject, ...]:
        """Return the objects of a category, without those of more special categories."""
        return self._by_category.get(spoken(noun), ())

    def kinds_of(self, noun: str) -> Tuple[WorldObject, ...]:
        """Return the objects that a noun may stand for: those of its category and of more special categories."""
        key = spoken(noun)
        categories = [key, *self._categories_below.get(key, ())]
        for synset in shipped_nouns().synsets(key):
            categories += self._categories_below.get(synset, ())
        return tuple(one for category in dict.fromkeys(categories) for one in self._by_category.get(category, ()))

    def above(self, one: WorldObject) -> Iterator[Tuple[str, WorldObject]]:
        """Yield what carries or contains an object, the nearest first, each with the relation of what it carries."""
        seen = {one.id}
        for _ in range(_MOST_LEVELS):
            step = next(
                (
                    (standard_relation(place.relation), other)
                    for place in one.places
                    for other in [self.get(place.reference)]
                    if other is not None and other.id not in seen and standard_relation(place.relation) in _CARRYING
                ),
                None,
            )
            if step is None:
                return
            yield step
            one = step[1]
            seen.add(one.id)

    @cached_property
    def _rooms(self) -> Tuple[WorldObject, ...]:
        """Places that have a pose and a size, the smallest first."""
        rooms = [one for one in self.objects if one.sort is Sort.PLACE and one.pose and one.size_m[0] and one.size_m[1]]
        return tuple(sorted(rooms, key=lambda one: one.size_m[0] * one.size_m[1]))

    def room_of(self, one: WorldObject) -> Optional[WorldObject]:
        """Return the place that an object is in, by what contains it or by its pose; None when unknown."""
        if one.sort is Sort.PLACE:
            return one
        carried = [one]
        for _, other in self.above(one):
            if other.sort is Sort.PLACE:
                return other
            carried.append(other)
        posed = next((other.pose for other in carried if other.pose is not None), None)
        if posed is not None:
            return next((room for room in self._rooms if _holds(room, posed)), None)
        # What is beside something is in its room.
        near = next((other for place in one.places for other in [self.get(place.reference)] if other is not None), None)
        if near is None:
            return None
        return near if near.sort is Sort.PLACE else self._room_above(near)

    def _room_above(self, one: WorldObject) -> Optional[WorldObject]:
        return next((other for _, other in self.above(one) if other.sort is Sort.PLACE), None)

    def stands(self, one: WorldObject, relation: str, other: WorldObject) -> bool:
        """Whether an object has a relation of place to another one, as far as is known."""
        wanted = standard_relation(relation)
        if one.id == other.id:
            return False
        if any(place.reference == other.id and standard_relation(place.relation) == wanted for place in one.places):
            return True
        if other.sort is Sort.PLACE and wanted in (_IN, _ON, _NEAR):
            room = self.room_of(one)
            return room is not None and (room.id == other.id or self._is_inside(room, other))
        if wanted in (_IN, _ON, _HELD):
            chain = list(self.above(one))
            links = [link for link, reached in chain[: self._depth(chain, other)]]
            return bool(links) and (links[-1] == wanted and (wanted != _ON or set(links) == {_ON}))
        if wanted == _NEAR:
            return any(
                place.reference == one.id and standard_relation(place.relation) == _NEAR for place in other.places
            ) or (one.pose is not None and other.pose is not None and one.pose.distance_m(other.pose) <= NEAR_M)
        opposite = {"under": _ON, "left_of": "right_of", "right_of": "left_of"}.get(wanted)
        return opposite is not None and any(
            place.reference == one.id and standard_relation(place.relation) == opposite for place in other.places
        )

    @staticmethod
    def _depth(chain: List[Tuple[str, WorldObject]], other: WorldObject) -> int:
        return next((depth for depth, (_, reached) in enumerate(chain, start=1) if reached.id == other.id), 0)

    def _is_inside(self, room: WorldObject, other: WorldObject) -> bool:
        return any(reached.id == other.id for _, reached in self.above(room))

    def owners(self, one: WorldObject) -> Tuple[WorldObject, ...]:
        """Return the known persons that an object belongs to."""
        return tuple(owner for name in one.related("of") for owner in [self.get(name)] if owner is not None)


def category_of(one: WorldObject) -> str:
    """Return the category of an object as it is compared; persons and robots without one have that of their sort."""
    if one.category:
        return spoken(one.category)
    return one.sort.value if one.sort in (Sort.PERSON, Sort.ROBOT, Sort.DOOR) else ""


def _holds(room: WorldObject, pose: Pose) -> bool:
    """Whether a pose is inside the box of a place."""
    if room.pose is None or room.pose.frame_id != pose.frame_id:
        return False
    ahead, left = pose.seen_from(room.pose)
    return abs(ahead) <= room.size_m[0] / 2.0 and abs(left) <= room.size_m[1] / 2.0


def snapshot(version: str, known: Mapping[str, WorldObject]) -> World:
    """Return what fits into a snapshot: places, persons, doors and robots first, then what was seen last."""
    objects = list(known.values())
    if len(objects) > MOST_OBJECTS:
        objects.sort(key=lambda one: (_FIRST.index(one.sort), -one.stamp_s, one.id))
    kept = sorted(objects[:MOST_OBJECTS], key=lambda one: one.id)
    return World(version, tuple(kept), len(objects) - len(kept))
