"""Reads a home from YAML; `config/home.yaml` is an example. Every mistake is reported with its line and key."""

from typing import Dict, FrozenSet, List, Mapping, Sequence, Tuple

import yaml

from roboframenet_sim.base import Pose
from roboframenet_sim.home_state import PR2, Entity, PersonState, Place, Plan, RobotLimits, RobotState, State, Value
from roboframenet_sim.room import RoomError, YamlReader

#: What can be done with furniture and things, and what they are good for.
TRAITS = frozenset(
    "surface container closable lockable switch settable seat rack water heats bakes washes washable dish vessel food "
    "cloth cuts cleans dries sweeps stirs irons raisable attachable station button screen light hot trash toy "
    "flat".split()
)
#: Properties that the file may give, with their types; whoever has another trait gets them by it.
PROPERTIES: Dict[str, type] = {
    "is_open": bool,
    "is_locked": bool,
    "is_on": bool,
    "is_dirty": bool,
    "is_wet": bool,
    "is_unplugged": bool,
    "is_up": bool,
    "level": float,
    "setting": str,
    "contents": str,
    "attached_to": str,
}
_COMMON = ("names", "category", "traits", "color", "size", *PROPERTIES)
_KEYS: Dict[str, Tuple[str, ...]] = {
    "rooms": ("names", "x_m", "y_m", "is_dirty"),
    "doors": ("names", "rooms", "from", "to", "passage", "is_open", "is_locked"),
    "furniture": (*_COMMON, "room", "x_m", "y_m", "height_m", "tall"),
    "things": (*_COMMON, "on", "in", "under", "beside", "x", "y", "mass_kg"),
    "persons": ("names", "x", "y", "heading", "posture", "habit", "answers"),
}


class HomeError(RoomError):
    """The home file is wrong; the message names the file, the line, the key, and what was expected."""


class _HomeReader:
    """Reads one file."""

    def __init__(self, text: str, path: str) -> None:
        self.yaml = YamlReader(path, error_class=HomeError)
        self.top = self.yaml.mapping(self.yaml.root(text), "home", keys=("robot", *_KEYS))
        self.entities: Dict[str, Entity] = {}
        self.nodes: Dict[str, yaml.Node] = {}
        self.properties: Dict[str, Mapping[str, Value]] = {}

    def entries(self, section: str) -> "List[Tuple[str, Dict[str, yaml.Node]]]":
        """Read the entries of a section; each id is unique in the file."""
        found = []
        for ident, node in self.yaml.mapping(self.top[section], section).items():
            if ident in self.nodes or ident == "robot":
                raise self.yaml.error(node, ident, "this id is used already")
            entry = self.yaml.mapping(node, ident)
            for key, value in entry.items():
                if key not in _KEYS[section]:
                    expected = ", ".join(_KEYS[section])
                    raise self.yaml.error(value, f"{ident}/{key}", f"unknown key, expected one of: {expected}")
            self.nodes[ident] = node
            found.append((ident, entry))
        return found

    def need(self, ident: str, entry: Mapping[str, yaml.Node], key: str) -> yaml.Node:
        """Return a value that must be there."""
        if key not in entry:
            raise self.yaml.error(self.nodes[ident], ident, f"missing: {key}")
        return entry[key]

    def text(self, node: yaml.Node, key: str) -> str:
        """Read a text that is not empty."""
        if not isinstance(node, yaml.ScalarNode) or not node.value:
            raise self.yaml.error(node, key, "expected a word")
        return str(node.value)

    def flag(self, node: yaml.Node, key: str) -> bool:
        """Read true or false."""
        if not isinstance(node, yaml.ScalarNode) or node.value not in ("true", "false"):
            raise self.yaml.error(node, key, "expected true or false")
        return bool(node.value == "true")

    def texts(self, node: yaml.Node, key: str) -> Tuple[str, ...]:
        """Read a list of texts."""
        return self.yaml.items(node, key, lambda one: self.text(one, key))

    def names(self, ident: str, entry: Mapping[str, yaml.Node]) -> Tuple[str, ...]:
        """Read the names, one at least."""
        names = self.texts(self.need(ident, entry, "names"), f"{ident}/names")
        if not names:
            raise self.yaml.error(entry["names"], f"{ident}/names", "expected one name at least")
        return names

    def traits(self, ident: str, entry: Mapping[str, yaml.Node]) -> FrozenSet[str]:
        """Read the traits."""
        traits = self.texts(entry["traits"], f"{ident}/traits") if "traits" in entry else ()
        unknown = sorted(set(traits) - TRAITS)
        if unknown:
            expected = ", ".join(sorted(TRAITS))
            message = f"unknown: {unknown[0]}; expected one of: {expected}"
            raise self.yaml.error(entry["traits"], f"{ident}/traits", message)
        return frozenset(traits)

    def read_properties(self, ident: str, entry: Mapping[str, yaml.Node]) -> None:
        """Read what can change."""
        values: Dict[str, Value] = {}
        for key, kind in PROPERTIES.items():
            if key in entry:
                node, where = entry[key], f"{ident}/{key}"
                values[key] = (
                    self.flag(node, where)
                    if kind is bool
                    else self.yaml.number(node, where)
                    if kind is float
                    else self.text(node, where)
                )
        if values:
            self.properties[ident] = values

    def known(self, node: yaml.Node, key: str, kinds: Sequence[str]) -> str:
        """Read the id of an entity that was read before."""
        ident = self.text(node, key)
        if ident not in self.entities or self.entities[ident].kind not in kinds:
            raise self.yaml.error(node, key, f"there is no {' or '.join(kinds)} {ident!r} above")
        return ident

    def read_rooms(self) -> None:
        """Read the rooms."""
        for ident, entry in self.entries("rooms"):
            self.entities[ident] = Entity(
                ident,
                "room",
                self.names(ident, entry),
                category="room",
                x_m=self.yaml.span(self.need(ident, entry, "x_m"), f"{ident}/x_m"),
                y_m=self.yaml.span(self.need(ident, entry, "y_m"), f"{ident}/y_m"),
            )
            self.read_properties(ident, entry)

    def read_doors(self) -> None:
        """Read the doors."""
        for ident, entry in self.entries("doors"):
            begin = self.yaml.numbers(self.need(ident, entry, "from"), f"{ident}/from", count=2)
            end = self.yaml.numbers(self.need(ident, entry, "to"), f"{ident}/to", count=2)
            if (begin[0] == end[0]) == (begin[1] == end[1]):
                raise self.yaml.error(self.nodes[ident], ident, "a door goes along x or along y")
            rooms_node = self.need(ident, entry, "rooms")
            rooms = self.yaml.items(rooms_node, f"{ident}/rooms", lambda one: self.known(one, "rooms", ["room"]))
            if not 1 <= len(rooms) <= 2:
                raise self.yaml.error(rooms_node, f"{ident}/rooms", "expected one room or two")
            is_passage = "passage" in entry and self.flag(entry["passage"], f"{ident}/passage")
            self.entities[ident] = Entity(
                ident,
                "door",
                self.names(ident, entry),
                category="door",
                traits=frozenset(["open"] if is_passage else ["closable", "lockable"]),
                x_m=(min(begin[0], end[0]), max(begin[0], end[0])),
                y_m=(min(begin[1], end[1]), max(begin[1], end[1])),
                height_m=1.0,
                rooms=rooms,
            )
            self.read_properties(ident, entry)

    def read_furniture(self) -> None:
        """Read the furniture and the devices that do not move."""
        for ident, entry in self.entries("furniture"):
            room = self.known(self.need(ident, entry, "room"), f"{ident}/room", ["room"])
            x_m = self.yaml.span(self.need(ident, entry, "x_m"), f"{ident}/x_m")
            y_m = self.yaml.span(self.need(ident, entry, "y_m"), f"{ident}/y_m")
            corners = [(x, y) for x in x_m for y in y_m]
            if not all(self.entities[room].contains(corner, 1e-6) for corner in corners):
                raise self.yaml.error(self.nodes[ident], ident, f"does not stand inside {room}")
            self.entities[ident] = Entity(
                ident,
                "furniture",
                self.names(ident, entry),
                category=self.text(entry["category"], f"{ident}/category") if "category" in entry else ident,
                traits=self.traits(ident, entry),
                attributes=self.attributes(ident, entry),
                room=room,
                x_m=x_m,
                y_m=y_m,
                height_m=self.yaml.number(self.need(ident, entry, "height_m"), f"{ident}/height_m"),
                is_tall="tall" in entry and self.flag(entry["tall"], f"{ident}/tall"),
            )
            self.read_properties(ident, entry)

    def attributes(self, ident: str, entry: Mapping[str, yaml.Node]) -> Tuple[Tuple[str, str], ...]:
        """Read colour and size."""
        return tuple((key, self.text(entry[key], f"{ident}/{key}")) for key in ("color", "size") if key in entry)

    def read_things(self) -> Dict[str, Place]:
        """Read the things, and where they are."""
        places: Dict[str, Place] = {}
        counts: Dict[str, int] = {}
        for ident, entry in self.entries("things"):
            where = [key for key in ("on", "in", "under", "beside") if key in entry]
            if len(where) != 1:
                raise self.yaml.error(self.nodes[ident], ident, "expected exactly one of: on, in, under, beside")
            relation = where[0]
            key = f"{ident}/{relation}"
            holder = self.known(entry[relation], key, ["room", "furniture", "thing"])
            trait = {"on": "surface", "in": "container"}.get(relation)
            entity = self.entities[holder]
            if entity.kind != "room" and trait and trait not in entity.traits:
                raise self.yaml.error(entry[relation], key, f"{holder} is no {trait}")
            x_m, y_m = self._spot(entry, entity, counts, ident)
            places[ident] = Place(relation, holder, x_m, y_m)
            mass_kg = self.yaml.positive(entry["mass_kg"], f"{ident}/mass_kg") if "mass_kg" in entry else 0.3
            self.entities[ident] = Entity(
                ident,
                "thing",
                self.names(ident, entry),
                category=self.text(self.need(ident, entry, "category"), f"{ident}/category"),
                traits=self.traits(ident, entry),
                attributes=self.attributes(ident, entry),
                mass_kg=mass_kg,
                height_m=0.3 if mass_kg >= 5.0 else 0.0,
            )
            self.read_properties(ident, entry)
        return places

    def _spot(
        self, entry: Mapping[str, yaml.Node], holder: Entity, counts: Dict[str, int], ident: str
    ) -> Tuple[float, float]:
        """Return where a thing stands: as the file says, or beside the one before."""
        if "x" in entry or "y" in entry:
            point = (
                self.yaml.number(self.need(ident, entry, "x"), "x"),
                self.yaml.number(self.need(ident, entry, "y"), "y"),
            )
            if not holder.contains(point):
                raise self.yaml.error(self.nodes[ident], ident, f"is not inside {holder.id}")
            return point
        if holder.kind == "room":
            raise self.yaml.error(self.nodes[ident], ident, "missing: x, y (a thing on the floor has a place)")
        if holder.kind == "thing":
            return 0.0, 0.0
        counts[holder.id] = counts.get(holder.id, -1) + 1
        columns = 4
        width, depth = holder.x_m[1] - holder.x_m[0], holder.y_m[1] - holder.y_m[0]
        row, column = divmod(counts[holder.id], columns)
        along, across = (column + 0.5) / columns, min(0.9, 0.35 + 0.3 * row)
        if width >= depth:
            return holder.x_m[0] + along * width, holder.y_m[0] + across * depth
        return holder.x_m[0] + across * width, holder.y_m[0] + along * depth

    def read_persons(self) -> Tuple[Dict[str, PersonState], Dict[Tuple[str, str], str], Dict[str, Tuple[str, ...]]]:
        """Read the persons: where they are, what they answer, where they go."""
        people: Dict[str, PersonState] = {}
        answers: Dict[Tuple[str, str], str] = {}
        habits: Dict[str, Tuple[str, ...]] = {}
        for ident, entry in self.entries("persons"):
            pose = Pose(
                *(self.yaml.number(self.need(ident, entry, key), f"{ident}/{key}") for key in ("x", "y", "heading"))
            )
            posture = self.text(entry["posture"], f"{ident}/posture") if "posture" in entry else "standing"
            if posture not in ("standing", "sitting"):
                raise self.yaml.error(entry["posture"], f"{ident}/posture", "expected standing or sitting")
            self.entities[ident] = Entity(ident, "person", self.names(ident, entry), category="person", height_m=1.0)
            people[ident] = PersonState(pose, posture)
            if "habit" in entry:
                habits[ident] = self.yaml.items(
                    entry["habit"], f"{ident}/habit", lambda one: self.known(one, "habit", ["room", "furniture"])
                )
            if "answers" in entry:
                for about, node in self.yaml.mapping(entry["answers"], f"{ident}/answers").items():
                    answers[ident, about] = self.text(node, f"{ident}/answers/{about}")
        return people, answers, habits


def load_home(text: str, *, path: str, robot: RobotLimits = PR2) -> Tuple[Plan, State]:
    """Read a home.

    Args:
        text: YAML; see the README
        path: for messages
        robot: what the robot can do
    Returns:
        what never changes, and what is at the beginning
    Raises:
        HomeError: the file is wrong; the message names the first mistake
    """
    reader = _HomeReader(text, path)
    start = reader.yaml.mapping(reader.top["robot"], "robot", keys=("x", "y", "heading"))
    pose = Pose(*(reader.yaml.number(start[key], f"robot/{key}") for key in ("x", "y", "heading")))
    reader.read_rooms()
    reader.read_doors()
    reader.read_furniture()
    places = reader.read_things()
    people, answers, habits = reader.read_persons()
    plan = Plan(entities=reader.entities, robot=robot, answers=answers, habits=habits)
    for point, node, name in [((pose.x_m, pose.y_m), reader.top["robot"], "robot")] + [
        ((one.pose.x_m, one.pose.y_m), reader.nodes[ident], ident) for ident, one in people.items()
    ]:
        if not plan.room_at(point):
            raise reader.yaml.error(node, name, "stands in no room")
    state = State(robot=RobotState(pose=pose), places=places, people=people, properties=reader.properties)
    return plan, state


def load_home_file(path: str, *, robot: RobotLimits = PR2) -> Tuple[Plan, State]:
    """Read a home from a file; see :func:`load_home`.

    Raises:
        HomeError: the content is wrong
        OSError: the file cannot be read
    """
    with open(path, encoding="utf-8") as file:
        return load_home(file.read(), path=path, robot=robot)
