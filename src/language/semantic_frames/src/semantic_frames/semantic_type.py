"""FrameNet's semantic types: what kind of thing fills a frame element."""

from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType
from typing import FrozenSet, Mapping, Optional, Tuple

import yaml

from checked_files.marked_yaml import Reader, did_you_mean


@dataclass(frozen=True)
class SemanticType:
    """A semantic type.

    Attributes:
        parent: the more general type; empty for none
        words: names the type to a person: "Anna is a person"
    """

    parent: str
    words: str


#: The types by name; the names are FrameNet's where it has the type. Unlike FrameNet's, they say what a robot can
#: do with something: persons, animals, body parts and places are no *Physical_object*, which can be carried.
SEMANTIC_TYPES: Mapping[str, SemanticType] = MappingProxyType(
    {
        "Physical_entity": SemanticType("", "something that can be touched"),
        "Physical_object": SemanticType("Physical_entity", "a thing"),
        "Clothing": SemanticType("Physical_object", "something to wear"),
        "Container": SemanticType("Physical_object", "a container"),
        "Cookware": SemanticType("Container", "a pot or a pan"),
        "Device": SemanticType("Physical_object", "a device"),
        "Valve": SemanticType("Device", "a tap"),
        "Control": SemanticType("Device", "a button or a switch"),
        "Food": SemanticType("Physical_object", "something to eat or drink"),
        "Furniture": SemanticType("Physical_object", "a piece of furniture"),
        "Plant": SemanticType("Physical_object", "a plant"),
        "Portal": SemanticType("Physical_object", "a door or a window"),
        "Text": SemanticType("Physical_object", "something to read"),
        "Vehicle": SemanticType("Physical_object", "a vehicle"),
        "Substance": SemanticType("Physical_entity", "a material"),
        "Fluid": SemanticType("Substance", "a liquid or a gas"),
        "Body_part": SemanticType("Physical_entity", "a part of the body"),
        "Sentient": SemanticType("Physical_entity", "a living being"),
        "Human": SemanticType("Sentient", "a person"),
        "Animal": SemanticType("Sentient", "an animal"),
        "Location": SemanticType("Physical_entity", "a place"),
        "Building": SemanticType("Location", "a building"),
        "Room": SemanticType("Location", "a room"),
        "Attribute": SemanticType("", "a property"),
        "Content": SemanticType("", "a thought"),
        "Event": SemanticType("", "an event"),
        "Information": SemanticType("", "a message"),
        "Music": SemanticType("Information", "music"),
        "Organization": SemanticType("", "an organization"),
        "Phenomenon": SemanticType("", "a phenomenon"),
        "Quantity": SemanticType("", "a quantity"),
        "Relation": SemanticType("", "a relation"),
        "State": SemanticType("", "a state"),
        "Time": SemanticType("", "a time"),
    }
)


@lru_cache(maxsize=None)
def with_parents(name: str) -> FrozenSet[str]:
    """Return a type and all more general types.

    Raises:
        KeyError: there is no such type
    """
    parent = SEMANTIC_TYPES[name].parent
    return frozenset([name]) | (with_parents(parent) if parent else frozenset())


def read_semantic_types(reader: Reader, node: Optional[yaml.Node], key: str) -> Tuple[str, ...]:
    """Read the name of one semantic type, or a list of names; unknown names are reported, and left out.

    Args:
        reader: of the file
        node: with the names; None for no types
        key: of the node, for problems
    """
    if node is None:
        return ()
    nodes = reader.sequence(node, key) if isinstance(node, yaml.SequenceNode) else [(key, node)]
    return tuple(filter(None, (read_semantic_type(reader, item, item_key) for item_key, item in nodes)))


def read_semantic_type(reader: Reader, node: yaml.Node, key: str) -> str:
    """Read the name of a semantic type; report an unknown one, and return nothing for it."""
    name = reader.name(node, key)
    if name in SEMANTIC_TYPES:
        return name
    hint = did_you_mean(name, SEMANTIC_TYPES)
    reader.report("UNKNOWN_TYPE", node, key, f"'{name}'", "a semantic type such as Container", hint)
    return ""
