"""Finds out what of a frame reaches a server: what no server gets must not be dropped without a word."""

from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Dict, FrozenSet, Iterable, Mapping, Optional, Sequence

from semantic_frames.extra_thematic import extra_thematic_names, extra_thematic_of_arguments
from semantic_frames.frame import ElementMapping, RelatedFrame, SemanticFrame, ValueCondition
from semantic_frames.server_profile import AS_IN_2012, HeededElement, ServerProfile
from typed_arguments import TypedArgument

#: Alternatives that are kept for one element; further servers with yet other restrictions are not looked at.
_MOST_ALTERNATIVES = 32


@dataclass(frozen=True)
class Heeding:
    """What of the arguments of one element reaches a server.

    Attributes:
        alternatives: restrictions; all of one alternative must fit an argument, and an empty one fits any
    """

    alternatives: FrozenSet[FrozenSet[HeededElement]] = frozenset([frozenset()])

    def fits(self, argument: TypedArgument) -> bool:
        """Whether a server heeds all of an argument."""
        return any(all(heeded.fits(argument) for heeded in together) for together in self.alternatives)

    def either(self, other: "Heeding") -> "Heeding":
        """Return what one of two servers heeds."""
        return _heeding(self.alternatives | other.alternatives)

    def both(self, other: "Heeding") -> "Heeding":
        """Return what two servers heed that do one thing together."""
        return _heeding(one | two for one in self.alternatives for two in other.alternatives)

    def with_relation(self, relation: str) -> "Heeding":
        """Return what is heeded of arguments that the server gets with this relation, whatever theirs is."""
        free = (
            frozenset(replace(heeded, relations=()) for heeded in together if heeded != HeededElement(heeded.name))
            for together in self.alternatives
            if all(not heeded.relations or relation in heeded.relations for heeded in together)
        )
        return _heeding(free)


def _heeding(alternatives: Iterable[FrozenSet[HeededElement]]) -> Heeding:
    found = frozenset(alternatives)
    if frozenset() in found:
        return EVERYTHING
    return Heeding(frozenset(sorted(found, key=repr)[:_MOST_ALTERNATIVES]))


#: Every argument of an element reaches a server.
EVERYTHING = Heeding()
#: By name of an element ("goal"), or of an extra-thematic element ("Manner"); what is missing reaches no server.
FrameHeeding = Mapping[str, Heeding]
#: Profiles of the servers of each frame.
Servers = Mapping[str, Sequence[ServerProfile]]


def heeded_elements(frames: Mapping[str, SemanticFrame], served: Servers) -> Mapping[str, FrameHeeding]:
    """Return the elements of each frame that reach a server.

    A server of the frame itself gets all its elements, and heeds what it stated. A server of a child gets those that
    the relations of the frame map to it, and a value condition heeds its element. Extra-thematic elements reach all
    members of a sequence.

    Args:
        frames: by name
        served: profiles of the live servers that act, for each frame that has one
    Returns:
        the elements of each frame that can be carried out
    """
    known: Dict[str, Optional[FrameHeeding]] = {}
    for name in frames:
        _heeded(name, frames, served, known)
    return {name: elements for name, elements in known.items() if elements is not None}


def _heeded(
    name: str, frames: Mapping[str, SemanticFrame], served: Servers, known: Dict[str, Optional[FrameHeeding]]
) -> Optional[FrameHeeding]:
    """Return the elements of one frame that reach a server; None if nothing can carry the frame out."""
    if name in known:
        return known[name]
    # The registrar refuses cycles; a catalogue that has one all the same must not end in endless recursion.
    known[name] = None
    frame = frames.get(name)
    if frame is None:
        return None
    ways = [_by_server(frame, profile) for profile in served.get(name, ())]
    for sequence in frame.children:
        inside = [_heeded(child.name, frames, served, known) for child in sequence]
        reached = [one for one in inside if one is not None]
        if len(reached) == len(inside):
            ways.append(_by_sequence(frame, sequence, reached))
    if ways:
        known[name] = MappingProxyType(_merged(ways))
    return known[name]


def _by_server(frame: SemanticFrame, profile: ServerProfile) -> FrameHeeding:
    if profile == AS_IN_2012:
        return {element.name: EVERYTHING for element in frame.frame_elements}
    units = {element.unit_element for element in frame.frame_elements}
    found = {}
    for element in frame.frame_elements:
        stated = profile.heeded(element.name, frame)
        if stated or element.name in units:
            found[element.name] = EVERYTHING if element.name in units else _one_of(stated)
    for heeded in profile.heeds:
        if heeded.name in extra_thematic_names():
            found[heeded.name] = _one_of([other for other in profile.heeds if other.name == heeded.name])
    return found


def _one_of(stated: Iterable[HeededElement]) -> Heeding:
    return _heeding(frozenset() if heeded == HeededElement(heeded.name) else frozenset([heeded]) for heeded in stated)


def _by_sequence(
    frame: SemanticFrame, sequence: Sequence[RelatedFrame], reached: Sequence[FrameHeeding]
) -> FrameHeeding:
    found: Dict[str, Heeding] = {}
    for argument, name in extra_thematic_of_arguments().items():
        # An element of the frame itself reaches only those children that it is mapped to.
        if frame.element(argument) is None and all(name in inside for inside in reached):
            heeding = EVERYTHING
            for inside in reached:
                heeding = heeding.both(inside[name])
            found[name] = heeding
    for child, inside in zip(sequence, reached):
        for relation in child.frame_element_relations:
            if isinstance(relation, ValueCondition):
                found[relation.parent_name] = EVERYTHING
            elif isinstance(relation, ElementMapping) and relation.child_name in inside:
                heeding = inside[relation.child_name]
                heeding = heeding.with_relation(relation.relation) if relation.relation else heeding
                before = found.get(relation.parent_name)
                found[relation.parent_name] = heeding if before is None else before.either(heeding)
    return found


def _merged(ways: Sequence[FrameHeeding]) -> Dict[str, Heeding]:
    found: Dict[str, Heeding] = {}
    for way in ways:
        for name, heeding in way.items():
            found[name] = found[name].either(heeding) if name in found else heeding
    return found
