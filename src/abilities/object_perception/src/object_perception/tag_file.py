"""Reads the file of tags: which objects carry which tags, and where on them::

    objects:
      fridge_1:
        size: [0.6, 0.6, 1.8]
        tags:
          7: {y: -1.2}
      box_1:
        attributes: [blue]
        tags:
          11: {z: -0.1, y: -0.1}
          12: {z: -0.1, y: -0.1, yaw: 3.14159}

The numbers of a tag say where the middle of the bottom of the object is as the tag has it: x to the right, y up, and z
out of the tag, towards who reads it; metres and radians.
"""

import math
from dataclasses import dataclass, replace
from typing import Dict, List, Optional, Sequence, Tuple

import yaml

from checked_files.marked_yaml import Reader
from object_perception.beliefs import Sighting
from object_perception.geometry import Transform, about_z, of_roll_pitch_yaw, turned
from world_model.world_object import Pose, Sort, WorldObject, mistakes, words_of_id

_OBJECT_KEYS = ("name", "category", "attributes", "sort", "size", "tags")
_TAG_KEYS = ("x", "y", "z", "roll", "pitch", "yaw")
_SORTS = ("thing", "person", "door", "device")
#: Tags of all families have fewer numbers.
_MOST = 65535


@dataclass(frozen=True)
class Tagged:
    """The object that carries a tag, and where it is as the tag has it."""

    about: WorldObject
    offset: Transform


@dataclass(frozen=True)
class SeenTag:
    """A tag that was read: its number, and where it is in the frame of the camera."""

    number: int
    place: Transform


def sightings_of_tags(
    tags: Sequence[SeenTag], known: Dict[int, Tagged], place: Transform, *, score: float, world_frame: str
) -> List[Sighting]:
    """Return the objects whose tags were read; tags that no file names are left out.

    Args:
        tags: that one image showed
        known: by number
        place: where the frame of the camera is in the world
        score: how sure a reading is
        world_frame: name of the frame of the world
    """
    found = []
    for tag in tags:
        tagged = known.get(tag.number)
        if tagged is None or not tag.place.is_rigid:
            continue
        there = place.then(tag.place).then(tagged.offset)
        x, y, z = there.position
        ahead = turned((1.0, 0.0, 0.0), there.turn)
        pose = Pose(world_frame, x, y, z, about_z(math.atan2(ahead[1], ahead[0])))
        found.append(Sighting(replace(tagged.about, pose=pose), score))
    return found


def load_tag_file(text: str, path: str) -> Dict[int, Tagged]:
    """Read a file of tags.

    Args:
        text: content of the file
        path: where it came from, for problems
    Returns:
        what carries each tag, by its number
    Raises:
        FileRefused: the file has mistakes; the exception carries all of them
    """
    reader = Reader(path)
    expected = "a mapping with objects"
    root = reader.mapping(reader.compose(text, expected), "", ("objects",), required=("objects",))
    found: Dict[int, Tagged] = {}
    for id_node, node in reader.free_mapping(root.get("objects"), "objects"):
        name = reader.name(id_node, "objects")
        key = f"objects.{name}"
        entries = reader.mapping(node, key, _OBJECT_KEYS, required=("tags",))
        about = WorldObject(
            name,
            Sort(reader.choice(entries.get("sort"), f"{key}.sort", _SORTS, Sort.THING.value)),
            name=reader.text(entries.get("name"), f"{key}.name"),
            category=reader.text(entries.get("category"), f"{key}.category", words_of_id(name)),
            attributes=reader.texts(entries.get("attributes"), f"{key}.attributes"),
            size_m=_size(reader, entries.get("size"), f"{key}.size"),
        )
        reasons = mistakes(about)
        if reasons:
            reader.report("NOT_AN_OBJECT", id_node, key, "; ".join(reasons), "an object of the world")
        for tag_node, place_node in reader.free_mapping(entries.get("tags"), f"{key}.tags"):
            number = _tag_number(reader, tag_node, f"{key}.tags")
            if number is None:
                continue
            if number in found:
                reader.report("DUPLICATE_TAG", tag_node, f"{key}.tags.{number}", "a second one", "each tag once")
            found[number] = Tagged(about, _offset(reader, place_node, f"{key}.tags.{number}"))
    reader.refuse_if_wrong()
    return found


def _tag_number(reader: Reader, node: yaml.Node, key: str) -> Optional[int]:
    text = reader.text(node, key)
    if not text.isdecimal() or int(text) > _MOST:
        reader.report("NOT_A_TAG", node, key, f"'{text}'", f"the number of a tag, 0 to {_MOST}")
        return None
    return int(text)


def _size(reader: Reader, node: Optional[yaml.Node], key: str) -> Tuple[float, float, float]:
    edges = [_number(reader, item, item_key) for item_key, item in reader.sequence(node, key)]
    if node is not None and (len(edges) != 3 or min(edges) < 0.0):
        reader.report("NOT_A_SIZE", node, key, f"{edges}", "three edges in metres, not negative")
        return (0.0, 0.0, 0.0)
    return (edges[0], edges[1], edges[2]) if edges else (0.0, 0.0, 0.0)


def _offset(reader: Reader, node: yaml.Node, key: str) -> Transform:
    if isinstance(node, yaml.ScalarNode) and not node.value:
        return Transform()
    entries = reader.mapping(node, key, _TAG_KEYS)
    x, y, z, roll, pitch, yaw = (_number(reader, entries.get(name), f"{key}.{name}") for name in _TAG_KEYS)
    return Transform((x, y, z), of_roll_pitch_yaw(roll, pitch, yaw))


def _number(reader: Reader, node: Optional[yaml.Node], key: str) -> float:
    return reader.number(node, key, "a number: metres or radians")
