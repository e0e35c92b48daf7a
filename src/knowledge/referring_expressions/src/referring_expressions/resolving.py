"""Decides which of the fitting objects a phrase refers to: one, several, any of them, or one that must be asked for."""

from dataclasses import dataclass, replace
from typing import List, Optional, Tuple

from referring_expressions.describing import group_alike
from referring_expressions.fitting import Situation, fitting
from referring_expressions.measures import Objects
from typed_arguments import Source, TypedArgument
from word_classes import word_class

ALL = -1
#: Referents that travel with an argument.
MOST_REFERENTS = 32
#: Objects that are compared with each other; among more, there are some that a person can tell apart.
MOST_COMPARED = 64
_INDEFINITE = word_class("quantifiers_of_some") | {"a", "another"}
_WHOLE = word_class("determiners_of_all")
_PERSONS = word_class("pronouns_of_persons")


@dataclass(frozen=True)
class Referents:
    """What a phrase refers to.

    Attributes:
        objects: the likeliest first; none when the robot knows nothing that fits
        count: how many of them are meant; -1 for all, 0 when unknown
        is_ambiguous: whether a person must be asked which of them is meant
    """

    objects: Objects = ()
    count: int = 0
    is_ambiguous: bool = False

    @property
    def ids(self) -> Tuple[str, ...]:
        """The ids of the objects."""
        return tuple(one.id for one in self.objects)


def resolve(argument: TypedArgument, situation: Situation) -> Optional[Referents]:
    """Find what a phrase refers to.

    Returns:
        the referents, none of them if nothing known fits; None for a phrase that refers to nothing: an amount, a
        direction, words to be said
    """
    if not _refers(argument):
        return None
    if argument.members:
        return _of_members(argument, situation)
    found = fitting(argument, situation)
    if not found:
        return Referents()
    if argument.quantifier in _WHOLE:
        return Referents(found, ALL)
    if argument.quantifier in _INDEFINITE:
        return Referents(situation.world.nearest_first(found), argument.count or (0 if argument.is_plural else 1))
    if argument.count is not None and argument.count != 1:
        is_open = not argument.quantifier and argument.possessor is None
        is_ambiguous = not is_open and len(found) > argument.count
        return Referents(situation.world.nearest_first(found), argument.count, is_ambiguous)
    if argument.is_plural:
        is_definite = bool(argument.quantifier) or argument.possessor is not None
        return Referents(found, ALL if is_definite else 0)
    return _one(argument, found, situation)


def _one(argument: TypedArgument, found: Objects, situation: Situation) -> Referents:
    """Return the one that "the mug" refers to, or those that it may refer to."""
    spoken_of = [name for name in situation.spoken_of if name in {one.id for one in found}]
    if len(found) > 1 and spoken_of and argument.quantifier != "other" and not situation.offered:
        return Referents(situation.objects(spoken_of[:1]), 1)
    ordered = situation.world.nearest_first(found)
    # Nobody can say which of two mugs is meant that nothing tells apart.
    if len(ordered) > MOST_COMPARED:
        return Referents(ordered, 1, is_ambiguous=True)
    different = group_alike(ordered, situation.world)
    return Referents(tuple(group[0] for group in different) if len(different) > 1 else ordered, 1, len(different) > 1)


def _refers(argument: TypedArgument) -> bool:
    """Whether a phrase may refer to objects."""
    if not argument.head or argument.measure is not None or argument.time is not None or argument.is_negated:
        return False
    if argument.quantifier == "no" or argument.count == 0 or argument.source is Source.DEFAULT:
        return False
    if any(frame.role == "says" for frame in argument.frames):
        return False
    return not argument.direction and argument.head.lower() not in _PERSONS


def _of_members(argument: TypedArgument, situation: Situation) -> Referents:
    """Return the referents of a list; those of its members, when each has some."""
    parts: List[Referents] = []
    for member in argument.members:
        part = resolve(member, situation)
        if part is None or not part.objects or part.is_ambiguous or part.count == 0:
            return Referents()
        parts.append(part)
    meant = tuple(
        dict.fromkeys(
            one for part in parts for one in part.objects[: len(part.objects) if part.count < 0 else part.count]
        )
    )
    return Referents(meant, 1 if argument.conjunction == "or" else len(meant))


def with_referents(argument: TypedArgument, situation: Situation) -> TypedArgument:
    """Return an argument with its referents and those of its parts, and the version that was searched."""
    world = situation.world
    if not world.objects:
        return argument
    argument = replace(
        argument,
        members=tuple(with_referents(member, situation) for member in argument.members),
        possessor=None if argument.possessor is None else with_referents(argument.possessor, situation),
        complement=None if argument.complement is None else with_referents(argument.complement, situation),
        frames=tuple(
            replace(frame, frame_elements=tuple(with_referents(element, situation) for element in frame.frame_elements))
            for frame in argument.frames
        ),
    )
    found = resolve(argument, situation)
    if found is None:
        return argument
    return replace(
        argument, referents=found.ids[:MOST_REFERENTS], referent_count=found.count, world_version=world.version
    )
