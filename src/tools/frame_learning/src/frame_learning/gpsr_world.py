"""Reads what the generators of RoboCup@Home fill slots with: names, rooms, furniture, objects and gestures."""

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, List, Mapping, Optional, Tuple
from xml.etree import ElementTree

from frame_learning.annotated_commands import CorpusError


@dataclass(frozen=True)
class Value:
    """What may fill a slot.

    Attributes:
        text: as it is said
        group: the room of a place, or the category of an object; said where the value is obscured
        properties: attributes of the file, with lower-case names
    """

    text: str
    group: str = ""
    properties: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class World:
    """The values of each kind of slot: name, room, place, object, category, gesture, whattosay."""

    values: Mapping[str, Tuple[Value, ...]]

    def of(self, kind: str) -> Tuple[Value, ...]:
        """Return the values of a kind."""
        return self.values.get(kind, ())


def read_world(folder: Path) -> World:
    """Read the files beside a grammar; a file that is missing gives no values.

    Raises:
        CorpusError: a file cannot be read
    """
    names = [
        Value((element.text or "").strip(), "", {"gender": element.get("gender", "").lower()})
        for element in _elements(folder, "names.xml", "name")
    ]
    rooms: List[Value] = []
    places: List[Value] = []
    for room in _elements(folder, "locations.xml", "room"):
        rooms.append(Value(room.get("name", "")))
        places += [_value(place, room.get("name", "")) for place in room.iter("location")]
    categories: Dict[str, Value] = {}
    objects: List[Value] = []
    for category in _elements(folder, "objects.xml", "category"):
        name = category.get("name", "")
        categories[name] = Value(name)
        objects += [_value(element, name) for element in category.iter("object")]
    said = _beside(folder, "whattosay.txt")
    return World(
        {
            "name": tuple(names),
            "room": tuple(rooms),
            "place": tuple(places),
            "object": tuple(objects),
            "category": tuple(categories.values()),
            "gesture": tuple(_value(element, "") for element in _elements(folder, "gestures.xml", "gesture")),
            "whattosay": tuple(Value(line.strip()) for line in _text(said).splitlines() if line.strip()),
        }
    )


def _value(element: ElementTree.Element, group: str) -> Value:
    properties = {name.lower(): text for name, text in element.attrib.items()}
    return Value(element.get("name", ""), group, {**properties, "category": group})


def _elements(folder: Path, name: str, tag: str) -> Tuple[ElementTree.Element, ...]:
    path = _beside(folder, name)
    text = _text(path)
    if not text:
        return ()
    try:
        return tuple(ElementTree.fromstring(text).iter(tag))
    except ElementTree.ParseError as error:
        raise CorpusError(f"{path}: no XML: {error}") from error


def _beside(folder: Path, name: str) -> Optional[Path]:
    return next((path for path in sorted(folder.iterdir()) if path.name.lower() == name), None)


def _text(path: Optional[Path]) -> str:
    """Return the text of a file. A checkout without symbolic links has the path of the target as text instead."""
    if path is None:
        return ""
    try:
        text = path.read_text(encoding="utf-8-sig")
        if re.fullmatch(r"[\w./-]+\.(?:xml|txt)", text.strip()):
            text = (path.parent / text.strip()).read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise CorpusError(f"{path}: cannot be read: {error!r}") from error
    return re.sub(r"^\s*<\?xml[^>]*\?>", "", text)
