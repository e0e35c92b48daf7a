"""Conditions that a laser shows: something is seen, near, touched, or in the way."""

import math
from dataclasses import dataclass
from typing import Callable, Dict, Mapping

from condition_watchers.laser import AHEAD_RAD, Scan
from condition_watchers.words import is_one_of, robots, words
from typed_arguments import TypedArgument

Arguments = Mapping[str, TypedArgument]


@dataclass(frozen=True)
class Reach:
    """Distances from the laser, in metres.

    Attributes:
        sight_m: a wall or an obstacle ahead is seen from here on: farther, almost everything would be
        person_m: a person is seen from here on
        blocked_m: what is nearer ahead is in the way
        contact_m: what is nearer touches the robot
    """

    sight_m: float = 1.0
    person_m: float = 3.0
    blocked_m: float = 0.5
    contact_m: float = 0.3


@dataclass(frozen=True)
class Surroundings:
    """Whether conditions hold in a scan."""

    scan: Scan
    reach: Reach = Reach()

    def holds(self, frame_name: str, arguments: Arguments) -> bool:
        """Return whether a condition holds.

        Args:
            frame_name: of :func:`frames`
            arguments: of its elements
        Raises:
            KeyError: another frame
        """
        return _HOLDS[frame_name](self, arguments)

    def distance_m(self, what: TypedArgument) -> float:
        """Return the distance of the nearest thing that is meant, as far as a laser tells; infinite for none."""
        if is_one_of(what, "walls"):
            return min((thing.ahead_m for thing in self.scan.things() if thing.is_wall), default=math.inf)
        if is_one_of(what, "persons"):
            persons = (thing for thing in self.scan.things() if thing.is_as_wide_as_a_person)
            return min((person.distance_m for person in persons), default=math.inf)
        return self.scan.nearest_m(AHEAD_RAD)

    def sees(self, what: TypedArgument) -> bool:
        """Whether something of this kind is in sight."""
        farthest_m = self.reach.person_m if is_one_of(what, "persons") else self.reach.sight_m
        return self.distance_m(what) <= farthest_m

    def is_at(self, arguments: Arguments) -> bool:
        """Whether something is as near as was said.

        Raises:
            ValueError: no distance was said
        """
        argument = arguments.get("distance")
        if argument is None or argument.si is None:
            raise ValueError("I was not told how far")
        return self.distance_m(arguments["place"]) <= argument.si


_HOLDS: Dict[str, Callable[[Surroundings, Arguments], bool]] = {
    "condition_of_perceiving": lambda around, arguments: around.sees(arguments["phenomenon"]),
    "condition_of_presence": lambda around, arguments: around.sees(arguments["theme"]),
    "condition_of_distance": Surroundings.is_at,
    "condition_of_contact": lambda around, arguments: around.scan.nearest_m(math.pi) <= around.reach.contact_m,
    "condition_of_obstruction": lambda around, arguments: around.scan.nearest_m(AHEAD_RAD) <= around.reach.blocked_m,
}


def frames(*, tells_persons: bool = True) -> Dict[str, Dict[str, object]]:
    """Return the frames that a laser watches, each with what a server states about it.

    Args:
        tells_persons: whether what is as wide as a person counts as one
    """
    me = {"values": sorted(robots())}
    persons = words("persons") if tells_persons else frozenset()
    things = words("walls") | words("obstacles")
    found: Dict[str, Dict[str, object]] = {
        "condition_of_perceiving": {
            "heeds": {"perceiver": me, "phenomenon": {"values": sorted(things | persons)}},
            "unheeded": ["location"],
        },
        "condition_of_distance": {"heeds": {"theme": me, "place": {"values": sorted(things | persons)}}},
        "condition_of_contact": {"heeds": {"theme": me, "place": {"values": sorted(things)}}},
        "condition_of_obstruction": {"heeds": {"theme": {"values": sorted(words("obstacles"))}}, "unheeded": ["path"]},
    }
    if persons:
        found["condition_of_presence"] = {"heeds": {"theme": {"values": sorted(persons)}}}
    return found
