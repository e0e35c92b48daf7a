"""Reads the file of the world: what the robot knows before anybody tells it anything.

The file has a mapping for each sort, and each maps ids to what is known::

    places:
      kitchen: {x: -2.8, y: -1.6, size: [4, 3], names: [cooking place]}
    things:
      table_1: {in: kitchen, attributes: [wooden]}
      mug_1: {category: mug, on: table_1, attributes: [red], of: anna}
    doors:
      kitchen_door: {to: [kitchen, hall], states: [closed]}
    persons:
      anna: {in: hall}
"""

import math
from typing import Dict, List, Mapping, Optional, Tuple

import yaml

from checked_files.marked_yaml import Reader, did_you_mean
from world_model.knowledge import MOST_STORED
from world_model.world_object import FILE, Pose, Relation, Sort, WorldObject, mistakes, words_of_id

SECTIONS: Mapping[str, Sort] = {
    "places": Sort.PLACE,
    "doors": Sort.DOOR,
    "things": Sort.THING,
    "devices": Sort.DEVICE,
    "persons": Sort.PERSON,
    "robots": Sort.ROBOT,
}
#: Keys that name another object, or several.
RELATIONS = (
    "on",
    "in",
    "under",
    "above",
    "behind",
    "in_front_of",
    "beside",
    "near",
    "left_of",
    "right_of",
    "held_by",
    "of",
    "to",
)
_KEYS = ("name", "names", "category", "attributes", "states", "size", "x", "y", "z", "heading", "frame_id")
#: Sorts whose objects have a name of their own; others are one of many.
_NAMED = frozenset([Sort.PLACE, Sort.PERSON])


def load_world_file(text: str, path: str) -> Tuple[WorldObject, ...]:
    """Read a file of the world.

    Args:
        text: content of the file
        path: where it came from, for problems
    Returns:
        the objects, in the order of the file
    Raises:
        FileRefused: the file has mistakes; the exception carries all of them
    """
    reader = Reader(path)
    root = reader.mapping(reader.compose(text, "a mapping with places, things, persons"), "", tuple(SECTIONS))
    found: Dict[str, WorldObject] = {}
    references: List[Tuple[yaml.Node, str, str]] = []
    for section, sort in SECTIONS.items():
        for id_node, node in reader.free_mapping(root.get(section), section):
            name = reader.name(id_node, section)
            key = f"{section}.{name}"
            one = _read(reader, node, key, name, sort, references)
            reasons = mistakes(one)
            if reasons:
                reader.report("NOT_AN_OBJECT", id_node, key, "; ".join(reasons), "an object of the world")
            if name in found:
                reader.report("DUPLICATE_ID", id_node, key, f"a second '{name}'", "each id once in the file")
            if len(found) >= MOST_STORED:
                reader.report("TOO_MANY", id_node, key, "more objects", f"at most {MOST_STORED}")
            found[name] = one
    for node, key, reference in references:
        if reference not in found:
            hint = did_you_mean(reference, found)
            reader.report("UNKNOWN_OBJECT", node, key, f"'{reference}'", "the id of an object of this file", hint)
    reader.refuse_if_wrong()
    return tuple(found.values())


def _read(
    reader: Reader, node: yaml.Node, key: str, name: str, sort: Sort, references: List[Tuple[yaml.Node, str, str]]
) -> WorldObject:
    entries = reader.mapping(node, key, (*_KEYS, *RELATIONS)) if not _is_blank(node) else {}
    said = words_of_id(name)
    default = (said.title() if sort is Sort.PERSON else said) if sort in _NAMED else ""
    relations: List[Relation] = []
    for relation in RELATIONS:
        for reference in reader.texts(entries.get(relation), f"{key}.{relation}"):
            references.append((entries[relation], f"{key}.{relation}", reference))
            relations.append(Relation(relation, reference))
    return WorldObject(
        id=name,
        sort=sort,
        name=reader.text(entries.get("name"), f"{key}.name", default),
        other_names=reader.texts(entries.get("names"), f"{key}.names"),
        category=reader.text(entries.get("category"), f"{key}.category", "" if sort in _NAMED else said),
        attributes=reader.texts(entries.get("attributes"), f"{key}.attributes"),
        size_m=_size(reader, entries.get("size"), f"{key}.size"),
        pose=_pose(reader, entries, key),
        relations=tuple(relations),
        states=reader.texts(entries.get("states"), f"{key}.states"),
        source=FILE,
    )


def _is_blank(node: yaml.Node) -> bool:
    return isinstance(node, yaml.ScalarNode) and not node.value


def _number(reader: Reader, node: Optional[yaml.Node], key: str) -> float:
    return reader.number(node, key, "a number: metres, or radians for heading")


def _size(reader: Reader, node: Optional[yaml.Node], key: str) -> Tuple[float, float, float]:
    edges = [_number(reader, item, item_key) for item_key, item in reader.sequence(node, key)]
    if node is not None and (len(edges) not in (0, 2, 3) or min(edges, default=0.0) < 0.0):
        reader.report("NOT_A_SIZE", node, key, f"{edges}", "two or three edges in metres, not negative")
        return (0.0, 0.0, 0.0)
    x, y, z = (*edges, 0.0, 0.0, 0.0)[:3]
    return (x, y, z)


def _pose(reader: Reader, entries: Mapping[str, yaml.Node], key: str) -> Optional[Pose]:
    given = [name for name in ("x", "y", "z", "heading", "frame_id") if name in entries]
    if not given:
        return None
    for name in ("x", "y"):
        if name not in entries:
            reader.report("MISSING_KEY", entries[given[0]], f"{key}.{name}", "nothing", f"the key '{name}'")
    heading = _number(reader, entries.get("heading"), f"{key}.heading")
    return Pose(
        frame_id=reader.text(entries.get("frame_id"), f"{key}.frame_id", "map"),
        x_m=_number(reader, entries.get("x"), f"{key}.x"),
        y_m=_number(reader, entries.get("y"), f"{key}.y"),
        z_m=_number(reader, entries.get("z"), f"{key}.z"),
        orientation=(0.0, 0.0, math.sin(heading / 2.0), math.cos(heading / 2.0)),
    )
