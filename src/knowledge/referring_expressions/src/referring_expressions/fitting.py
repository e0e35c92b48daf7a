"""Finds the objects of the world that fit a phrase: its head, its modifiers, whose they are and where they are."""

import math
from dataclasses import dataclass, field, replace
from typing import Iterable, Optional, Sequence, Set, Tuple

from referring_expressions.deeds import DeedsDone, is_deed
from referring_expressions.measures import Objects, in_order, measure
from semantic_types import spoken
from typed_arguments import EmbeddedFrame, Modifier, TypedArgument
from word_classes import without_determiner, word_class
from world_model import Sort, World, WorldObject

_DETERMINERS = word_class("determiners_and_possessives")
_GENERAL_THINGS = word_class("general_thing_nouns")
_HEARERS = word_class("hearers") | word_class("robot_names")
_PERSON_NOUNS = word_class("general_person_nouns")
_PLACE_NOUNS = word_class("general_place_nouns")
_PRONOUNS = word_class("pronouns")
_PRONOUNS_OF_PLACES = word_class("here_and_there")
_PORTIONS = word_class("measure_nouns")
_SPEAKER = word_class("words_of_the_speaker")
_STANDINS = word_class("noun_standins")
#: What a description with "of" may mean: "the door of the kitchen" leads there, "the mug of Anna" is hers.
_OF = ("of", "to", "in", "on")


@dataclass(frozen=True)
class Situation:
    """What is known when somebody speaks.

    Attributes:
        world: what the robot knows
        spoken_of: ids of what was spoken of, the last one first
        offered: ids that the robot has just asked about: "the red one" is one of them
        speaker: id of the person who speaks; empty when unknown
        deeds: what the robot has done
    """

    world: World
    spoken_of: Tuple[str, ...] = ()
    offered: Tuple[str, ...] = ()
    speaker: str = ""
    deeds: DeedsDone = field(default_factory=DeedsDone)

    def objects(self, ids: Iterable[str]) -> Objects:
        """Return the objects of some ids, without those that are no longer known."""
        return tuple(one for name in ids for one in [self.world.get(name)] if one is not None)

    @property
    def here(self) -> Optional[WorldObject]:
        """The place that the robot is in; None when unknown."""
        robot = self.world.robot
        return self.world.room_of(robot) if robot is not None else None


def fitting(argument: TypedArgument, situation: Situation, *, is_wide: bool = False) -> Objects:
    """Return the objects that a phrase may refer to, whatever its quantifier; none if nothing known fits.

    Args:
        argument: the phrase
        situation: what is known
        is_wide: whether an armchair counts as a chair even if there are chairs: "how many chairs"
    """
    lemma = argument.lemma.lower()
    if argument.complement is not None and lemma in _PORTIONS and not situation.world.exactly(lemma):
        argument = _without_portion(argument, argument.complement)
    found = _by_head(argument, situation, is_wide)
    if argument.quantifier in ("other", "another") and situation.spoken_of:
        found = tuple(one for one in found if one.id != situation.spoken_of[0])
    if argument.possessor is not None and not _is_name(found, argument):
        found = _possessed(found, argument.possessor, situation)
    if argument.complement is not None and not _is_name(found, argument):
        found = _of(found, argument.complement, situation)
    for description in argument.frames:
        found = described(found, description, situation)
    for exception in argument.exceptions:
        left_out = fitting(exception, situation)
        found = tuple(one for one in found if one not in left_out)
    superlatives = [one for one in argument.modifiers if one.kind == "superlative"]
    ordinals = [one.number for one in argument.modifiers if one.kind == "ordinal"]
    if superlatives:
        return most_of(found, superlatives, situation, ordinals[0] if ordinals else 1)
    for number in ordinals:
        found = _at_rank(found, number) if situation.offered else found if len(found) == 1 else ()
    return found


def _at_rank(objects: Objects, number: int) -> Objects:
    """Return the first of some objects for 1, the last one for -1; none where there are fewer."""
    place = number - 1 if number > 0 else number
    return objects[place : place + 1 or None] if -len(objects) <= place < len(objects) else ()


def _without_portion(argument: TypedArgument, whole: TypedArgument) -> TypedArgument:
    """Return what a portion is of: "the biggest furniture" for "the biggest piece of furniture"."""
    return replace(
        whole,
        quantifier=argument.quantifier,
        modifiers=(*argument.modifiers, *whole.modifiers),
        possessor=argument.possessor or whole.possessor,
        frames=(*argument.frames, *whole.frames),
    )


def is_of_unknown_speaker(argument: TypedArgument, situation: Situation) -> bool:
    """Whether a phrase is about what belongs to the person who speaks, and nobody knows who that is: "my mug"."""
    possessor = argument.possessor
    return possessor is not None and possessor.head.lower() in _SPEAKER and not situation.speaker


def is_speaker_asked_for(argument: TypedArgument, situation: Situation, found: Objects) -> bool:
    """Whether it must be asked who speaks, to know which of the things that a phrase may mean are theirs."""
    return is_of_unknown_speaker(argument, situation) and any(one.related("of") for one in found)


def _possessed(found: Objects, possessor: TypedArgument, situation: Situation) -> Objects:
    """Return those of some objects that somebody has.

    Whoever says "my keys" has keys: where the robot knows none that are theirs, it means those that are nobody's as
    far as it knows.
    """
    owners = _owners(possessor, situation)
    theirs = tuple(one for one in found if owners & set(one.related("of")))
    if theirs or possessor.head.lower() not in _SPEAKER:
        return theirs
    owned = tuple(one for one in found if one.related("of"))
    return owned if owned and not situation.speaker else tuple(one for one in found if one not in owned)


def _is_name(found: Objects, argument: TypedArgument) -> bool:
    """Whether the whole phrase is the name of what was found: "Anna's room", "the Bank of England"."""
    name = spoken(without_determiner(argument.text, _DETERMINERS))
    return bool(found) and all(name in map(spoken, one.names) for one in found)


def _by_head(argument: TypedArgument, situation: Situation, is_wide: bool) -> Objects:
    """Return what has the name, or is of the kind, and has the adjectives of a phrase."""
    world = situation.world
    head, lemma = argument.head.lower(), argument.lemma.lower()
    said = without_determiner(argument.text, _DETERMINERS)
    named = world.named(said) or world.named(argument.text)
    if named and len(said.split()) > 1:
        return named
    compounds = [modifier for modifier in argument.modifiers if modifier.kind in ("compound", "name")]
    others = [modifier for modifier in argument.modifiers if modifier.kind in ("adjective", "comparative")]
    if head in _STANDINS and situation.offered:
        return _with(situation.objects(situation.offered), [*compounds, *others])
    if situation.offered and not named and not world.kinds_of(lemma):
        # "Red." or "the red" in answer to "Which mug?"
        return _with(situation.objects(situation.offered), [Modifier("adjective", head, lemma), *compounds, *others])
    if head in _PRONOUNS and argument.quantifier == "":
        return situation.objects(situation.spoken_of[:1])
    if head in _PRONOUNS_OF_PLACES:
        return (situation.here,) if head == "here" and situation.here is not None else ()
    if head in _HEARERS:
        return situation.objects(["robot"])
    whole = " ".join([modifier.word for modifier in compounds if modifier.position < argument.head_position] + [lemma])
    exact = named or world.named(whole) or world.named(head) or world.exactly(whole)
    if exact and not is_wide:
        fits = _with(exact, others if whole != lemma else [*compounds, *others])
        if fits:
            return fits
    general = _general(head, lemma, world)
    kinds = general if general is not None else world.kinds_of(lemma)
    found = _with(kinds, compounds) if whole != lemma else kinds
    if exact or whole != lemma:
        every = (*exact, *(world.kinds_of(whole) if whole != lemma else ()), *found)
        found = tuple({one.id: one for one in every}.values())
    mine = tuple(one for one in found if one.id in situation.offered) if situation.offered else found
    return _with(mine, others)


def _general(head: str, lemma: str, world: World) -> Optional[Objects]:
    """Return the objects of a noun that names a whole sort: "thing", "person", "room"; None for another noun."""
    if {head, lemma} & _GENERAL_THINGS or head in _STANDINS:
        return world.of_sorts(Sort.THING, Sort.DEVICE)
    if {head, lemma} & _PERSON_NOUNS:
        return world.of_sorts(Sort.PERSON)
    if {head, lemma} & _PLACE_NOUNS:
        return world.of_sorts(Sort.PLACE)
    return None


def _with(objects: Iterable[WorldObject], modifiers: Iterable[Modifier]) -> Objects:
    """Return the objects that are known to have all of some properties."""
    found = tuple(objects)
    for modifier in modifiers:
        words = {modifier.word.lower(), modifier.lemma.lower()} - {""}
        found = tuple(one for one in found if words & one.properties)
    return found


def _owners(possessor: TypedArgument, situation: Situation) -> Set[str]:
    if possessor.head.lower() in _SPEAKER:
        return {situation.speaker} - {""}
    return {one.id for one in fitting(possessor, replace(situation, offered=()))}


def _of(objects: Objects, complement: TypedArgument, situation: Situation) -> Objects:
    wholes = fitting(complement, replace(situation, offered=()))
    ids = {one.id for one in wholes}
    inside = situation.world.at("in", wholes)
    return tuple(
        one
        for one in objects
        if one.id in inside or any(relation.relation in _OF and relation.reference in ids for relation in one.relations)
    )


def described(objects: Objects, description: EmbeddedFrame, situation: Situation) -> Objects:
    """Return the objects that a description is true of: "on the table", "that is in the kitchen", "that you closed"."""
    if is_deed(description):
        done = situation.deeds.done_to(description, lambda one: frozenset(it.id for it in fitting(one, situation)))
        return tuple(one for one in objects if (one.id in done) is not description.is_negated)
    if description.head_element == "location":
        return tuple(one for one in objects if _holds(one, description.frame_elements, situation))
    place = next((element for element in description.frame_elements if element.relation or element.direction), None)
    if place is None:
        words = set(description.words.lower().split())
        return tuple(one for one in objects if words & set(map(str.lower, one.states)))
    fits = at_place(objects, place, situation)
    if description.is_negated:
        return tuple(one for one in objects if one not in fits)
    return fits


def _holds(place: WorldObject, elements: Iterable[TypedArgument], situation: Situation) -> bool:
    """Whether somebody or something is in or on a place: "the room where *Anna* is"."""
    themes = [one.id for element in elements for one in fitting(element, replace(situation, offered=()))]
    there = situation.world.at("in", (place,)) | situation.world.at("on", (place,))
    return not there.isdisjoint(themes)


def at_place(objects: Objects, place: TypedArgument, situation: Situation) -> Objects:
    """Return the objects that are at a place: "on the table", "on the left", "in the kitchen or in the hall"."""
    if place.direction in ("left", "right"):
        return _outermost(objects, place.direction, situation)
    there: Set[str] = set()
    for one in place.members or (place,):
        is_here = one.head.lower() in _PRONOUNS_OF_PLACES
        relation = one.relation or place.relation or ("in" if is_here else "")
        there |= situation.world.at(relation, fitting(one, replace(situation, offered=())), objects)
    return tuple(one for one in objects if one.id in there)


def _outermost(objects: Objects, side: str, situation: Situation) -> Objects:
    """Return the leftmost or the rightmost of some objects, as the robot sees them."""
    robot = situation.world.robot
    poses = [one.pose for one in objects if one.pose is not None]
    if robot is None or robot.pose is None or not objects or len(poses) < len(objects):
        return ()
    viewer = robot.pose
    cosine, sine = math.cos(viewer.heading_rad), math.sin(viewer.heading_rad)
    to_the_left_m = [pose.y_m * cosine - pose.x_m * sine for pose in poses]
    most_m = max(to_the_left_m) if side == "left" else min(to_the_left_m)
    return (objects[to_the_left_m.index(most_m)],)


def most_of(objects: Objects, superlatives: Sequence[Modifier], situation: Situation, place: int = 1) -> Objects:
    """Return the object with the most of some properties; none when it is not known of any.

    Args:
        objects: those that may be meant
        superlatives: what is to be the most: "biggest"
        situation: what is known
        place: 2 for "the second biggest", -1 for the last one
    """
    for modifier in superlatives:
        wanted = measure(modifier.word)
        objects = _at_rank(in_order(objects, wanted, situation.world), place) if wanted is not None else ()
    return objects
