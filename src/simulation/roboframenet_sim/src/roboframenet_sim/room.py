"""A room: walls and boxes, read from YAML."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, Dict, List, Sequence, Tuple, Type, TypeVar, cast

import numpy as np
import yaml

if TYPE_CHECKING:
    from numpy.typing import NDArray

Value = TypeVar("Value")


class RoomError(ValueError):
    """The room file is wrong; the message names the file, the line, the key, and what was expected."""

    def __init__(self, *, path: str, line: int, key: str, message: str) -> None:
        super().__init__(f"{path}:{line}: {key}: {message}")
        self.line = line
        self.key = key


@dataclass(frozen=True)
class Box:
    """A rectangular obstacle with sides along x and y."""

    name: str
    x_m: Tuple[float, float]
    y_m: Tuple[float, float]


@dataclass(frozen=True)
class Room:
    """A floor plan in the frame "map". Walls are (x, y, x, y) from one point to another."""

    resolution_m: float
    wall_thickness_m: float
    x_m: Tuple[float, float]
    y_m: Tuple[float, float]
    walls: Tuple[Tuple[float, float, float, float], ...]
    boxes: Tuple[Box, ...]

    def all_walls(self) -> "NDArray[np.float64]":
        """Return the walls, the outer walls and the sides of the boxes, as an (n, 4) array."""
        rectangles = [(self.x_m, self.y_m)] + [(box.x_m, box.y_m) for box in self.boxes]
        sides: List[Sequence[float]] = list(self.walls)
        for (left, right), (low, high) in rectangles:
            sides += [
                (left, low, right, low),
                (right, low, right, high),
                (right, high, left, high),
                (left, high, left, low),
            ]
        return np.array(sides, dtype=float)


class YamlReader:
    """Reads YAML nodes, and says which one is wrong.

    Args:
        path: of the file, for messages
        error_class: what is raised
    """

    def __init__(self, path: str, *, error_class: Type["RoomError"] = RoomError) -> None:
        self._path = path
        self._error_class = error_class

    def error(self, node: yaml.Node, key: str, message: str) -> RoomError:
        """Return an error that names the place of a node."""
        return self._error_class(path=self._path, line=node.start_mark.line + 1, key=key, message=message)

    def root(self, text: str) -> yaml.Node:
        """Read the whole file."""
        try:
            root = yaml.compose(text, Loader=yaml.SafeLoader)
        except yaml.MarkedYAMLError as error:
            line = error.problem_mark.line + 1 if error.problem_mark else 1
            raise self._error_class(path=self._path, line=line, key="-", message=f"no YAML: {error.problem}") from error
        if root is None:
            raise self._error_class(path=self._path, line=1, key="-", message="empty file")
        return cast("yaml.Node", root)

    def mapping(self, node: yaml.Node, key: str, *, keys: Sequence[str] = ()) -> Dict[str, yaml.Node]:
        """Read a mapping, with exactly the given keys if there are any."""
        if not isinstance(node, yaml.MappingNode):
            raise self.error(node, key, "expected a mapping")
        result: Dict[str, yaml.Node] = {}
        for key_node, value in node.value:
            name = str(key_node.value)
            if name in result:
                raise self.error(key_node, name, "written twice")
            if keys and name not in keys:
                raise self.error(key_node, name, "unknown key, expected one of: {}".format(", ".join(keys)))
            result[name] = value
        missing = [name for name in keys if name not in result]
        if missing:
            raise self.error(node, key, "missing: {}".format(", ".join(missing)))
        return result

    def number(self, node: yaml.Node, key: str) -> float:
        """Read a finite number."""
        try:
            value = float(node.value) if isinstance(node, yaml.ScalarNode) else math.nan
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise self.error(node, key, f"expected a finite number, found {node.value!r}")
        return value

    def numbers(self, node: yaml.Node, key: str, *, count: int) -> Tuple[float, ...]:
        """Read a list of a given number of finite numbers."""
        if not isinstance(node, yaml.SequenceNode) or len(node.value) != count:
            raise self.error(node, key, f"expected a list of {count} numbers")
        return tuple(self.number(entry, key) for entry in node.value)

    def span(self, node: yaml.Node, key: str) -> Tuple[float, float]:
        """Read a pair of numbers, the smaller first."""
        low, high = self.numbers(node, key, count=2)
        if low >= high:
            raise self.error(node, key, f"expected the smaller number first, found {low:g}, {high:g}")
        return low, high

    def positive(self, node: yaml.Node, key: str) -> float:
        """Read a positive number."""
        value = self.number(node, key)
        if value <= 0.0:
            raise self.error(node, key, f"expected a positive number, found {value:g}")
        return value

    def items(self, node: yaml.Node, key: str, read: Callable[[yaml.Node], Value]) -> Tuple[Value, ...]:
        """Read a list."""
        if not isinstance(node, yaml.SequenceNode):
            raise self.error(node, key, "expected a list")
        return tuple(read(entry) for entry in node.value)


def load_room(text: str, *, path: str) -> Room:
    """Read a room.

    Args:
        text: YAML with the keys of :class:`Room`'s fields; see ``config/room.yaml``
        path: for messages
    Raises:
        RoomError: the file is wrong; the message names the first mistake
    """
    reader = YamlReader(path)
    root = reader.root(text)
    top = reader.mapping(root, "room", keys=("resolution_m", "wall_thickness_m", "bounds", "walls", "boxes"))
    bounds = reader.mapping(top["bounds"], "bounds", keys=("x_m", "y_m"))
    x_m, y_m = reader.span(bounds["x_m"], "bounds/x_m"), reader.span(bounds["y_m"], "bounds/y_m")

    def read_wall(node: yaml.Node) -> Tuple[float, float, float, float]:
        from_x_m, from_y_m, to_x_m, to_y_m = reader.numbers(node, "walls", count=4)
        return from_x_m, from_y_m, to_x_m, to_y_m

    def read_box(node: yaml.Node) -> Box:
        entry = reader.mapping(node, "boxes", keys=("name", "x_m", "y_m"))
        return Box(
            name=str(entry["name"].value),
            x_m=reader.span(entry["x_m"], "boxes/x_m"),
            y_m=reader.span(entry["y_m"], "boxes/y_m"),
        )

    resolution_m = reader.positive(top["resolution_m"], "resolution_m")
    if (x_m[1] - x_m[0]) * (y_m[1] - y_m[0]) / resolution_m**2 > 4e6:
        raise reader.error(top["resolution_m"], "resolution_m", "more than four million cells")
    return Room(
        resolution_m=resolution_m,
        wall_thickness_m=reader.positive(top["wall_thickness_m"], "wall_thickness_m"),
        x_m=x_m,
        y_m=y_m,
        walls=reader.items(top["walls"], "walls", read_wall),
        boxes=reader.items(top["boxes"], "boxes", read_box),
    )


def load_room_file(path: str) -> Room:
    """Read a room from a file.

    Raises:
        RoomError: the content is wrong
        OSError: the file cannot be read
    """
    with open(path, encoding="utf-8") as file:
        return load_room(file.read(), path=path)
