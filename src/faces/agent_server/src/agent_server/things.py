"""The things, persons and places that an argument of a call means."""

from dataclasses import dataclass, replace
from typing import Iterator, Sequence, Tuple

from agent_server.refused import CallRefused
from referring_expressions import Referents, Situation, resolve, unknown_of
from referring_expressions.describing import name_of, noun_of
from roboframenet_ros.spoken_text import join_with_or
from semantic_framer.units.frame_roles import CONTENTS, NAME, SAID
from semantic_frames.frame import FrameElement, SemanticFrame, UnknownPolicy
from semantic_frames.semantic_type import SEMANTIC_TYPES, with_parents
from semantic_types.likelihood import LIKELY, UNTYPED, Fit, Likelihoods, of_names
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
#: Elements of words that are said, or that are no things: an object of such a name is not meant.
_WORDS = SAID | frozenset(CONTENTS) | {NAME}
_MOST_NAMED = 5


@dataclass(frozen=True)
class Meant:
    """An argument with what it means.

    Attributes:
        argument: with its referents
        kinds: its words, and every semantic type that it usually has: with one of them a frame may want a yes
        doubts: why a person must say yes before the robot acts on it, in sentences
    """

    argument: TypedArgument
    kinds: Tuple[str, ...] = ()
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
    is_thing = any(_IN_THE_WORLD in with_parents(kind) for kind in element.semantic_types)
    known = None if element.framenet in _WORDS else world.get(text)
    is_named = element.framenet not in _WORDS and bool(world.named(text))
    if element.values or not (is_thing or element.confirmed_values or known is not None or is_named):
        argument = TypedArgument(element.name, text, relation=relation)
        return Meant(argument, (text, *text.split()))
    said = text if known is None else describe_object(known)
    phrase = _phrase(element.name, said, relation)
    found = Referents((known,), 1) if known is not None else _resolved(phrase, world)
    doubts: Tuple[str, ...] = ()
    if found.is_ambiguous:
        ids = join_with_or([one.id for one in found.objects[:_MOST_NAMED]])
        raise CallRefused("AMBIGUOUS", f'"{text}" may be one of several: give the id, such as {ids}.')
    if world.objects and is_thing and not found.objects:
        if frame.on_unknown is UnknownPolicy.REFUSE:
            raise CallRefused("UNKNOWN_THING", unknown_of(phrase))
        if frame.on_unknown is UnknownPolicy.ASK:
            doubts += (unknown_of(phrase),)
    types = _types_of(found.objects[0]) if found.objects else _types_of_words(phrase)
    if element.semantic_types:
        doubts += _doubts(element, text, types)
    if element.confirmed_values and not types.types:
        doubts += (f'I do not know what "{text}" is.',)
    argument = replace(
        phrase,
        semantic_type=types.likeliest(element.semantic_types),
        referents=found.ids[:_MOST_NAMED],
        referent_count=found.count,
        world_version=world.version,
    )
    return Meant(argument, (said, *said.split(), *_all_kinds(phrase, found, types)), doubts)


def _resolved(phrase: TypedArgument, world: World) -> Referents:
    found = resolve(phrase, Situation(world)) if world.objects else None
    return Referents() if found is None else found


def _all_kinds(phrase: TypedArgument, found: Referents, types: Likelihoods) -> Iterator[str]:
    """Yield every type that an argument, or a word of it, usually has, and what the robot knows it as."""
    for one in found.objects:
        yield from (one.category, *one.category.split())
    words = (shipped_types().of_noun([word.lower()]) for word in phrase.text.split())
    for likelihoods in (types, *words):
        for kind, likelihood in likelihoods.types:
            if likelihood >= LIKELY:
                yield from with_parents(kind)


def describe_object(one: WorldObject) -> str:
    """Return an object in words: its name, or its properties and what it is."""
    return name_of(one) if one.name else " ".join(("the", *one.attributes, noun_of(one)))


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
