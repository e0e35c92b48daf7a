"""Answers to questions about the world: where, how many, which, whether; each says what is not known."""

import datetime
from dataclasses import replace
from typing import Callable, Dict, FrozenSet, List, Mapping, Optional, Sequence, Tuple

from question_answering.answers_about_deeds import ABOUT_DEEDS
from question_answering.robot_knowledge import RobotKnowledge
from referring_expressions import fitting, unknown_of
from referring_expressions.describing import (
    article,
    as_said,
    bare_noun,
    counted_noun,
    is_plural_noun,
    name_of,
    noun_of,
    place_of,
    plural_of,
)
from referring_expressions.fitting import at_place, is_of_unknown_speaker, is_superlative
from roboframenet_ros.spoken_text import join_with_and, with_capital
from semantic_types import spoken
from typed_arguments import Modifier, TypedArgument
from word_classes import word_class
from world_model import Sort, World, WorldObject
from world_model.knowledge import OPPOSITES
from world_model.world_object import ROBOT_ID

#: Objects that an answer names; more are counted.
MOST_NAMED = 8
#: The frame of whoever says who they are.
BEING_NAMED = "being_named"
Arguments = Mapping[str, TypedArgument]
_COLOURS = word_class("colours")
#: What other words for a state mean.
_STATES = {**dict.fromkeys(word_class("words_for_on"), "on"), **dict.fromkeys(word_class("words_for_closed"), "closed")}


def answer(frame_name: str, arguments: Sequence[TypedArgument], known: RobotKnowledge) -> str:
    """Return the answer to a question, as sentences for a person.

    Args:
        frame_name: of a question
        arguments: of its elements
        known: what the robot knows of itself and of the world
    Raises:
        KeyError: there is no such question
    """
    mine = next((one for one in arguments if is_of_unknown_speaker(one, known.situation)), None)
    if mine is not None and fitting(mine, known.situation):
        return _of_somebody(mine, known)
    return ANSWERS[frame_name]({argument.name: argument for argument in arguments}, known)


def _of_somebody(mine: TypedArgument, known: RobotKnowledge) -> str:
    """Return where the things are one of which belongs to the person who speaks."""
    parts = []
    for one in fitting(mine, known.situation)[:MOST_NAMED]:
        owners = join_with_and(map(name_of, known.world.owners(one))) or "somebody"
        parts.append(f"the {noun_of(one)} of {owners} is {place_of(one, known.world) or 'somewhere unknown'}")
    return f"I do not know who you are. {with_capital(join_with_and(parts))}."


def _abilities(_: Arguments, known: RobotKnowledge) -> str:
    examples = known.abilities
    if not examples:
        return "I cannot do anything at the moment: nothing that acts is running."
    shown = [f'"{example}"' for example in examples[:MOST_NAMED]]
    more = f" I can do {known.ability_count} things in all." if known.ability_count > len(shown) else ""
    return f"You can say, for example: {join_with_and(shown)}.{more}"


def _identity(_: Arguments, known: RobotKnowledge) -> str:
    return f"I am {known.name}, a robot that understands English. Ask me what I can do."


def _own_place(_: Arguments, known: RobotKnowledge) -> str:
    robot = known.world.robot
    place = place_of(robot, known.world) if robot is not None else ""
    if place:
        return f"I am {place}."
    if robot is not None and robot.pose is not None:
        x_m, y_m, frame_id = robot.pose.x_m, robot.pose.y_m, robot.pose.frame_id
        return f"I am at x {x_m:.1f} m, y {y_m:.1f} m of {frame_id}, in no place that I know."
    return "I do not know where I am."


def _activity(_: Arguments, known: RobotKnowledge) -> str:
    doing = known.doing
    return f'I am carrying out "{doing}".' if doing else "I am doing nothing at the moment."


def _last_words(_: Arguments, known: RobotKnowledge) -> str:
    return f'You said "{known.last_words}".' if known.last_words else "You have not said anything before."


def _last_reply(_: Arguments, known: RobotKnowledge) -> str:
    return f'I said: "{known.last_reply}"' if known.last_reply else "I have not said anything before."


def _place(arguments: Arguments, known: RobotKnowledge) -> str:
    theme = arguments["theme"]
    found = _found(theme, known)
    if not found:
        return unknown_of(theme)
    if found[0].id == ROBOT_ID:
        return _own_place(arguments, known)
    placed = [(one, place_of(one, known.world)) for one in found]
    if not any(place for _, place in placed):
        return f"I do not know where {as_said(theme)} {_is(found, theme.text)}."
    if len(found) == 1:
        called = _called(theme, found[0])
        where = f"{_is(found, called)} {placed[0][1]}{_reported(found[0])}"
        if _is_only_of_the_kind(theme, found[0]):
            return f"I know of no {bare_noun(theme)} but {called}, which {where}."
        return f"{with_capital(called)} {where}."
    parts = [f"{'one' if not one.name else name_of(one)} is {place or 'somewhere unknown'}" for one, place in placed]
    known_of = f"I know of {len(found)} {_plural(theme, found)}: "
    named = join_with_and(_with_attributes(one, part) for (one, _), part in zip(placed[:MOST_NAMED], parts))
    return f"{known_of}{named}."


def _number(arguments: Arguments, known: RobotKnowledge) -> str:
    location = arguments.get("location")
    if location is not None and not location.relation and not location.direction:
        # "How many lamps does the hall have": what a place has is in it.
        inside = replace(location, relation="in", words=f"in {location.words}")
        return _number({**arguments, "location": inside}, known)
    theme = arguments["theme"]
    found = _at(arguments, _found(theme, known, is_wide=True), known)
    where = f" {location.words[:1].lower()}{location.words[1:]}" if location is not None else ""
    if "state" in arguments:
        state = arguments["state"].text.lower()
        found = tuple(one for one in found if state in one.states)
        where += f" that are {state}"
    if "location" in arguments and not _place_is_known(arguments["location"], known):
        return f'I do not know of any place "{arguments["location"].text}".'
    if not found:
        return f"I know of no {bare_noun(theme)}{where}."
    verb = "is" if len(found) == 1 else "are"
    return f"As far as I know, there {verb} {len(found)} {counted_noun(theme, len(found))}{where}."


def _what_is_there(arguments: Arguments, known: RobotKnowledge) -> str:
    location, theme = arguments["location"], arguments.get("theme")
    if not _place_is_known(location, known):
        return f'I do not know of any place "{location.text}".'
    everything = tuple(
        one for one in known.world.objects if one.id != ROBOT_ID and one.sort not in (Sort.PLACE, Sort.DOOR)
    )
    objects = _found(theme, known, is_wide=True) if theme is not None else everything
    found = at_place(objects, location, known.situation)
    if not found:
        what = f"no {bare_noun(theme)}" if theme is not None else "nothing"
        return f"I know of {what} {location.words}."
    return f"{with_capital(location.words)} there {_is(found, noun_of(found[0]))} {join_with_and(_indefinite(found))}."


def _who_is_there(arguments: Arguments, known: RobotKnowledge) -> str:
    location = arguments["location"]
    if not _place_is_known(location, known):
        return f'I do not know of any place "{location.text}".'
    persons = tuple(one for one in known.world.objects if one.sort is Sort.PERSON)
    found = at_place(persons, location, known.situation)
    if not found:
        return f"I know of nobody {location.words}."
    return f"{with_capital(join_with_and(_indefinite(found)))} {'is' if len(found) == 1 else 'are'} {location.words}."


def _state(arguments: Arguments, known: RobotKnowledge) -> str:
    theme, said = arguments["theme"], arguments["state"].text.lower()
    state = _STATES.get(said, said)
    found = _found(theme, known)
    if not found:
        return unknown_of(theme)
    opposites: FrozenSet[str] = frozenset().union(*(words for words in OPPOSITES if state in words)) - {state}
    verdicts = {True if state in one.properties else False if opposites & set(one.states) else None for one in found}
    name = with_capital(_called(theme, found[0])) if len(found) == 1 else with_capital(as_said(theme))
    verb = _is(found, name)
    is_choice = "alternative" in arguments
    if verdicts == {True}:
        return f"{name} {verb} {state}." if is_choice else f"Yes, {_lower(name)} {verb} {state}."
    if verdicts == {False}:
        actual = next(iter(sorted(opposites & set(found[0].states))))
        return f"{name} {verb} {actual}." if is_choice else f"No, {_lower(name)} {verb} {actual}."
    if None in verdicts:
        return f"I do not know whether {_lower(name)} {verb} {state}."
    return f"Some of them are {state}, and some are not."


def _being_there(arguments: Arguments, known: RobotKnowledge) -> str:
    theme = arguments["theme"]
    candidates = _found(theme, known, is_wide=True)
    where = f" {arguments['location'].words}" if "location" in arguments else ""
    if "location" in arguments and not _place_is_known(arguments["location"], known):
        return f'I do not know of any place "{arguments["location"].text}".'
    found = _at(arguments, candidates, known)
    if found:
        names = join_with_and(_indefinite(found)) if not _is_definite(theme) else _called(theme, found[0])
        verb = _is(found, names)
        return f"Yes, {names} {verb}{where}." if where else f"Yes, I know of {names}."
    if not candidates:
        return unknown_of(theme)
    if len(candidates) == 1 and place_of(candidates[0], known.world):
        called = _called(theme, candidates[0])
        return f"No, {called} {_is(candidates, called)} {place_of(candidates[0], known.world)}."
    return (
        f"No, I know of no {bare_noun(theme)}{where}."
        if not _is_definite(theme)
        else f"I do not know that {as_said(theme)} is{where}."
    )


def _time(_: Arguments, known: RobotKnowledge) -> str:
    return f"It is {known.now:%H:%M}."


def _date(arguments: Arguments, known: RobotKnowledge) -> str:
    said = arguments["day"].text.lower() if "day" in arguments else "today"
    days = {"today": 0, "tomorrow": 1, "yesterday": -1}
    if said not in days:
        return f'I do not know which day you mean by "{said}".'
    day = known.now + datetime.timedelta(days=days[said])
    subject = {"today": "It is", "tomorrow": "Tomorrow is", "yesterday": "Yesterday was"}[said]
    return f"{subject} {day:%A}, {day.day} {day:%B %Y}."


def _acquaintance(arguments: Arguments, known: RobotKnowledge) -> str:
    theme = arguments["theme"]
    found = _found(theme, known)
    if not found:
        return f"No, I do not know {as_said(theme)}."
    one = found[0]
    if len(found) > 1:
        return f"Yes, I know {len(found)} of them."
    facts: List[str] = []
    if one.sort is Sort.PERSON:
        facts.append("is a person")
    elif noun_of(one) and one.name:
        facts.append(f"is {article(noun_of(one))}")
    place = place_of(one, known.world)
    if place:
        facts.append(f"is {place}")
    if one.states:
        facts.append(f"is {join_with_and(one.states)}")
    if one.attributes:
        facts.append(f"is {join_with_and(one.attributes)}")
    return (
        f"Yes. {with_capital(_called(theme, one))} {join_with_and(facts)}."
        if facts
        else f"Yes, I know {as_said(theme)}."
    )


def _which(arguments: Arguments, known: RobotKnowledge) -> str:
    theme, rank = arguments["theme"], arguments.get("rank")
    if rank is not None:
        theme = replace(theme, modifiers=(*theme.modifiers, Modifier("superlative", rank.text, rank.text)))
    superlatives = tuple(one for one in theme.modifiers if is_superlative(one))
    words = {one.word.lower() for one in superlatives}
    others = replace(
        theme,
        text=" ".join(word for word in theme.text.split() if word.lower() not in words),
        modifiers=tuple(one for one in theme.modifiers if one not in superlatives),
    )
    candidates = fitting(others, known.situation, is_wide=True)
    if not candidates:
        return unknown_of(others)
    if not superlatives:
        return f"I know of {join_with_and(_indefinite(candidates))}."
    found = fitting(theme, known.situation, is_wide=True)
    if not found:
        return f"I do not know which {bare_noun(others)} is the {superlatives[0].word.lower()}."
    place = place_of(found[0], known.world)
    return f"It is {_named(found[0])}{f' {place}' if place else ''}."


def _owner(arguments: Arguments, known: RobotKnowledge) -> str:
    theme = arguments["theme"]
    found = _found(theme, known)
    if not found:
        return unknown_of(theme)
    owners = [(one, known.world.owners(one)) for one in found]
    if not any(persons for _, persons in owners):
        return f"I do not know whom {as_said(theme)} {'belongs' if len(found) == 1 else 'belong'} to."
    if len(found) == 1:
        return f"{with_capital(_called(theme, found[0]))} belongs to {join_with_and(map(name_of, owners[0][1]))}."
    parts = [
        f"{_named(one)} to {join_with_and(map(name_of, persons)) or 'somebody whom I do not know'}"
        for one, persons in owners[:MOST_NAMED]
    ]
    return f"I know of {len(found)} {_plural(theme, found)}: {join_with_and(parts)}."


def _colour(arguments: Arguments, known: RobotKnowledge) -> str:
    theme = arguments["theme"]
    found = _found(theme, known)
    if not found:
        return unknown_of(theme)
    colours = [tuple(word for word in one.attributes if word.lower() in _COLOURS) for one in found]
    if not all(colours):
        return f"I do not know the colour of {as_said(theme)}."
    if len(set(colours)) == 1:
        called = _called(theme, found[0]) if len(found) == 1 else as_said(theme)
        return f"{with_capital(called)} {_is(found, called)} {join_with_and(colours[0])}."
    parts = [
        f"the one {place_of(one, known.world) or 'somewhere unknown'} is {join_with_and(words)}"
        for one, words in zip(found[:MOST_NAMED], colours)
    ]
    return f"I know of {len(found)} {_plural(theme, found)}: {join_with_and(parts)}."


def _speaker(_: Arguments, known: RobotKnowledge) -> str:
    person = known.world.get(known.speaker)
    if person is None:
        return "I do not know who you are."
    return f"You are {name_of(person)}."


def person_named(name: str, world: World) -> WorldObject:
    """Return the person of a name; one who is not known yet gets an id made of the name."""
    wanted = spoken(name)
    for one in world.objects:
        if one.sort is Sort.PERSON and wanted in {spoken(other) for other in one.names}:
            return one
    letters = "".join(character if character.isascii() and character.isalnum() else "_" for character in wanted)
    return WorldObject(f"person_{letters}"[:100], Sort.PERSON, name=name)


def _being_named(arguments: Arguments, known: RobotKnowledge) -> str:
    return f"Hello, {name_of(person_named(arguments['name'].text, known.world))}."


def _named(one: WorldObject) -> str:
    """Return an object with its article and its attributes: "the red mug", "Anna"."""
    return name_of(one) if one.name else f"the {' '.join([*one.attributes, noun_of(one)])}"


#: The answer to each question, by the name of its frame.
ANSWERS: Dict[str, Callable[[Arguments, RobotKnowledge], str]] = {
    "question_of_abilities": _abilities,
    "question_of_identity": _identity,
    "question_of_own_place": _own_place,
    "question_of_activity": _activity,
    "question_of_last_words": _last_words,
    "question_of_last_reply": _last_reply,
    "question_of_place": _place,
    "question_of_number": _number,
    "question_of_what_is_there": _what_is_there,
    "question_of_who_is_there": _who_is_there,
    "question_of_state": _state,
    "question_of_being_there": _being_there,
    "question_of_time": _time,
    "question_of_date": _date,
    "question_of_acquaintance": _acquaintance,
    "question_of_which": _which,
    "question_of_owner": _owner,
    "question_of_colour": _colour,
    "question_of_speaker": _speaker,
    BEING_NAMED: _being_named,
    **ABOUT_DEEDS,
}


def _found(theme: Optional[TypedArgument], known: RobotKnowledge, *, is_wide: bool = False) -> Tuple[WorldObject, ...]:
    """Return what a phrase refers to: what the framer found, if it searched this world."""
    if theme is None:
        return ()
    situation = known.situation
    if theme.referents and theme.world_version == known.world.version and not is_wide:
        return situation.objects(theme.referents)
    return fitting(theme, situation, is_wide=is_wide)


def _at(arguments: Arguments, objects: Tuple[WorldObject, ...], known: RobotKnowledge) -> Tuple[WorldObject, ...]:
    location = arguments.get("location")
    return objects if location is None else at_place(objects, location, known.situation)


def _place_is_known(location: TypedArgument, known: RobotKnowledge) -> bool:
    return bool(location.direction or fitting(location, known.situation))


def _is_definite(theme: TypedArgument) -> bool:
    return theme.quantifier == "the" or theme.possessor is not None or theme.semantic_type == "Human"


def _called(theme: TypedArgument, one: WorldObject) -> str:
    """Return how an answer calls an object: as it was asked for, or by its own noun: the "cloth" is a blanket."""
    is_its_noun = theme.lemma.lower() in (noun_of(one), noun_of(one).split()[-1])
    return _definite(theme) if is_its_noun and not one.name else name_of(one)


def _is_only_of_the_kind(theme: TypedArgument, one: WorldObject) -> bool:
    """Whether the noun that was said names the kind of an object, but not the object: the toolbox is a "box", and may
    not be the box that is meant."""
    said = {theme.lemma.lower(), theme.head.lower()}
    named = {word for name in one.names for word in (spoken(name), spoken(name).split()[-1])}
    return bool(one.names) and one.sort is not Sort.PERSON and noun_of(one) in said and not named & said


def _definite(theme: TypedArgument) -> str:
    if theme.quantifier in ("a", "any", "some", ""):
        return f"the {bare_noun(theme)}" if theme.possessor is None else as_said(theme)
    return as_said(theme)


def _plural(theme: TypedArgument, found: Sequence[WorldObject]) -> str:
    return bare_noun(theme) if theme.is_plural else plural_of(noun_of(found[0]))


def _with_attributes(one: WorldObject, part: str) -> str:
    return f"the {' '.join(one.attributes)} {part}" if one.attributes and not one.name else part


def _indefinite(objects: Sequence[WorldObject]) -> List[str]:
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


def _is(found: Sequence[WorldObject], noun: str) -> str:
    return "is" if len(found) == 1 and not is_plural_noun(noun) else "are"


def _reported(one: WorldObject) -> str:
    return f", as {one.source} said" if one.source and one.sort is Sort.PERSON and one.source.istitle() else ""


def _lower(text: str) -> str:
    return text[:1].lower() + text[1:] if text.startswith(("The ", "Your ", "A ", "An ")) else text
