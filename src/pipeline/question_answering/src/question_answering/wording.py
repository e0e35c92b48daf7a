"""How answers speak of the objects that a question is about, and which objects these are."""

from datetime import datetime
from typing import Dict, List, Mapping, Optional, Sequence, Set, Tuple

from question_answering.robot_knowledge import RobotKnowledge
from referring_expressions import fitting
from referring_expressions.describing import (
    article,
    as_said,
    bare_noun,
    is_plural_noun,
    name_of,
    noun_of,
    plural_of,
)
from referring_expressions.fitting import at_place
from semantic_types import spoken
from typed_arguments import Source, TypedArgument
from word_classes import word_class
from world_model import Sort, WorldObject

#: The arguments of a question, by the names of their elements.
Arguments = Mapping[str, TypedArgument]
Objects = Tuple[WorldObject, ...]
_ANY = word_class("indefinite_articles")
#: Nouns for whatever there is: no kinds.
_GENERAL = (
    word_class("general_thing_nouns")
    | word_class("general_person_nouns")
    | word_class("general_place_nouns")
    | word_class("noun_standins")
    | word_class("measure_nouns")
)
#: Objects that an answer names; more are counted.
MOST_NAMED = 8


def full_name(one: WorldObject) -> str:
    """Return an object with its article and its attributes: "the red mug", "Anna"."""
    return name_of(one) if one.name else f"the {' '.join([*one.attributes, noun_of(one)])}"


def found_of(theme: Optional[TypedArgument], known: RobotKnowledge, *, is_wide: bool = False) -> Objects:
    """Return what a phrase refers to: what the framer found, where that is still known.

    What was meant stays what is meant: the apple "on the table" that somebody has eaten since is that apple.
    """
    if theme is None:
        return ()
    situation = known.situation
    meant = () if is_wide else situation.objects(theme.referents)
    return meant or fitting(theme, situation, is_wide=is_wide)


def when_known(objects: Sequence[WorldObject], known: RobotKnowledge) -> str:
    """Return when an earlier run learned something of some objects, or else of any: "yesterday at 14:05"."""
    times_s = _times_of_before(objects) or _times_of_before(known.world.objects)
    return day_and_time(datetime.fromtimestamp(max(times_s, default=0.0)), known.now)


def _times_of_before(objects: Sequence[WorldObject]) -> List[float]:
    return [time_s for one in objects for time_s in (one.place_of_before_s, one.states_of_before_s) if time_s]


def day_and_time(then: datetime, now: datetime) -> str:
    """Return a time that is over, as people tell it: "today at 14:05", "on Monday at 9:30", "on 3 May at 17:00"."""
    days = (now.date() - then.date()).days
    if days in (0, 1):
        day = "yesterday" if days else "today"
    elif 1 < days < 7:
        day = f"on {then:%A}"
    else:
        day = f"on {then.day} {then:%B}{'' if then.year == now.year else f' {then.year}'}"
    return f"{day} at {then.hour}:{then:%M}"


def at_location(arguments: Arguments, objects: Objects, known: RobotKnowledge) -> Objects:
    """Return those of some objects that are at the place that a question names; all of them if it names none."""
    location = arguments.get("location")
    return objects if location is None else at_place(objects, location, known.situation)


def is_known_place(location: TypedArgument, known: RobotKnowledge) -> bool:
    """Whether the robot knows a place that a phrase may mean."""
    return bool(location.direction or fitting(location, known.situation))


def is_definite(theme: TypedArgument) -> bool:
    """Whether a phrase is about one thing or person that both know: "the mug", "my mug", "Anna"."""
    return theme.quantifier == "the" or theme.possessor is not None or theme.semantic_type == "Human"


def name_for(theme: TypedArgument, one: WorldObject) -> str:
    """Return how an answer calls an object: as it was asked for, or by its own noun: the "cloth" is a blanket."""
    is_its_noun = theme.lemma.lower() in (noun_of(one), noun_of(one).split()[-1])
    if one.name or not is_its_noun:
        # "It" was "the mug on the table" when it was spoken of.
        return full_name(one) if theme.source is Source.INFERRED else name_of(one)
    # "Your keys" are those of which the robot knows whose they are.
    return definite(theme) if theme.possessor is None or one.related("of") else f"the {bare_noun(theme)}"


def is_only_of_the_kind(theme: TypedArgument, one: WorldObject) -> bool:
    """Whether the noun that was said names the kind of an object, but not the object: the toolbox is a "box", and may
    not be the box that is meant; nor is the towel the "cloth"."""
    if theme.source is Source.INFERRED:
        return False  # "It" names no kind.
    said = {theme.lemma.lower(), theme.head.lower()}
    return one.sort is not Sort.PERSON and not said & _GENERAL and not _called(one) & said


def called_as_said(theme: TypedArgument, objects: Objects) -> Objects:
    """Return those of some objects that have the noun that was said, and are not only of its kind: of a pot and a
    kettle the pot; all of them if none has."""
    return tuple(one for one in objects if not is_only_of_the_kind(theme, one)) or objects


def _called(one: WorldObject) -> Set[str]:
    """Return the nouns for an object; of one that has a name, its category is only the kind."""
    names = [spoken(name) for name in (one.name or noun_of(one), *one.other_names)]
    return {word for name in names for word in (name, name.split()[-1])}


def definite(theme: TypedArgument) -> str:
    """Return a phrase for the one thing that is meant: "the mug" for "a mug" and for "mug" in "whose mug is this"."""
    if theme.quantifier in _ANY or not theme.quantifier:
        return f"the {bare_noun(theme)}" if theme.possessor is None else as_said(theme)
    return as_said(theme)


def plural(theme: TypedArgument, found: Sequence[WorldObject]) -> str:
    """Return the noun for several objects: as it was said, if that is a plural."""
    return bare_noun(theme) if theme.is_plural else plural_of(noun_of(found[0]))


def with_attributes(one: WorldObject, part: str) -> str:
    """Return what is said of an object, with its attributes before it if it has no name: "the red one is here"."""
    return f"the {' '.join(one.attributes)} {part}" if one.attributes and not one.name else part


def indefinite(objects: Sequence[WorldObject]) -> List[str]:
    """Return objects as a person lists them: "Anna", "two red mugs", "a box"."""
    groups: Dict[str, int] = {}
    for one in objects:
        word = one.name or " ".join([*one.attributes, noun_of(one)])
        groups[word] = groups.get(word, 0) + 1
    names = {spoken(name) for one in objects for name in one.names}
    found = []
    for word, count in groups.items():
        if spoken(word) in names:
            found.append(word if word[:1].isupper() else f"the {word}")
        else:
            found.append(article(word) if count == 1 else f"{count} {plural_of(word)}")
    return found if len(found) <= MOST_NAMED else [*found[:MOST_NAMED], f"{len(found) - MOST_NAMED} more"]


def verb_of(found: Sequence[WorldObject], noun: str) -> str:
    """Return "is" or "are"."""
    return "is" if len(found) == 1 and not is_plural_noun(noun) else "are"


def reported(one: WorldObject) -> str:
    """Return who told where a person is: ", as Ben said"; empty if the robot has seen it."""
    return f", as {one.source} said" if one.source and one.sort is Sort.PERSON and one.source.istitle() else ""
