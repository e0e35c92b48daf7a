"""The usual grammar of FrameNet's roles, from a file: what a lexical unit need not say."""

from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import List, Optional, Tuple

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text
from semantic_frames.frame import FrameElement, SemanticFrame
from semantic_frames.lexical_unit import ArgumentForm, ElementRelation, LexicalUnit, RelationPath
from semantic_frames.relation_names import MEASURE
from semantic_frames.relation_reader import RELATION_KEYS, read_relation
from semantic_frames.semantic_type import read_semantic_types

ROLES_FILE = Path(__file__).parent / "roles.yaml"
#: Stands for the values that the frame allows for an element.
_VALUES = ("values",)
_KEYS = (
    "role",
    "is_core",
    "filler",
    *(key for key in RELATION_KEYS if key not in ("name", "required", "wanted", "after_place")),
)
_MEASURE = ElementRelation("", (RelationPath((MEASURE,)),))
_OBJECT = ElementRelation("", (RelationPath(("dobj",)),), ArgumentForm.PHRASE)


@dataclass(frozen=True)
class Role:
    """How a role is usually filled.

    Attributes:
        names: FrameNet's names
        is_core: whether it counts only for core elements, or only for others; None for both
        relation: how an element is filled; it has no name, and without relations it says nothing of that
        filler: semantic types of what fills an element whose frame names none
    """

    names: Tuple[str, ...]
    is_core: Optional[bool]
    relation: ElementRelation
    filler: Tuple[str, ...] = ()

    def is_of(self, element: FrameElement) -> bool:
        """Whether an element has the role."""
        return element.framenet in self.names and self.is_core in (None, element.is_core)


def load_roles(text: str, path: str) -> Tuple[Role, ...]:
    """Read a file of roles.

    Args:
        text: content of the file
        path: path of the file, for problems
    Raises:
        FileRefused: the file is wrong; it lists every mistake
    """
    reader = Reader(path)
    found: List[Role] = []
    for key, node in reader.sequence(reader.compose(text, "a list of roles"), ""):
        entries = reader.mapping(node, key, _KEYS, required=("role",))
        is_core = reader.boolean(entries.get("is_core"), f"{key}.is_core") if "is_core" in entries else None
        names = reader.texts(entries.get("role"), f"{key}.role")
        filler = read_semantic_types(reader, entries.get("filler"), f"{key}.filler")
        found.append(Role(names, is_core, read_relation(reader, node, entries, key, ""), filler))
    reader.refuse_if_wrong()
    return tuple(found)


@lru_cache(maxsize=None)
def roles() -> Tuple[Role, ...]:
    """Return the shipped roles; the file is read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_roles(read_text(str(ROLES_FILE)), str(ROLES_FILE))


@lru_cache(maxsize=None)
def filler_of(framenet: str) -> Tuple[str, ...]:
    """Return the semantic types of what fills an element of a role; none for anything.

    Args:
        framenet: FrameNet's name of the element
    """
    return next((role.filler for role in roles() if framenet in role.names and role.filler), ())


def inherited(frame: SemanticFrame, element: FrameElement) -> Tuple[ElementRelation, ...]:
    """Return how an element is filled if a lexical unit says nothing of it.

    Args:
        frame: the frame
        element: one of its elements
    Returns:
        alternatives; none if the role has no usual grammar
    """
    if element.quantity is not None or any(other.unit_element == element.name for other in frame.frame_elements):
        return (replace(_MEASURE, name=element.name),)
    found = [role.relation for role in roles() if role.is_of(element) and role.relation.relations]
    if not found and element.is_core:
        found = [_OBJECT]
    return tuple(
        replace(relation, name=element.name, words=element.values if relation.words == _VALUES else relation.words)
        for relation in found
        if relation.words != _VALUES or element.values
    )


def with_inherited(unit: LexicalUnit, frame: Optional[SemanticFrame]) -> LexicalUnit:
    """Return a unit with the relations that it inherits from the roles of its frame's elements.

    A unit that lists its relations, as those of 2012 do, inherits nothing, and is returned as it is.

    Args:
        unit: the unit
        frame: that it evokes; None if it is unknown, and the unit inherits nothing yet
    """
    if unit.changes is None or frame is None:
        return unit
    relations: List[Tuple[int, ElementRelation]] = []
    for place, element in enumerate(frame.frame_elements):
        usual = inherited(frame, element)
        changes = [change for change in unit.changes if change.relation.name == element.name]
        rank = next((number for number, role in enumerate(roles()) if role.is_of(element)), -1)
        order = rank * len(frame.frame_elements) + place
        found = [relation for change in changes for relation in change.of(usual)] if changes else usual
        relations += [(order, replace(relation, line=relation.line or unit.line)) for relation in found]
    # What the unit says of an element that the frame lacks fills nothing, and counts as in a unit that lists it.
    known = {element.name for element in frame.frame_elements}
    others = [one.relation for one in unit.changes if one.relation.relations and one.relation.name not in known]
    ordered = [relation for _, relation in sorted(relations, key=lambda one: one[0])]
    return replace(unit, relations=(*ordered, *others))
