"""Reads the maps of HuRIC 2.1: each command has one, with the things of a house as points on a grid."""

import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from pathlib import Path
from typing import Dict, List, Tuple

from frame_learning.annotated_commands import CorpusError
from semantic_types import shipped_nouns, spoken
from world_model import Pose, Relation, Sort, World, WorldObject
from world_model.world import NEAR_M, snapshot
from world_model.world_object import MOST_ENTRIES, ROBOT_ID

#: A room is a point too: what is at most so far from it is in it.
_EDGE_M = 2.0 * NEAR_M
_SORTS = {"Person": Sort.PERSON, "Robot": Sort.ROBOT, "Door": Sort.DOOR}
_CONTAINS = "contain_ability"
_NAMES = "lexical_references"


def read_huric_maps(folder: str) -> Dict[str, World]:
    """Read the map of each command below a folder, by the name of the command.

    Raises:
        CorpusError: one of the files is not HuRIC XML
    """
    found: Dict[str, World] = {}
    for path in sorted(Path(folder).glob("**/*.hrc")):
        try:
            root = ElementTree.parse(str(path)).getroot()
            found[path.stem] = _world(path.stem, root)
        except (ElementTree.ParseError, OSError, KeyError, ValueError) as error:
            raise CorpusError(f"{path}: no HuRIC XML with a map: {error!r}") from error
    return found


def _world(name: str, root: ElementTree.Element) -> World:
    entities = [_entity(node) for node in root.findall("semanticMap/entities/entity")]
    objects = {one.id: replace(one, relations=_relations(one, entities)) for one, _ in entities}
    return snapshot(name, objects)


def _entity(node: ElementTree.Element) -> Tuple[WorldObject, bool]:
    """Return an object without its relations, and whether something can be in it."""
    values: Dict[str, List[str]] = {
        attribute.attrib["name"]: [value.text or "" for value in attribute.findall("value")]
        for attribute in node.findall("attributes/attribute")
    }
    category = _words(node.attrib["type"])
    names = tuple(dict.fromkeys(name for name in map(_words, values.get(_NAMES, ())) if name != category))
    coordinate = node.find("coordinate")
    if coordinate is None:
        raise ValueError(f"{node.attrib['atom']} is nowhere")
    sort = _SORTS.get(node.attrib["type"], Sort.PLACE if _is_place(category) else Sort.THING)
    is_place = sort is Sort.PLACE
    entity = WorldObject(
        ROBOT_ID if sort is Sort.ROBOT else node.attrib["atom"],
        sort,
        other_names=((category,) if is_place else ()) + names,
        category="" if sort is Sort.ROBOT else category,
        pose=Pose("map", float(coordinate.attrib["x"]), float(coordinate.attrib["y"])),
        size_m=(_EDGE_M, _EDGE_M, 0.0) if is_place else (0.0, 0.0, 0.0),
    )
    return entity, values.get(_CONTAINS) == ["true"]


def _is_place(category: str) -> bool:
    types = shipped_nouns().types(category).types
    return bool(types) and types[0][0] in ("Room", "Location", "Building", "Area")


def _relations(one: WorldObject, others: List[Tuple[WorldObject, bool]]) -> Tuple[Relation, ...]:
    """Return what an object may be on or in: points say only what is near what, the nearest first."""
    pose = one.pose
    if pose is None or one.sort not in (Sort.THING, Sort.DEVICE):
        return ()
    near = sorted(
        (pose.distance_m(other.pose), other.id, contains)
        for other, contains in others
        if other.id != one.id and other.sort is Sort.THING and other.pose and pose.distance_m(other.pose) <= NEAR_M
    )
    found = [Relation("in" if contains else "on", name) for _, name, contains in near]
    return tuple(found[:MOST_ENTRIES])


def _words(name: str) -> str:
    """Return a name as people say it: "living room" for "LivingRoom"."""
    spaced = "".join(f" {letter}" if letter.isupper() else letter for letter in name.replace("_", " "))
    return spoken(spaced)
