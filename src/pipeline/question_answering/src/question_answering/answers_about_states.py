"""Answers to questions about the states of things: "Is the door open?", "Which lamps are on?"."""

from typing import Callable, Dict, FrozenSet, Mapping, Sequence

from question_answering.robot_knowledge import RobotKnowledge
from question_answering.wording import (
    MOST_NAMED,
    Arguments,
    Objects,
    at_location,
    definite,
    found_of,
    full_name,
    is_known_place,
    name_for,
    verb_of,
    when_known,
)
from referring_expressions import unknown_of
from referring_expressions.describing import bare_noun, is_plural_noun, place_of
from roboframenet_ros.spoken_text import join_with_and, with_capital
from typed_arguments import TypedArgument
from word_classes import word_class
from world_model import Sort, WorldObject
from world_model.knowledge import OPPOSITES

_ALL = word_class("determiners_of_all")
_ANY = word_class("indefinite_articles")
#: What other words for a state mean.
_STATES = {"shut": "closed"}


def state(arguments: Arguments, known: RobotKnowledge) -> str:
    """Say whether something is in a state."""
    theme, meant = arguments["theme"], _meant(arguments)
    everything = found_of(theme, known)
    if not everything:
        verb = "are" if is_plural_noun(theme.lemma) or theme.is_plural else "is"
        return f"I do not know whether {definite(theme)} {verb} {meant}: {unknown_of(theme)}"
    found = at_location(arguments, everything, known)
    if not found:
        return f"I know of no {bare_noun(theme)} {arguments['location'].words}."
    actual = {one.id: _actual(one, meant) for one in found}
    verdicts = {None if not word else word == meant for word in actual.values()}
    is_choice = "alternative" in arguments
    if len(verdicts) > 1:
        return _of_several(theme, found, actual, meant, known)
    verdict = verdicts.pop()
    name = name_for(theme, found[0]) if len(found) == 1 else definite(theme)
    if verdict is None:
        return f"I do not know whether {name} {_verb(theme, found, name)} {meant}."
    if len(found) == 1 and found[0].states_of_before_s and actual[found[0].id] in found[0].states:
        was = "was" if _verb(theme, found, name) == "is" else "were"
        return f"When I last knew, {when_known(found, known)}, {name} {was} {actual[found[0].id]}."
    said = f"{name} {_verb(theme, found, name)} {actual[found[0].id]}."
    return with_capital(said) if is_choice else f"{'Yes' if verdict else 'No'}, {said}"


def _verb(theme: TypedArgument, found: Objects, name: str) -> str:
    return verb_of(found, name) if len(found) == 1 or theme.is_plural else "is"


def _actual(one: WorldObject, meant: str) -> str:
    """Return the state that something is in: the one that is meant, or an opposite of it; empty when unknown."""
    if meant in one.properties:
        return meant
    opposites: FrozenSet[str] = frozenset().union(*(words for words in OPPOSITES if meant in words)) - {meant}
    return next(iter(sorted(opposites & set(one.states))), "")


def _of_several(
    theme: TypedArgument, found: Objects, actual: Mapping[str, str], meant: str, known: RobotKnowledge
) -> str:
    """Return what is known of several things that are in different states: "the red mug is clean, ..."."""
    parts = []
    for word in sorted(set(actual.values()), key=lambda word: (word != meant, not word, word)):
        alike = [one for one in found if actual[one.id] == word]
        names = _named([f"{full_name(one)} {place_of(one, known.world)}".strip() for one in alike])
        verb = verb_of(alike, full_name(alike[0]))
        parts.append(f"{names} {verb} {word}" if word else f"I do not know about {names}")
    is_of_others = bool(set(actual.values()) - {meant, ""})
    begin = "No. " if theme.quantifier in _ALL and is_of_others else ""
    if theme.quantifier in _ANY and meant in actual.values():
        begin = "Yes. "
    told = ". ".join(with_capital(part) for part in parts)
    return f"{begin}{told}."


def those_in_state(arguments: Arguments, known: RobotKnowledge) -> str:
    """Name the things of a kind that are in a state, and where they are."""
    theme, meant, location = arguments.get("theme"), _meant(arguments), arguments.get("location")
    if location is not None and not is_known_place(location, known):
        return f'I do not know of any place "{location.text}".'
    if theme is None:
        everything = known.world.of_sorts(Sort.PERSON)
    else:
        everything = found_of(theme, known, is_wide=True)
        if not everything:
            return unknown_of(theme)
    found = tuple(one for one in at_location(arguments, everything, known) if meant in one.properties)
    where = f" {location.words}" if location is not None else ""
    if not found:
        if theme is None:
            return f"I know of nobody{where} who is {meant}."
        return f"I know of no {bare_noun(theme)}{where} that {'are' if theme.is_plural else 'is'} {meant}."
    names = [f"{full_name(one)} {'' if location is not None else place_of(one, known.world)}".strip() for one in found]
    return f"{with_capital(_named(names))}{where} {verb_of(found, names[0])} {meant}."


def _named(names: Sequence[str]) -> str:
    """Return a list of names for a person; of many, the rest is counted."""
    rest = [f"{len(names) - MOST_NAMED} more"] if len(names) > MOST_NAMED else []
    return join_with_and([*names[:MOST_NAMED], *rest])


def _meant(arguments: Arguments) -> str:
    """Return the state that a question names, in the word that the world model has for it."""
    said = arguments["state"].text.lower()
    return _STATES.get(said, said)


ABOUT_STATES: Dict[str, Callable[[Arguments, RobotKnowledge], str]] = {
    "question_of_state": state,
    "question_of_those_in_state": those_in_state,
}
