"""Named places: remembers them, keeps them in a file, and finds them again."""

import math
import os
import tempfile
from dataclasses import dataclass
from typing import Any, Dict, Mapping

import yaml


@dataclass(frozen=True)
class Location:
    """A pose on the floor.

    Attributes:
        frame_id: coordinate frame, "map"
        x_m: position in metres
        y_m: position in metres
        heading_rad: counter-clockwise from the x axis (REP 103)
    """

    frame_id: str
    x_m: float
    y_m: float
    heading_rad: float

    def __post_init__(self) -> None:
        if not all(math.isfinite(value) for value in (self.x_m, self.y_m, self.heading_rad)):
            raise ValueError(f"a location needs finite numbers, got {self.x_m}, {self.y_m}, {self.heading_rad}")
        if not self.frame_id:
            raise ValueError("a location needs the name of its coordinate frame")


class LocationFileError(ValueError):
    """A file of places cannot be read; the message names the file, the place and what was expected."""


def read_locations(path: str) -> Dict[str, Location]:
    """Read a file of places; the names come as they are in the file.

    The file maps each name to ``x`` and ``y`` in metres and, if they matter, ``heading`` in radians and ``frame_id``::

        office: {x: 3.0, y: 1.5, heading: 1.57}

    Raises:
        LocationFileError: the file has another form
        OSError: the file cannot be read
    """
    with open(path, encoding="utf-8") as file:
        try:
            document = yaml.safe_load(file)
        except yaml.YAMLError as error:
            raise LocationFileError(f"{path}: not YAML: {error}") from error
        except UnicodeDecodeError as error:
            raise LocationFileError(f"{path}: not UTF-8: {error}") from error
    if document is None:
        return {}
    if not isinstance(document, dict):
        raise LocationFileError(f"{path}: expected a mapping of names to places, found {type(document).__name__}")
    return {str(name): _location(path, str(name), entry) for name, entry in document.items()}


def _location(path: str, name: str, entry: Any) -> Location:
    known = {"x", "y", "heading", "frame_id"}
    if not isinstance(entry, dict) or not {"x", "y"} <= set(entry) <= known:
        raise LocationFileError(
            f"{path}: place '{name}' needs x and y and may have heading and frame_id, found {entry}"
        )
    try:
        return Location(
            frame_id=str(entry.get("frame_id", "map")),
            x_m=float(entry["x"]),
            y_m=float(entry["y"]),
            heading_rad=float(entry.get("heading", 0.0)),
        )
    except (TypeError, ValueError) as error:
        raise LocationFileError(f"{path}: place '{name}': {error}") from error


def write_locations(locations: Mapping[str, Location], path: str) -> None:
    """Write a file of places. An existing file is replaced as a whole or not at all; a link to it stays a link.

    Raises:
        OSError: the file cannot be written
    """
    document = {
        name: {"x": location.x_m, "y": location.y_m, "heading": location.heading_rad, "frame_id": location.frame_id}
        for name, location in sorted(locations.items())
    }
    path = os.path.realpath(path)
    folder = os.path.dirname(path)
    os.makedirs(folder, exist_ok=True)
    with tempfile.NamedTemporaryFile("w", dir=folder, delete=False, encoding="utf-8") as file:
        yaml.safe_dump(document, file, sort_keys=True)
        file.flush()
        os.fsync(file.fileno())
    os.replace(file.name, path)
