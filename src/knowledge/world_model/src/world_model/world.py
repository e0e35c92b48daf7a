"""A snapshot of what the robot knows, and the queries on it."""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from typing import Dict, FrozenSet, Iterable, Iterator, List, Mapping, Optional, Sequence, Set, Tuple

from semantic_types import spoken
from world_model.nouns import Nouns
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
#: Under the mug is what the mug stands on.
_OPPOSITE = {_UNDER: _ON, "left_of": "right_of", "right_of": "left_of"}
_STANDARD: Mapping[str, str] = {
    word: standard for words, standard in zip(_ALIKE, (_ON, _IN, _NEAR, _UNDER, _HELD)) for word in words
}


def standard_relation(relation: str) -> str:
    """Return the common name of a relation of place: "near" for "beside"; the relation itself for others."""
    return _STANDARD.get(relation, relation)


#: Objects are few when the world has more than so many times as many.
_FEW = 4
#: A frame, and a square of its floor.
_Square = Tuple[str, int, int]
#: The id of an object, and its x and y in its frame, metres.
_Spot = Tuple[str, float, float]


@dataclass(frozen=True, eq=False)
class World:
    """What the robot knows at a time. No object means that it knows of nothing.

    Attributes:
        version: another one for each change; empty when nothing was heard
        objects: ascending by id
        left_out: objects that are known and did not fit
        taught_kinds: nouns that a person taught, each with the noun of which it is a kind
    """

    version: str = ""
    objects: Tuple[WorldObject, ...] = ()
    left_out: int = 0
    taught_kinds: Tuple[Tuple[str, str], ...] = ()

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

    @property
    def held(self) -> Tuple["WorldObject", ...]:
        """What the robot holds; what an earlier run held may have been taken out of its hand since."""
        held = (self.by_id[name] for name in self._related.get(ROBOT_ID, {}).get(_HELD, ()))
        return tuple(one for one in held if not one.place_of_before_s)

    @cached_property
    def of_this_run(self) -> "World":
        """The same without what earlier runs knew of places and states, which may have changed since."""
        if not any(one.place_of_before_s or one.states_of_before_s for one in self.objects):
            return self
        return World(self.version, tuple(map(_of_this_run, self.objects)), self.left_out, self.taught_kinds)

    @cached_property
    def _by_name(self) -> Mapping[str, Tuple[WorldObject, ...]]:
        found: Dict[str, List[WorldObject]] = {}
        for one in self.objects:
            for name in dict.fromkeys(spoken(name) for name in one.names):
                found.setdefault(name, []).append(one)
        return {name: tuple(objects) for name, objects in found.items()}

    @cached_property
    def _nouns(self) -> Nouns:
        return Nouns(self.objects, self.taught_kinds)

    def of_sorts(self, *sorts: Sort) -> Tuple[WorldObject, ...]:
        """Return the objects of some sorts."""
        if sorts not in self._of_sorts:
            self._of_sorts[sorts] = tuple(one for one in self.objects if one.sort in sorts)
        return self._of_sorts[sorts]

    @cached_property
    def _of_sorts(self) -> Dict[Tuple[Sort, ...], Tuple[WorldObject, ...]]:
        """The objects of sorts that somebody asked for."""
        return {}

    def named(self, name: str) -> Tuple[WorldObject, ...]:
        """Return the objects with a name; upper and lower case mean the same."""
        return self._by_name.get(spoken(name), ())

    def exactly(self, noun: str) -> Tuple[WorldObject, ...]:
        """Return the objects of a category, without those of more special categories."""
        return self._nouns.exactly(noun)

    def kinds_of(self, noun: str) -> Tuple[WorldObject, ...]:
        """Return the objects that a noun may stand for: those of its category and of more special categories.

        A person may have taught more special ones. A noun of which nothing is known but that it is a kind of another
        stands for things of that other kind.
        """
        return self._nouns.kinds_of(noun)

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
        if self.get(one.id) is not one:
            return self._find_room(one)
        if one.id not in self._room_of:
            self._room_of[one.id] = self._find_room(one)
        return self._room_of[one.id]

    @cached_property
    def _room_of(self) -> Dict[str, Optional[WorldObject]]:
        """The rooms that were found so far."""
        return {}

    def _find_room(self, one: WorldObject) -> Optional[WorldObject]:
        room = self._room_carried(one)
        if room is not None or one.pose is not None:
            return room
        # What is beside something is in its room.
        near = next((other for place in one.places for other in [self.get(place.reference)] if other is not None), None)
        if near is None:
            return None
        return near if near.sort is Sort.PLACE else self._room_carried(near)

    def _room_carried(self, one: WorldObject) -> Optional[WorldObject]:
        """Return the place that contains an object, or what carries it, or the pose of one of them."""
        pose = one.pose
        for _, other in self.above(one):
            if other.sort is Sort.PLACE:
                return other
            pose = pose or other.pose
        return next((room for room in self._rooms if pose is not None and _holds(room, pose)), None)

    @cached_property
    def _inside(self) -> Mapping[str, FrozenSet[str]]:
        """The ids of the objects in each place."""
        found: Dict[str, Set[str]] = {}
        for one in self.objects:
            room = self.room_of(one) if one.sort is not Sort.PLACE else None
            for place in [one, room] if room is not None else [one]:
                chain = [place, *(other for _, other in self.above(place))]
                for other in chain if place is room else chain[1:]:
                    if other.sort is Sort.PLACE:
                        found.setdefault(other.id, set()).add(one.id)
        return {name: frozenset(ids) for name, ids in found.items()}

    @cached_property
    def _related(self) -> Mapping[str, Mapping[str, Sequence[str]]]:
        """The ids of the objects that have a relation to another one, by its id and the common name of the relation."""
        found: Dict[str, Dict[str, List[str]]] = {}
        for one in self.objects:
            for place in one.places:
                relations = found.setdefault(place.reference, {})
                relations.setdefault(standard_relation(place.relation), []).append(one.id)
        return found

    @cached_property
    def _squares(self) -> Mapping[_Square, Sequence[_Spot]]:
        return _squares_of(self.objects)

    def stands(self, one: WorldObject, relation: str, other: WorldObject) -> bool:
        """Whether an object has a relation of place to another one, as far as is known."""
        return one.id in self.at(relation, [other])

    def at(
        self, relation: str, references: Sequence[WorldObject], among: Optional[Sequence[WorldObject]] = None
    ) -> FrozenSet[str]:
        """Return the ids of the objects that have a relation of place to any of some objects, as far as is known.

        Args:
            relation: "on", "beside"
            references: the objects that it relates to
            among: the objects that are asked about; others may be missing in the answer. None for all
        """
        wanted = standard_relation(relation)
        opposite = _NEAR if wanted == _NEAR else _OPPOSITE.get(wanted, "")
        direct: Set[str] = set()
        found: Set[str] = set()
        for reference in references:
            if reference.sort is Sort.PLACE and wanted in (_IN, _ON, _NEAR):
                found |= self._inside.get(reference.id, frozenset())
            direct.update(self._related.get(reference.id, {}).get(wanted, ()))
            for place in reference.places if opposite else ():
                if standard_relation(place.relation) == opposite:
                    found.add(place.reference)
        if wanted in (_IN, _ON, _HELD):
            found |= self._carried_by(direct, frozenset([_ON]) if wanted == _ON else _CARRYING)
        if wanted == _NEAR:
            # A few objects are sooner put into squares of their own than all others are compared.
            is_small = among is not None and _FEW * len(among) < len(self.objects)
            found |= _beside(references, _squares_of(among) if among is not None and is_small else self._squares)
        return frozenset(found | direct)

    def _carried_by(self, names: Iterable[str], relations: FrozenSet[str]) -> Set[str]:
        """Return the ids of what some objects carry, of what that carries, and so on."""
        found: Set[str] = set()
        left = list(names)
        while left:
            for relation, carried in self._related.get(left.pop(), {}).items():
                if relation in relations:
                    left += [name for name in carried if name not in found]
                    found.update(carried)
        return found

    def nearest_first(self, objects: Sequence[WorldObject]) -> Tuple[WorldObject, ...]:
        """Return objects by their distance from the robot; in the same order if nobody knows where the robot is."""
        return tuple(sorted(objects, key=lambda one: self._distance_m[one.id]))

    @cached_property
    def _distance_m(self) -> Mapping[str, float]:
        """How far each object is from the robot, metres; infinite when unknown."""
        pose = self.robot.pose if self.robot is not None else None
        return {
            one.id: pose.distance_m(one.pose) if pose is not None and one.pose is not None else math.inf
            for one in self.objects
        }

    def prepare(self) -> "World":
        """Look up now what queries need of the whole world, so that the first one is as fast as the others."""
        indices = ("_by_name", "_inside", "_related", "_squares", "_distance_m")
        of_objects = [(one, "properties") for one in self.objects]
        for owner, name in [*((self, index) for index in indices), (self._nouns, "categories_below"), *of_objects]:
            getattr(owner, name)
        return self

    def owners(self, one: WorldObject) -> Tuple[WorldObject, ...]:
        """Return the known persons that an object belongs to."""
        return tuple(owner for name in one.related("of") for owner in [self.get(name)] if owner is not None)


def _of_this_run(one: WorldObject) -> WorldObject:
    one = one.without_place() if one.place_of_before_s else one
    return replace(one, states=(), states_of_before_s=0.0) if one.states_of_before_s else one


def _square(pose: Pose) -> _Square:
    return (pose.frame_id, math.floor(pose.x_m / NEAR_M), math.floor(pose.y_m / NEAR_M))


def _squares_of(objects: Iterable[WorldObject]) -> Mapping[_Square, Sequence[_Spot]]:
    """Return what may stand beside something, by squares as wide as things beside each other may be apart."""
    found: Dict[_Square, List[_Spot]] = {}
    for one in objects:
        if one.pose is not None and one.sort is not Sort.PLACE:
            found.setdefault(_square(one.pose), []).append((one.id, one.pose.x_m, one.pose.y_m))
    return found


def _beside(references: Iterable[WorldObject], squares: Mapping[_Square, Sequence[_Spot]]) -> Set[str]:
    """Return the ids of what stands beside any of some objects, by their poses."""
    around: Dict[_Square, List[_Spot]] = {}
    for reference in references:
        pose = reference.pose
        if pose is not None and reference.sort is not Sort.PLACE:
            spot = (reference.id, pose.x_m, pose.y_m)
            frame_id, column, row = _square(pose)
            for square in product((frame_id,), (column - 1, column, column + 1), (row - 1, row, row + 1)):
                if square in squares:
                    around.setdefault(square, []).append(spot)
    found: Set[str] = set()
    for square, spots in around.items():
        for name, x_m, y_m in squares[square]:
            for other, other_x_m, other_y_m in spots:
                if math.hypot(x_m - other_x_m, y_m - other_y_m) <= NEAR_M and name != other:
                    found.add(name)
                    break  # One that is near is enough, however many there are.
    return found


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
