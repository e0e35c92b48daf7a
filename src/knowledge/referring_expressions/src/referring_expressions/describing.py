"""Describes objects so that a person can tell them apart: "the red one in the kitchen"."""

from typing import Dict, List, Sequence, Tuple

from semantic_types import shipped_nouns
from typed_arguments import TypedArgument
from word_classes import without_determiner, word_class
from world_model import Sort, World, WorldObject
from world_model.nouns import category_of
from world_model.world_object import LEADS_TO

#: A question names this many objects, and counts them if there are more.
MOST_NAMED = 4
#: Whose something is, from the view of the robot.
_YOURS = {"my": "your", "your": "my", "our": "our"}
_PERSONS = word_class("general_person_nouns")
_THING = "thing"
_INDEFINITE = frozenset(["any", "some", "no", "other"])
#: How a person says a relation.
_SPOKEN = {
    "in_front_of": "in front of",
    "left_of": "left of",
    "right_of": "right of",
    "next_to": "next to",
    "near": "near",
}


def noun_of(one: WorldObject) -> str:
    """Return the noun for an object: its category, or what it is at least."""
    return category_of(one) or one.name or one.sort.value


def name_of(one: WorldObject) -> str:
    """Return how a person calls an object: "Anna", "the kitchen", "the mug"."""
    if one.sort is Sort.PERSON and one.name:
        return one.name
    name = one.name or noun_of(one)
    return name if name[:1].isupper() else f"the {name}"


def place_of(one: WorldObject, world: World, *, is_whole: bool = True) -> str:
    """Return where an object is, in words: "on the table in the kitchen"; empty when unknown.

    Args:
        one: the object
        world: what the robot knows
        is_whole: whether to add the room of what it is on
    """
    place = next((place for place in one.places if world.get(place.reference) is not None), None)
    room = world.room_of(one) if one.sort is not Sort.PLACE else None
    if place is None:
        return f"in {name_of(room)}" if room is not None else ""
    other = world.by_id[place.reference]
    if place.relation == "held_by":
        near = f"held by {name_of(other)}" if other.sort is not Sort.ROBOT else "in my hand"
    else:
        near = f"{_SPOKEN.get(place.relation, place.relation.replace('_', ' '))} {name_of(other)}"
    is_elsewhere = room is not None and room.id != other.id
    return f"{near} in {name_of(room)}" if is_whole and is_elsewhere and room is not None else near


def describe(one: WorldObject, world: World, noun: str = "one") -> str:
    """Return a phrase for an object among others: "the red one in the kitchen"."""
    return _phrase(one, world, one.attributes, _room(one, world) or place_of(one, world), noun)


def _room(one: WorldObject, world: World) -> str:
    room = world.room_of(one)
    return f"in {name_of(room)}" if room is not None else ""


def _with_state(one: WorldObject, world: World, noun: str) -> str:
    return _phrase(one, world, one.attributes + one.states, _room(one, world) or place_of(one, world), noun)


def _in_full(one: WorldObject, world: World, noun: str) -> str:
    return _phrase(one, world, one.attributes + one.states, place_of(one, world), noun)


def _phrase(one: WorldObject, world: World, properties: Sequence[str], place: str, noun: str) -> str:
    if one.name:
        return name_of(one)
    owners = " and ".join(name_of(owner) for owner in world.owners(one))
    owned = f"of {owners}" if owners else ""
    beyond = " and ".join(name_of(other) for name in one.related(LEADS_TO) for other in [world.get(name)] if other)
    leads = f"to {beyond}" if beyond else ""
    return " ".join(filter(None, ["the", *properties, noun, owned, leads, place]))


def group_alike(objects: Sequence[WorldObject], world: World) -> Tuple[Tuple[WorldObject, ...], ...]:
    """Group objects that no description tells apart."""
    groups: Dict[str, List[WorldObject]] = {}
    for one in objects:
        groups.setdefault(_in_full(one, world, noun_of(one)), []).append(one)
    return tuple(map(tuple, groups.values()))


def descriptions(objects: Sequence[WorldObject], world: World) -> Tuple[str, ...]:
    """Return a phrase for each object, no longer than needed to tell them apart."""
    nouns = [noun_of(one) for one in objects]
    # "The thing" may be a mug or a book.
    names = ["one"] * len(nouns) if len(set(nouns)) == 1 else nouns
    for phrase_of in (describe, _with_state):
        found = tuple(phrase_of(one, world, noun) for one, noun in zip(objects, names))
        if len(set(found)) == len(found):
            return found
    return tuple(_in_full(one, world, noun) for one, noun in zip(objects, names))


def question_of(noun: str, objects: Sequence[WorldObject], world: World) -> str:
    """Return the question which of several objects is meant; of many, the first ones are named."""
    options = descriptions(objects[:MOST_NAMED], world)
    if len(objects) > MOST_NAMED:
        return f"Which {noun}, {', '.join(options)} or another one? I know of {len(objects)}."
    return f"Which {noun}, {', '.join(options[:-1])} or {options[-1]}?"


def question_of_speaker(objects: Sequence[WorldObject], world: World) -> str:
    """Return the question who speaks, for things of which one belongs to the person who speaks."""
    owned = [f"the {noun_of(one)} of {name_of(owner)}" for one in objects[:MOST_NAMED] for owner in world.owners(one)]
    return f"Who are you? I know {' and '.join(filter(None, (', '.join(owned[:-1]), *owned[-1:])))}."


def unknown_of(argument: TypedArgument) -> str:
    """Return a sentence that says that nothing is known of what a phrase refers to: "I know of no mug."."""
    if argument.semantic_type == "Human" and not argument.quantifier:
        return f"I do not know {as_said(argument)}."
    return f"I know of {none_of(argument)}."


def none_of(argument: TypedArgument) -> str:
    """Return the noun of a phrase for none of it: "no red mug", "nothing red" for "anything red"."""
    noun = bare_noun(argument)
    first, *rest = noun.split()
    is_anything = first.lower().endswith(_THING) and first.lower() != _THING
    return " ".join([f"no{_THING}", *rest]) if is_anything else f"no {noun}"


def as_said(argument: TypedArgument) -> str:
    """Return a phrase from the view of the robot: "your mug" for "my mug"."""
    first, _, rest = argument.text.partition(" ")
    return f"{_YOURS.get(first.lower(), first if first[:3] != 'The' else 'the')} {rest}".strip()


def bare_noun(argument: TypedArgument) -> str:
    """Return the noun of a phrase with its adjectives and without its determiner: "red mug"."""
    words = without_determiner(argument.text, word_class("determiners_and_possessives")) or argument.text
    return without_determiner(words, _INDEFINITE)


def counted_noun(argument: TypedArgument, count: int) -> str:
    """Return the noun of a phrase as it stands behind a number: "1 person", "2 red mugs"."""
    if count != 1:
        return bare_noun(argument)
    if argument.lemma in _PERSONS:
        return "person"
    return argument.lemma if argument.is_plural else bare_noun(argument)


def is_plural_noun(noun: str) -> bool:
    """Whether the name of one thing is a plural: "keys", "glasses"."""
    last = noun.lower().split()[-1] if noun.split() else ""
    if not last.endswith("s") or last.endswith(("ss", "us", "is")):
        return False
    singulars = [last[:-1], last[:-2] if last.endswith("es") else last[:-1]]
    return any(shipped_nouns().types(singular).types for singular in singulars)


def plural_of(noun: str) -> str:
    """Return the plural of a noun."""
    if is_plural_noun(noun):
        return noun
    return f"{noun}{'es' if noun.endswith(('s', 'x', 'ch', 'sh')) else 's'}"


def article(noun: str) -> str:
    """Return a noun with its indefinite article; a plural has none."""
    if is_plural_noun(noun):
        return noun
    is_vowel = noun[:1].lower() in "aeiou" and not noun.lower().startswith(("uni", "use", "eu", "one"))
    return f"{'an' if is_vowel else 'a'} {noun}"
