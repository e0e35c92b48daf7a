"""The things, persons and places that an argument of a call means."""

from dataclasses import dataclass, replace
from typing import Optional, Sequence, Tuple

from agent_server.refused import CallRefused
from referring_expressions import Situation, describe, resolve, unknown_of
from roboframenet_ros.spoken_text import join_with_or
from semantic_frames.frame import FrameElement, SemanticFrame, UnknownPolicy
from semantic_frames.semantic_type import SEMANTIC_TYPES, with_parents
from semantic_types.likelihood import UNTYPED, Fit, Likelihoods, of_names
from semantic_types.word_types import shipped_types
from typed_arguments import Modifier, TypedArgument
from word_classes import without_determiner
from world_model import Sort, World, WorldObject

_OF_SORTS = {
    Sort.PERSON: ("Human",),
    Sort.PLACE: ("Room", "Location"),
    Sort.DOOR: ("Portal",),
    Sort.DEVICE: ("Device",),
    Sort.ROBOT: ("Device",),
}
#: What can be in the world of the robot is a kind of this.
_IN_THE_WORLD = "Physical_entity"
_MOST_NAMED = 5


@dataclass(frozen=True)
class Meant:
    """An argument with what it means.

    Attributes:
        argument: with its referents
        doubts: why a person must say yes before the robot acts on it, in sentences
    """

    argument: TypedArgument
    doubts: Tuple[str, ...] = ()


def meant(element: FrameElement, text: str, relation: str, frame: SemanticFrame, world: World) -> Meant:
    """Return what an argument means.

    Args:
        element: that it fills
        text: the id of an object, or words
        relation: to the action; empty for none
        frame: of the element
        world: what the robot knows
    Raises:
        CallRefused: it may mean several things, or the frame refuses what the robot does not know
    """
    kinds = element.semantic_types
    if not any(_IN_THE_WORLD in with_parents(kind) for kind in kinds):
        return Meant(TypedArgument(element.name, text, relation=relation))
    known = world.get(text)
    if known is not None:
        phrase = _phrase(element.name, describe_object(known), relation)
        argument = replace(
            phrase, semantic_type=_types_of(known).likeliest(kinds), referents=(known.id,), referent_count=1
        )
        return Meant(replace(argument, world_version=world.version), _doubts(element, text, _types_of(known)))
    phrase = _phrase(element.name, text, relation)
    found = resolve(phrase, Situation(world)) if world.objects else None
    if found is None:
        types = _types_of_words(phrase)
        return Meant(replace(phrase, semantic_type=types.likeliest(kinds)), _doubts(element, text, types))
    if found.is_ambiguous:
        ids = join_with_or([one.id for one in found.objects[:_MOST_NAMED]])
        raise CallRefused("AMBIGUOUS", f'"{text}" may be one of several: give the id, such as {ids}.')
    if not found.objects:
        unknown = unknown_of(phrase)
        if frame.on_unknown is UnknownPolicy.REFUSE:
            raise CallRefused("UNKNOWN_THING", unknown)
        types = _types_of_words(phrase)
        doubts = _doubts(element, text, types)
        if frame.on_unknown is UnknownPolicy.ASK:
            doubts += (unknown,)
        return Meant(replace(phrase, semantic_type=types.likeliest(kinds), world_version=world.version), doubts)
    types = _types_of(found.objects[0])
    argument = replace(
        phrase,
        semantic_type=types.likeliest(kinds),
        referents=found.ids[:_MOST_NAMED],
        referent_count=found.count,
        world_version=world.version,
    )
    return Meant(argument, _doubts(element, text, types))


def describe_object(one: WorldObject) -> str:
    """Return an object in words: its name, or its properties and what it is."""
    return one.name or " ".join(("the", *one.attributes, one.category or str(one.sort.value)))


def _phrase(name: str, text: str, relation: str) -> TypedArgument:
    """Return words as a phrase: the last one is its head, and those before it describe it."""
    bare = without_determiner(text)
    words = bare.split() or [text]
    determiner = text[: len(text) - len(bare)].strip().lower()
    return TypedArgument(
        name,
        text,
        words=f"{relation.replace('_', ' ')} {text}".strip(),
        head=words[-1],
        lemma=words[-1].lower(),
        relation=relation,
        quantifier=determiner,
        modifiers=tuple(Modifier("adjective", word, word.lower()) for word in words[:-1]),
    )


def _types_of(one: WorldObject) -> Likelihoods:
    types = _OF_SORTS.get(one.sort)
    if types is not None:
        return of_names(types)
    words = one.category.split()
    return shipped_types().of_noun([one.category, words[-1]]) if words else UNTYPED


def _types_of_words(phrase: TypedArgument) -> Likelihoods:
    return shipped_types().of_noun([without_determiner(phrase.text).lower(), phrase.lemma])


def _doubts(element: FrameElement, text: str, types: Likelihoods) -> Tuple[str, ...]:
    """Return why a person would be asked about the type of an argument, as they are about spoken words."""
    if types.fit(element.semantic_types) is not Fit.WRONG:
        return ()
    found = _words_of([types.likeliest()])
    return (f'"{text}" is {found}, and the {element.name.replace("_", " ")} is {_words_of(element.semantic_types)}.',)


def _words_of(types: Sequence[str]) -> str:
    return join_with_or([SEMANTIC_TYPES[kind].words for kind in types])


def shown_relations(one: WorldObject, world: World) -> Optional[str]:
    """Return the room of an object in words; None when it is not known."""
    room = world.room_of(one)
    return None if room is None or room is one else describe(room, world)
