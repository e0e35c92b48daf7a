"""Answers to questions about the world: where, how many, which, whether; each says what is not known."""

import datetime
from typing import Callable, Dict, FrozenSet, List, Mapping, Optional, Sequence, Tuple

from question_answering.robot_knowledge import RobotKnowledge
from referring_expressions import Situation, fitting
from referring_expressions.describing import name_of, noun_of, place_of
from referring_expressions.fitting import at_place
from semantic_types import spoken
from typed_arguments import TypedArgument
from word_classes import without_determiner, word_class
from world_model import Sort, WorldObject
from world_model.knowledge import OPPOSITES
from world_model.world_object import ROBOT_ID

#: Objects that an answer names; more are counted.
MOST_NAMED = 8
Arguments = Mapping[str, TypedArgument]
_PERSONS = word_class("general_person_nouns")


def answer(frame_name: str, arguments: Sequence[TypedArgument], known: RobotKnowledge) -> str:
    """Return the answer to a question, as sentences for a person.

    Args:
        frame_name: of a question
        arguments: of its elements
        known: what the robot knows of itself and of the world
    Raises:
        KeyError: there is no such question
    """
    return ANSWERS[frame_name]({argument.name: argument for argument in arguments}, known)


def _abilities(_: Arguments, known: RobotKnowledge) -> str:
    examples = known.abilities
    if not examples:
        return "I cannot do anything at the moment: nothing that acts is running."
    shown = [f'"{example}"' for example in examples[:MOST_NAMED]]
    more = f" I can do {known.ability_count} things in all." if known.ability_count > len(shown) else ""
    return f"You can say, for example: {_listed(shown)}.{more}"


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


def _place(arguments: Arguments, known: RobotKnowledge) -> str:
    theme = arguments["theme"]
    found = _found(theme, known)
    if not found:
        return _unseen(theme)
    if found[0].id == ROBOT_ID:
        return _own_place(arguments, known)
    placed = [(one, place_of(one, known.world)) for one in found]
    if not any(place for _, place in placed):
        return (
            f"I do not know where {_said(theme)} is." if len(found) == 1 else f"I do not know where {_said(theme)} are."
        )
    if len(found) == 1:
        return f"{_capital(_called(theme, found[0]))} is {placed[0][1]}{_reported(found[0])}."
    parts = [f"{'one' if not one.name else name_of(one)} is {place or 'somewhere unknown'}" for one, place in placed]
    known_of = f"I know of {len(found)} {_plural(theme, found)}: "
    return f"{known_of}{_listed([_with_attributes(one, part) for (one, _), part in zip(placed[:MOST_NAMED], parts)])}."


def _number(arguments: Arguments, known: RobotKnowledge) -> str:
    theme = arguments["theme"]
    found = _at(arguments, _found(theme, known, is_wide=True), known)
    where = f" {arguments['location'].words}" if "location" in arguments else ""
    if "state" in arguments:
        state = arguments["state"].text.lower()
        found = tuple(one for one in found if state in one.states)
        where += f" that are {state}"
    if "location" in arguments and not _place_is_known(arguments["location"], known):
        return f'I do not know of any place "{arguments["location"].text}".'
    if not found:
        return f"I know of no {_noun(theme)}{where}."
    verb = "is" if len(found) == 1 else "are"
    noun = _noun(theme) if len(found) > 1 else theme.lemma if theme.is_plural else _noun(theme)
    noun = "person" if len(found) == 1 and theme.lemma in _PERSONS else noun
    return f"As far as I know, there {verb} {len(found)} {noun}{where}."


def _what_is_there(arguments: Arguments, known: RobotKnowledge) -> str:
    location, theme = arguments["location"], arguments.get("theme")
    if not _place_is_known(location, known):
        return f'I do not know of any place "{location.text}".'
    everything = tuple(
        one for one in known.world.objects if one.id != ROBOT_ID and one.sort not in (Sort.PLACE, Sort.DOOR)
    )
    objects = _found(theme, known, is_wide=True) if theme is not None else everything
    found = at_place(objects, location, Situation(known.world))
    if not found:
        what = f"no {_noun(theme)}" if theme is not None else "nothing"
        return f"I know of {what} {location.words}."
    return f"{_capital(location.words)} there {'is' if len(found) == 1 else 'are'} {_listed(_indefinite(found))}."


def _who_is_there(arguments: Arguments, known: RobotKnowledge) -> str:
    location = arguments["location"]
    if not _place_is_known(location, known):
        return f'I do not know of any place "{location.text}".'
    persons = tuple(one for one in known.world.objects if one.sort is Sort.PERSON)
    found = at_place(persons, location, Situation(known.world))
    if not found:
        return f"I know of nobody {location.words}."
    return f"{_capital(_listed(_indefinite(found)))} {'is' if len(found) == 1 else 'are'} {location.words}."


def _state(arguments: Arguments, known: RobotKnowledge) -> str:
    theme, state = arguments["theme"], arguments["state"].text.lower()
    found = _found(theme, known)
    if not found:
        return _unseen(theme)
    opposites: FrozenSet[str] = frozenset().union(*(words for words in OPPOSITES if state in words)) - {state}
    verdicts = {True if state in one.properties else False if opposites & set(one.states) else None for one in found}
    name = _capital(_called(theme, found[0])) if len(found) == 1 else _capital(_said(theme))
    verb = "is" if len(found) == 1 else "are"
    if verdicts == {True}:
        return f"Yes, {_lower(name)} {verb} {state}."
    if verdicts == {False}:
        actual = next(iter(sorted(opposites & set(found[0].states))))
        return f"No, {_lower(name)} {verb} {actual}."
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
        names = _listed(_indefinite(found)) if not _is_definite(theme) else _called(theme, found[0])
        verb = "is" if len(found) == 1 else "are"
        return f"Yes, {names} {verb}{where}." if where else f"Yes, I know of {names}."
    if not candidates:
        return _unseen(theme)
    if len(candidates) == 1 and place_of(candidates[0], known.world):
        return f"No, {_called(theme, candidates[0])} is {place_of(candidates[0], known.world)}."
    return (
        f"I know of no {_noun(theme)}{where}."
        if not _is_definite(theme)
        else f"I do not know that {_said(theme)} is{where}."
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
        return f"No, I do not know {_said(theme)}."
    one = found[0]
    if len(found) > 1:
        return f"Yes, I know {len(found)} of them."
    facts: List[str] = []
    if one.sort is Sort.PERSON:
        facts.append("is a person")
    elif noun_of(one) and one.name:
        facts.append(f"is {_article(noun_of(one))}")
    place = place_of(one, known.world)
    if place:
        facts.append(f"is {place}")
    if one.states:
        facts.append(f"is {_listed(one.states)}")
    if one.attributes:
        facts.append(f"is {_listed(one.attributes)}")
    return f"Yes. {_capital(_called(theme, one))} {_listed(facts)}." if facts else f"Yes, I know {_said(theme)}."


#: The answer to each question, by the name of its frame.
ANSWERS: Dict[str, Callable[[Arguments, RobotKnowledge], str]] = {
    "question_of_abilities": _abilities,
    "question_of_identity": _identity,
    "question_of_own_place": _own_place,
    "question_of_activity": _activity,
    "question_of_last_words": _last_words,
    "question_of_place": _place,
    "question_of_number": _number,
    "question_of_what_is_there": _what_is_there,
    "question_of_who_is_there": _who_is_there,
    "question_of_state": _state,
    "question_of_being_there": _being_there,
    "question_of_time": _time,
    "question_of_date": _date,
    "question_of_acquaintance": _acquaintance,
}


def _found(theme: Optional[TypedArgument], known: RobotKnowledge, *, is_wide: bool = False) -> Tuple[WorldObject, ...]:
    """Return what a phrase refers to: what the framer found, if it searched this world."""
    if theme is None:
        return ()
    situation = Situation(known.world)
    if theme.referents and theme.world_version == known.world.version and not is_wide:
        return situation.objects(theme.referents)
    return fitting(theme, situation, is_wide=is_wide)


def _at(arguments: Arguments, objects: Tuple[WorldObject, ...], known: RobotKnowledge) -> Tuple[WorldObject, ...]:
    location = arguments.get("location")
    return objects if location is None else at_place(objects, location, Situation(known.world))


def _place_is_known(location: TypedArgument, known: RobotKnowledge) -> bool:
    return bool(location.direction or fitting(location, Situation(known.world)))


def _unseen(theme: TypedArgument) -> str:
    if theme.semantic_type == "Human" and not theme.quantifier:
        return f"I do not know {_said(theme)}."
    return f"I have not seen {_article(_noun(theme)) if not theme.is_plural else 'any ' + _noun(theme)}."


def _is_definite(theme: TypedArgument) -> bool:
    return theme.quantifier == "the" or theme.possessor is not None or theme.semantic_type == "Human"


def _noun(theme: TypedArgument) -> str:
    """Return the noun of a phrase with its adjectives and without its determiner: "red mug"."""
    words = without_determiner(theme.text, word_class("determiners_and_possessives")) or theme.text
    return without_determiner(words, frozenset(["any", "some", "no", "other"]))


def _said(theme: TypedArgument) -> str:
    """Return a phrase as it was said, from the view of the robot: "your mug" for "my mug"."""
    first, _, rest = theme.text.partition(" ")
    return f"{_YOURS.get(first.lower(), first)} {rest}".strip()


_YOURS = {"my": "your", "your": "my", "our": "our", "The": "the"}


def _called(theme: TypedArgument, one: WorldObject) -> str:
    return name_of(one) if one.name else _definite(theme)


def _definite(theme: TypedArgument) -> str:
    if theme.quantifier in ("a", "any", "some", ""):
        return f"the {_noun(theme)}" if theme.possessor is None else _said(theme)
    return _said(theme)


def _plural(theme: TypedArgument, found: Sequence[WorldObject]) -> str:
    noun = noun_of(found[0])
    return _noun(theme) if theme.is_plural else f"{noun}{'es' if noun.endswith(('s', 'x', 'ch', 'sh')) else 's'}"


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
            end = "es" if word.endswith(("s", "x", "ch", "sh")) else "s"
            found.append(_article(word) if count == 1 else f"{count} {word}{end}")
    return found if len(found) <= MOST_NAMED else [*found[:MOST_NAMED], f"{len(found) - MOST_NAMED} more"]


def _reported(one: WorldObject) -> str:
    return f", as {one.source} said" if one.source and one.sort is Sort.PERSON and one.source.istitle() else ""


def _article(noun: str) -> str:
    is_vowel = noun[:1].lower() in "aeiou" and not noun.lower().startswith(("uni", "use", "eu", "one"))
    return f"{'an' if is_vowel else 'a'} {noun}"


def _listed(parts: Sequence[str]) -> str:
    return " and ".join(filter(None, (", ".join(parts[:-1]), *parts[-1:])))


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _lower(text: str) -> str:
    return text[:1].lower() + text[1:] if text.startswith(("The ", "Your ", "A ", "An ")) else text
