"""Answers to questions about the world: where, how many, which, whether; each says what is not known."""

import datetime
from dataclasses import replace
from typing import Callable, Dict, List, Sequence

from question_answering.answers_about_deeds import ABOUT_DEEDS
from question_answering.answers_about_events import ABOUT_EVENTS
from question_answering.answers_about_holders import ABOUT_HOLDERS, what_is_held
from question_answering.answers_about_measures import ABOUT_MEASURES
from question_answering.answers_about_states import ABOUT_STATES
from question_answering.robot_knowledge import RobotKnowledge
from question_answering.wording import (
    MOST_NAMED,
    Arguments,
    at_location,
    called_as_said,
    definite,
    found_of,
    full_name,
    indefinite,
    is_definite,
    is_known_place,
    is_only_of_the_kind,
    name_for,
    plural,
    reported,
    verb_of,
    when_known,
    with_attributes,
)
from referring_expressions import fitting, unknown_of
from referring_expressions.describing import (
    article,
    as_said,
    bare_noun,
    counted_noun,
    name_of,
    none_of,
    noun_of,
    place_of,
)
from referring_expressions.fitting import at_place, is_of_unknown_speaker, most_of
from roboframenet_ros.spoken_text import join_with_and, with_capital
from semantic_types import spoken
from typed_arguments import Modifier, Source, TypedArgument
from word_classes import word_class
from world_model import Sort, World, WorldObject
from world_model.world_object import FILE, ROBOT_ID

#: The frame of whoever says who they are.
BEING_NAMED = "being_named"
_COLOURS = word_class("colours")
#: Questions whose answers about one thing say themselves when it was learned.
_DATED = frozenset(["question_of_place", "question_of_state"])


def answer(frame_name: str, arguments: Sequence[TypedArgument], known: RobotKnowledge) -> str:
    """Return the answer to a question, as sentences for a person.

    What an earlier run of the robot knew is told with the time at which it was learned.

    Args:
        frame_name: of a question
        arguments: of its elements
        known: what the robot knows of itself and of the world
    Raises:
        KeyError: there is no such question
    """
    mine = next((one for one in arguments if is_of_unknown_speaker(one, known.situation)), None)
    if mine is not None and any(known.world.owners(one) for one in fitting(mine, known.situation)):
        return _of_somebody(mine, known)
    named = {argument.name: argument for argument in arguments}
    ever, now = (ANSWERS[frame_name](named, one) for one in (known, known.of_this_run))
    if ever == now:
        return now
    about = _concerned(named, known)
    if frame_name in _DATED and len(found_of(named["theme"], known)) == 1:
        return ever
    return f"{now} As of {when_known(about, known)}: {ever}"


def _concerned(arguments: Arguments, known: RobotKnowledge) -> Sequence[WorldObject]:
    """Return what a question is about, and what is on it, in it, or held by it."""
    about = [one for argument in arguments.values() for one in found_of(argument, known)]
    there = (known.world.at(relation, about) for relation in ("in", "on", "held_by"))
    return [*about, *known.situation.objects(sorted(frozenset().union(*there)))]


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
    found = found_of(theme, known)
    if not found:
        return unknown_of(theme)
    if found[0].id == ROBOT_ID:
        return _own_place(arguments, known)
    placed = [(one, place_of(one, known.world)) for one in found]
    if not any(place for _, place in placed):
        if all(one.source == FILE and one.sort is Sort.PERSON for one in found):
            return f"I have not seen {as_said(theme)} yet."
        return f"I do not know where {as_said(theme)} {verb_of(found, theme.text)}."
    if len(found) == 1:
        called = name_for(theme, found[0])
        if found[0].place_of_before_s:
            return f"I last saw {called} {when_known(found, known)}, {placed[0][1]}."
        where = f"{verb_of(found, called)} {placed[0][1]}{reported(found[0])}"
        if is_only_of_the_kind(theme, found[0]):
            return f"I know of no {bare_noun(theme)} but {called}, which {where}."
        return f"{with_capital(called)} {where}."
    parts = [f"{'one' if not one.name else name_of(one)} is {place or 'somewhere unknown'}" for one, place in placed]
    known_of = f"I know of {len(found)} {plural(theme, found)}: "
    named = join_with_and(with_attributes(one, part) for (one, _), part in zip(placed[:MOST_NAMED], parts))
    return f"{known_of}{named}."


def _number(arguments: Arguments, known: RobotKnowledge) -> str:
    location = arguments.get("location")
    if location is not None and not location.relation and not location.direction:
        # "How many lamps does the hall have": what a place has is in it.
        inside = replace(location, relation="in", words=f"in {location.words}")
        return _number({**arguments, "location": inside}, known)
    theme = arguments["theme"]
    found = at_location(arguments, found_of(theme, known, is_wide=True), known)
    where = f" {location.words[:1].lower()}{location.words[1:]}" if location is not None else ""
    if "state" in arguments:
        state = arguments["state"].text.lower()
        found = tuple(one for one in found if state in one.states)
        where += f" that {'is' if len(found) == 1 else 'are'} {state}"
    if "location" in arguments and not is_known_place(arguments["location"], known):
        return f'I do not know of any place "{arguments["location"].text}".'
    if not found:
        return f"I know of {none_of(theme)}{where}."
    verb = "is" if len(found) == 1 else "are"
    return f"As far as I know, there {verb} {len(found)} {counted_noun(theme, len(found))}{where}."


def _what_is_there(arguments: Arguments, known: RobotKnowledge) -> str:
    location, theme = arguments["location"], arguments.get("theme")
    if not is_known_place(location, known):
        return f'I do not know of any place "{location.text}".'
    everything = tuple(
        one for one in known.world.objects if one.id != ROBOT_ID and one.sort not in (Sort.PLACE, Sort.DOOR)
    )
    objects = found_of(theme, known, is_wide=True) if theme is not None else everything
    found = at_place(objects, location, known.situation)
    if not found:
        what = f"no {bare_noun(theme)}" if theme is not None else "nothing"
        return f"I know of {what} {location.words}."
    return (
        f"{with_capital(location.words)} there {verb_of(found, noun_of(found[0]))} {join_with_and(indefinite(found))}."
    )


def _who_is_there(arguments: Arguments, known: RobotKnowledge) -> str:
    location = arguments["location"]
    if not is_known_place(location, known):
        return f'I do not know of any place "{location.text}".'
    persons = known.world.of_sorts(Sort.PERSON)
    found = at_place(persons, location, known.situation)
    if not found:
        return f"I know of nobody {location.words}."
    return f"{with_capital(join_with_and(indefinite(found)))} {'is' if len(found) == 1 else 'are'} {location.words}."


def _being_there(arguments: Arguments, known: RobotKnowledge) -> str:
    theme = arguments["theme"]
    if "alternative" in arguments:
        return _place(arguments, known)
    if "location" not in arguments and (is_definite(theme) or theme.source is Source.INFERRED):
        # "Do you have it?"
        return what_is_held({"theme": theme}, known)
    candidates = found_of(theme, known, is_wide=True)
    where = f" {arguments['location'].words}" if "location" in arguments else ""
    if "location" in arguments and not is_known_place(arguments["location"], known):
        return f'I do not know of any place "{arguments["location"].text}".'
    found = called_as_said(theme, at_location(arguments, candidates, known))
    if found:
        names = join_with_and(indefinite(found)) if not is_definite(theme) else name_for(theme, found[0])
        verb = verb_of(found, names)
        return f"Yes, {names} {verb}{where}." if where else f"Yes, I know of {names}."
    if not candidates:
        return unknown_of(theme)
    if len(candidates) == 1 and place_of(candidates[0], known.world):
        called = name_for(theme, candidates[0])
        return f"No, {called} {verb_of(candidates, called)} {place_of(candidates[0], known.world)}."
    return (
        f"No, I know of {none_of(theme)}{where}."
        if not is_definite(theme)
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
    found = found_of(theme, known)
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
        f"Yes. {with_capital(name_for(theme, one))} {join_with_and(facts)}."
        if facts
        else f"Yes, I know {as_said(theme)}."
    )


def _which(arguments: Arguments, known: RobotKnowledge) -> str:
    theme, rank = arguments["theme"], arguments.get("rank")
    superlatives = tuple(one for one in theme.modifiers if one.kind == "superlative")
    ordinals = [one for one in theme.modifiers if one.kind == "ordinal"]
    if rank is not None:
        most = rank.text.split()[-1]
        superlatives += (Modifier("superlative", most, most),)
        ordinals += [one for one in rank.modifiers if one.kind == "ordinal"]
    ranking = (*ordinals, *superlatives) if superlatives else ()
    words = {one.word.lower() for one in ranking}
    others = replace(
        theme,
        text=" ".join(word for word in theme.text.split() if word.lower() not in words),
        modifiers=tuple(one for one in theme.modifiers if one not in ranking),
    )
    candidates = at_location(arguments, fitting(others, known.situation, is_wide=True), known)
    if not candidates and "location" in arguments:
        return f"I know of no {bare_noun(others)} {arguments['location'].words}."
    if not candidates:
        return unknown_of(others)
    if not superlatives:
        return f"I know of {join_with_and(indefinite(candidates))}."
    found = most_of(candidates, superlatives, known.situation, ordinals[0].number if ordinals else 1)
    if not found:
        wanted = " ".join(one.word.lower() for one in (*ordinals, superlatives[0]))
        return f"I do not know which {bare_noun(others)} is the {wanted}."
    place = place_of(found[0], known.world)
    return f"It is {full_name(found[0])}{f' {place}' if place else ''}."


def _owner(arguments: Arguments, known: RobotKnowledge) -> str:
    theme = arguments["theme"]
    found = found_of(theme, known)
    if not found:
        return unknown_of(theme)
    owners = [(one, known.world.owners(one)) for one in found]
    if not any(persons for _, persons in owners):
        belongs = f"{definite(theme)} {'belong' if theme.is_plural else 'belongs'}"
        return f"I do not know whom {belongs} to."
    if len(found) == 1:
        return f"{with_capital(name_for(theme, found[0]))} belongs to {join_with_and(map(name_of, owners[0][1]))}."
    parts = [
        f"{full_name(one)} to {join_with_and(map(name_of, persons)) or 'somebody whom I do not know'}"
        for one, persons in owners[:MOST_NAMED]
    ]
    return f"I know of {len(found)} {plural(theme, found)}: {join_with_and(parts)}."


def _colour(arguments: Arguments, known: RobotKnowledge) -> str:
    theme = arguments["theme"]
    found = found_of(theme, known)
    if not found:
        return unknown_of(theme)
    colours = [tuple(word for word in one.attributes if word.lower() in _COLOURS) for one in found]
    if not all(colours):
        return f"I do not know the colour of {as_said(theme)}."
    if len(set(colours)) == 1:
        called = name_for(theme, found[0]) if len(found) == 1 else as_said(theme)
        return f"{with_capital(called)} {verb_of(found, called)} {join_with_and(colours[0])}."
    parts = [
        f"the one {place_of(one, known.world) or 'somewhere unknown'} is {join_with_and(words)}"
        for one, words in zip(found[:MOST_NAMED], colours)
    ]
    return f"I know of {len(found)} {plural(theme, found)}: {join_with_and(parts)}."


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
    **ABOUT_EVENTS,
    **ABOUT_HOLDERS,
    **ABOUT_MEASURES,
    **ABOUT_STATES,
}
