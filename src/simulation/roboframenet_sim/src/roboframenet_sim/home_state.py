"""The state of a home, as values: what is where, and how it is.

A :class:`Plan` never changes: rooms, doors, furniture, what can be done with things. A :class:`State` is what changes.
Every change makes a new state; nobody changes a mapping of one. Metres, radians, kilograms and seconds; x to the east,
y to the north.
"""

import math
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Dict, FrozenSet, List, Mapping, Optional, Tuple, Union

from roboframenet_sim.base import Pose

Value = Union[str, bool, float]
Point = Tuple[float, float]

ROBOT = "robot"
#: Relations of a thing to what holds it.
RELATIONS = ("on", "in", "under", "beside", "behind", "in_front_of", "held")


@dataclass(frozen=True)
class Entity:
    """What does not change of a room, a door, a piece of furniture, a thing or a person.

    Attributes:
        id: unique in the home
        kind: room, door, furniture, thing, person, or robot for another robot
        names: what people call it, the usual name first
        category: what it is: cup, fruit, table; for persons "person"
        traits: what can be done with it, and what it is good for: surface, container, switch, food, cloth, ...
        attributes: colour, size and so on
        mass_kg: of things
        room: of furniture
        x_m, y_m: extent of rooms and furniture, the smaller number first; the two ends of a door
        height_m: of the surface, shelf or handle
        is_tall: whether it hides what is behind it
        rooms: the two rooms that a door joins
    """

    id: str
    kind: str
    names: Tuple[str, ...]
    category: str = ""
    traits: FrozenSet[str] = frozenset()
    attributes: Tuple[Tuple[str, str], ...] = ()
    mass_kg: float = 0.3
    room: str = ""
    x_m: Tuple[float, float] = (0.0, 0.0)
    y_m: Tuple[float, float] = (0.0, 0.0)
    height_m: float = 0.0
    is_tall: bool = False
    rooms: Tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """The usual name."""
        return self.names[0]

    @property
    def the_name(self) -> str:
        """The name in a sentence: "the mug", "Anna"."""
        return self.name if self.kind in ("person", "robot") else f"the {self.name}"

    @property
    def centre(self) -> Point:
        """The middle of its extent."""
        return (self.x_m[0] + self.x_m[1]) / 2.0, (self.y_m[0] + self.y_m[1]) / 2.0

    def contains(self, point: Point, margin_m: float = 0.0) -> bool:
        """Whether a point is inside its extent."""
        return (
            self.x_m[0] - margin_m <= point[0] <= self.x_m[1] + margin_m
            and self.y_m[0] - margin_m <= point[1] <= self.y_m[1] + margin_m
        )

    def distance_m(self, point: Point) -> float:
        """The distance of a point from its extent; 0 inside."""
        return math.hypot(
            max(self.x_m[0] - point[0], 0.0, point[0] - self.x_m[1]),
            max(self.y_m[0] - point[1], 0.0, point[1] - self.y_m[1]),
        )


@dataclass(frozen=True)
class Place:
    """Where a thing is.

    Attributes:
        relation: one of :data:`RELATIONS`; "on" with a room as holder is the floor of the room
        holder: id of a room, of furniture, of another thing or of a person, or :data:`ROBOT`
        x_m, y_m: position; of things that are held or in other things the position of the holder counts
    """

    relation: str
    holder: str
    x_m: float = 0.0
    y_m: float = 0.0


@dataclass(frozen=True)
class RobotState:
    """The robot.

    Attributes:
        pose: of its base
        lift_m: height of the lift, 0 to the limit of the plan
        arm: tucked, extended or the name of the last gesture
        is_docked: whether it stands in its station
        battery: 0 to 1
        scanned_s: when it last looked all round
        looks_at: id of what it looks at; empty: ahead
    """

    pose: Pose = Pose()
    lift_m: float = 0.0
    arm: str = "tucked"
    is_docked: bool = False
    battery: float = 0.6
    scanned_s: float = -math.inf
    looks_at: str = ""


@dataclass(frozen=True)
class PersonState:
    """A person.

    Attributes:
        pose: on the floor
        posture: standing, sitting or walking
        follows: id of whom the person follows: :data:`ROBOT` or a person; empty for nobody
    """

    pose: Pose
    posture: str = "standing"
    follows: str = ""


@dataclass(frozen=True)
class Event:
    """What happened and leaves no other trace: a text that was said, a gesture, a picture.

    Attributes:
        time_s: when
        kind: said, gesture, photo, reminder
        who: who did it
        what: the text, the gesture, the ids on the picture
        to: ids of those who heard or saw it
    """

    time_s: float
    kind: str
    who: str
    what: str
    to: Tuple[str, ...] = ()


@dataclass(frozen=True)
class State:
    """What can change. The mappings must not be changed."""

    robot: RobotState = RobotState()
    places: Mapping[str, Place] = field(default_factory=dict)
    people: Mapping[str, PersonState] = field(default_factory=dict)
    properties: Mapping[str, Mapping[str, Value]] = field(default_factory=dict)
    events: Tuple[Event, ...] = ()
    time_s: float = 0.0

    #: So many events are kept.
    MOST_EVENTS = 200

    def get(self, entity: str, name: str, default: Value = "") -> Value:
        """Return a property of an entity: "is_open", "is_on", "level", ..."""
        return self.properties.get(entity, {}).get(name, default)

    def is_(self, entity: str, name: str) -> bool:
        """Whether a property is true."""
        return self.get(entity, name, False) is True

    def number(self, entity: str, name: str, default: float = 0.0) -> float:
        """Return a property that is a number."""
        value = self.get(entity, name, default)
        return default if isinstance(value, str) else float(value)

    def with_property(self, entity: str, **values: Value) -> "State":
        """Return a state in which an entity has other properties."""
        properties: Dict[str, Mapping[str, Value]] = dict(self.properties)
        properties[entity] = {**self.properties.get(entity, {}), **values}
        return replace(self, properties=properties)

    def with_place(self, thing: str, place: Place) -> "State":
        """Return a state in which a thing is elsewhere."""
        return replace(self, places={**self.places, thing: place})

    def with_person(self, person: str, **values: object) -> "State":
        """Return a state in which a person is otherwise."""
        changed = replace(self.people[person], **values)  # type: ignore[arg-type]
        return replace(self, people={**self.people, person: changed})

    def with_robot(self, **values: object) -> "State":
        """Return a state in which the robot is otherwise."""
        return replace(self, robot=replace(self.robot, **values))  # type: ignore[arg-type]

    def with_event(self, kind: str, who: str, what: str, to: Tuple[str, ...] = ()) -> "State":
        """Return a state in which something happened now."""
        event = Event(self.time_s, kind, who, what, to)
        return replace(self, events=(self.events + (event,))[-self.MOST_EVENTS :])

    def held_by(self, holder: str) -> Tuple[str, ...]:
        """Return the ids of what the robot or a person holds."""
        return tuple(
            ident for ident, place in self.places.items() if place == Place("held", holder, place.x_m, place.y_m)
        )

    def at(self, holder: str, relation: str = "") -> Tuple[str, ...]:
        """Return the ids of what is on, in, ... something; with any relation when none is given."""
        return tuple(
            ident
            for ident, place in self.places.items()
            if place.holder == holder and (not relation or place.relation == relation)
        )


@dataclass(frozen=True)
class Faults:
    """How often something goes wrong, as probabilities.

    Attributes:
        slip: a thing slips out of the gripper, and falls to the floor if the gripper held it
        blocked_door: a door on the way is blocked for a while

    Raises:
        ValueError: a probability is not 0 to 1
    """

    slip: float = 0.0
    blocked_door: float = 0.0

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if not 0.0 <= value <= 1.0:
                raise ValueError(f"{name} must be 0 to 1, got {value!r}")


NO_FAULTS = Faults()


@dataclass(frozen=True)
class RobotLimits:
    """What a robot can do. The numbers are near those of a PR2.

    Attributes:
        hands: number of grippers; 0 for a robot without arms
        reach_m: distance from the middle of the base to a thing that the arm reaches
        lowest_m, highest_m: of what the arm reaches with the lift down; the lift raises both
        lift_m: height of the raised lift
        most_kg: mass that the arm lifts
        most_pushed_kg: mass that the base pushes or pulls
        sight_m: how far it recognises things
        person_sight_m: how far it recognises persons, furniture and doors
        view_rad: width of what it sees ahead
        radius_m: of the base
    """

    hands: int = 2
    reach_m: float = 1.1
    lowest_m: float = -0.05
    highest_m: float = 1.4
    lift_m: float = 0.35
    most_kg: float = 2.5
    most_pushed_kg: float = 40.0
    sight_m: float = 4.5
    person_sight_m: float = 8.0
    view_rad: float = 2.1
    radius_m: float = 0.33


#: A robot with two arms and a lift, and one that only drives.
PR2 = RobotLimits()
TURTLEBOT = RobotLimits(hands=0, radius_m=0.26)


@dataclass(frozen=True)
class Plan:
    """What never changes in a home, and the limits of the robot in it."""

    entities: Mapping[str, Entity]
    robot: RobotLimits = PR2
    #: What persons answer: (person, what is asked for) to text.
    answers: Mapping[Tuple[str, str], str] = field(default_factory=dict)
    #: Where persons go by turns: ids of furniture and rooms.
    habits: Mapping[str, Tuple[str, ...]] = field(default_factory=dict)

    def of_kind(self, kind: str) -> Tuple[Entity, ...]:
        """Return the entities of a kind; whoever drives asks for doors at each step."""
        return self._by_kind.get(kind, ())

    @cached_property
    def _by_kind(self) -> Mapping[str, Tuple[Entity, ...]]:
        kinds = {entity.kind for entity in self.entities.values()}
        return {kind: tuple(one for one in self.entities.values() if one.kind == kind) for kind in kinds}

    def room_at(self, point: Point) -> str:
        """Return the id of the room of a point; empty outside."""
        return next((room.id for room in self.of_kind("room") if room.contains(point)), "")

    def position(self, state: State, entity: str) -> Point:
        """Return where an entity is: things that are held or inside are where their holder is."""
        for _ in range(8):
            if entity == ROBOT:
                return state.robot.pose.x_m, state.robot.pose.y_m
            if entity in state.people:
                pose = state.people[entity].pose
                return pose.x_m, pose.y_m
            place = state.places.get(entity)
            if place is None:
                return self.entities[entity].centre
            holder = self.entities.get(place.holder)
            if place.relation != "held" and holder is not None and holder.kind in ("room", "furniture"):
                return place.x_m, place.y_m
            entity = place.holder
        raise ValueError(f"{entity} is inside itself")

    def height_m(self, state: State, entity: str) -> float:
        """Return how high something is that the hand must reach."""
        for _ in range(8):
            place = state.places.get(entity)
            if place is None:
                break
            if place.relation in ("under", "beside", "behind", "in_front_of"):
                return 0.05
            entity = place.holder
        if entity == ROBOT or entity in state.people:
            return 1.0
        return self.entities[entity].height_m

    def holders(self, state: State, thing: str) -> List[Place]:
        """Return the place of a thing, the place of its holder, and so on, up to furniture, a room or a person."""
        found: List[Place] = []
        place: Optional[Place] = state.places.get(thing)
        while place is not None and len(found) < 8:
            found.append(place)
            place = state.places.get(place.holder)
        return found
