"""One object of the world: the attributes are those of the message ``WorldObject``, which defines each of them."""

import enum
import math
import re
from dataclasses import dataclass, replace
from functools import cached_property
from typing import FrozenSet, List, Optional, Tuple

LONGEST_TEXT = 100
#: Entries of each list of an object.
MOST_ENTRIES = 20
#: The robot that hears the sentences.
ROBOT_ID = "robot"
#: The source of what the file of the world says.
FILE = "file"
#: Relations that do not say where an object is: whose it is, and where a door leads.
OWNED_BY, LEADS_TO = "of", "to"
NOT_PLACES = frozenset([OWNED_BY, LEADS_TO])

_ID = re.compile(r"[\w./-]{1,100}", re.ASCII)
_NUMBER_AT_THE_END = re.compile(r"_\d+$")


class Sort(str, enum.Enum):
    """What an object is, as the message has it."""

    THING = "thing"
    PERSON = "person"
    PLACE = "place"
    DOOR = "door"
    DEVICE = "device"
    ROBOT = "robot"


@dataclass(frozen=True)
class Pose:
    """A pose in a frame: position in metres, orientation as a quaternion."""

    frame_id: str
    x_m: float
    y_m: float
    z_m: float = 0.0
    orientation: Tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)

    @property
    def heading_rad(self) -> float:
        """Counter-clockwise from the x axis (REP 103)."""
        x, y, z, w = self.orientation
        return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))

    def distance_m(self, other: "Pose") -> float:
        """Return the distance on the floor; infinite between different frames."""
        if self.frame_id != other.frame_id:
            return math.inf
        return math.hypot(self.x_m - other.x_m, self.y_m - other.y_m)

    def seen_from(self, viewer: "Pose") -> Tuple[float, float]:
        """Return how far in front and how far to the left of a viewer this is, metres."""
        dx, dy, heading = self.x_m - viewer.x_m, self.y_m - viewer.y_m, viewer.heading_rad
        return dx * math.cos(heading) + dy * math.sin(heading), dy * math.cos(heading) - dx * math.sin(heading)


@dataclass(frozen=True)
class Relation:
    """A relation to another object: "on" and the id of a table."""

    relation: str
    reference: str


@dataclass(frozen=True)
class WorldObject:
    """What is known of one object; an empty attribute, or None, says that nothing is known.

    Attributes:
        size_m: edges of its box along the axes of its pose, metres; 0 when unknown
        stamp_s: ROS time, seconds; 0 for what the file says, and for what an earlier run learned by another clock
        place_of_before_s: Unix time at which an earlier run learned where it is; 0 for what this run learned or the
            file says
        states_of_before_s: the same of its states
    """

    id: str
    sort: Sort = Sort.THING
    name: str = ""
    other_names: Tuple[str, ...] = ()
    category: str = ""
    attributes: Tuple[str, ...] = ()
    size_m: Tuple[float, float, float] = (0.0, 0.0, 0.0)
    pose: Optional[Pose] = None
    relations: Tuple[Relation, ...] = ()
    states: Tuple[str, ...] = ()
    source: str = ""
    stamp_s: float = 0.0
    place_of_before_s: float = 0.0
    states_of_before_s: float = 0.0

    @property
    def is_placed(self) -> bool:
        """Whether it is known where it is, or was."""
        return self.pose is not None or bool(self.places)

    def without_place(self) -> "WorldObject":
        """Return it as it is known when nobody knows where it is."""
        left = tuple(relation for relation in self.relations if relation not in self.places)
        return replace(self, pose=None, relations=left, place_of_before_s=0.0)

    @property
    def names(self) -> Tuple[str, ...]:
        """Its name and its other names."""
        return ((self.name,) if self.name else ()) + self.other_names

    @cached_property
    def places(self) -> Tuple[Relation, ...]:
        """The relations that say where it is."""
        return tuple(relation for relation in self.relations if relation.relation not in NOT_PLACES)

    @cached_property
    def properties(self) -> FrozenSet[str]:
        """The words of its attributes, states, category and names, in lower case."""
        texts = (*self.attributes, *self.states, self.category, *self.names)
        return frozenset(word for text in map(str.lower, texts) for word in (text, *text.split()))

    def related(self, relation: str) -> Tuple[str, ...]:
        """Return the ids of the objects that it has a relation to."""
        return tuple(one.reference for one in self.relations if one.relation == relation)


def is_id(text: str) -> bool:
    """Whether a text may be an id."""
    return _ID.fullmatch(text) is not None


def words_of_id(name: str) -> str:
    """Return what an object is called when only its id says so: "coffee mug" for coffee_mug_1."""
    return _NUMBER_AT_THE_END.sub("", name).replace("_", " ")


def mistakes(one: WorldObject) -> Tuple[str, ...]:
    """Return what is wrong with an object, in words; nothing if it may be stored."""
    found: List[str] = []
    if not is_id(one.id):
        found.append(
            f"the id {one.id[:LONGEST_TEXT]!r} has other characters than letters, digits, _ - . /, or not 1-100"
        )
    texts = (one.name, one.category, one.source, *one.other_names, *one.attributes, *one.states)
    texts += tuple(relation.relation for relation in one.relations)
    for text in texts:
        if len(text) > LONGEST_TEXT or not text.isprintable():
            found.append(f"{text[:LONGEST_TEXT]!r} is longer than {LONGEST_TEXT} characters, or cannot be printed")
    for name in ("other_names", "attributes", "states", "relations"):
        if len(getattr(one, name)) > MOST_ENTRIES:
            found.append(f"{name} has more than {MOST_ENTRIES} entries")
    for name in ("other_names", "attributes", "states"):
        if not all(getattr(one, name)):
            found.append(f"{name} has an empty entry")
    for relation in one.relations:
        if not relation.relation or not is_id(relation.reference) or relation.reference == one.id:
            found.append(f"the relation {relation.relation!r} to {relation.reference[:LONGEST_TEXT]!r} is none")
    numbers = [*one.size_m, one.stamp_s, one.place_of_before_s, one.states_of_before_s]
    if one.pose is not None:
        numbers += [one.pose.x_m, one.pose.y_m, one.pose.z_m, *one.pose.orientation]
    if not all(map(math.isfinite, numbers)):
        found.append("a number is not finite")
    elif min(one.size_m) < 0.0 or not 0.0 <= one.stamp_s < 2.0**32:
        found.append("a size or the stamp is negative, or the stamp is no ROS time")
    elif (
        one.pose is not None
        and not 0.5 < math.hypot(*one.pose.orientation[:2]) ** 2 + math.hypot(*one.pose.orientation[2:]) ** 2 < 2.0
    ):
        found.append("the orientation is no quaternion of length 1")
    return tuple(found)
