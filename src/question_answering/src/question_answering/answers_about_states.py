"""Answers to questions about the states of things: "Is the door open?", "Which lamps are on?"."""

from typing import Callable, Dict, FrozenSet

from question_answering.robot_knowledge import RobotKnowledge
from question_answering.wording import (
    MOST_NAMED,
    Arguments,
    at_location,
    found_of,
    full_name,
    is_known_place,
    lower,
    name_for,
    verb_of,
)
from referring_expressions import unknown_of
from referring_expressions.describing import as_said, bare_noun, place_of
from roboframenet_ros.spoken_text import join_with_and, with_capital
from word_classes import word_class
from world_model.knowledge import OPPOSITES

#: What other words for a state mean.
_STATES = {**dict.fromkeys(word_class("words_for_on"), "on"), **dict.fromkeys(word_class("words_for_closed"), "closed")}


def state(arguments: Arguments, known: RobotKnowledge) -> str:
    """Say whether something is in a state."""
    theme, meant = arguments["theme"], _meant(arguments)
    found = found_of(theme, known)
    if not found:
        return unknown_of(theme)
    opposites: FrozenSet[str] = frozenset().union(*(words for words in OPPOSITES if meant in words)) - {meant}
    verdicts = {True if meant in one.properties else False if opposites & set(one.states) else None for one in found}
    name = with_capital(name_for(theme, found[0])) if len(found) == 1 else with_capital(as_said(theme))
    verb = verb_of(found, name)
    is_choice = "alternative" in arguments
    if verdicts == {True}:
        return f"{name} {verb} {meant}." if is_choice else f"Yes, {lower(name)} {verb} {meant}."
    if verdicts == {False}:
        actual = next(iter(sorted(opposites & set(found[0].states))))
        return f"{name} {verb} {actual}." if is_choice else f"No, {lower(name)} {verb} {actual}."
    if None in verdicts:
        return f"I do not know whether {lower(name)} {verb} {meant}."
    return f"Some of them are {meant}, and some are not."


def those_in_state(arguments: Arguments, known: RobotKnowledge) -> str:
    """Name the things of a kind that are in a state, and where they are."""
    theme, meant, location = arguments["theme"], _meant(arguments), arguments.get("location")
    if location is not None and not is_known_place(location, known):
        return f'I do not know of any place "{location.text}".'
    everything = found_of(theme, known, is_wide=True)
    if not everything:
        return unknown_of(theme)
    found = tuple(one for one in at_location(arguments, everything, known) if meant in one.properties)
    where = f" {location.words}" if location is not None else ""
    if not found:
        return f"I know of no {bare_noun(theme)}{where} that {'are' if theme.is_plural else 'is'} {meant}."
    names = [f"{full_name(one)} {'' if location is not None else place_of(one, known.world)}".strip() for one in found]
    if len(names) > MOST_NAMED:
        names = [*names[:MOST_NAMED], f"{len(names) - MOST_NAMED} more"]
    verb = "are" if len(found) > 1 else verb_of(found, names[0])
    return f"{with_capital(join_with_and(names))}{where} {verb} {meant}."


def _meant(arguments: Arguments) -> str:
    """Return the state that a question names, in the word that the world model has for it."""
    said = arguments["state"].text.lower()
    return _STATES.get(said, said)


ABOUT_STATES: Dict[str, Callable[[Arguments, RobotKnowledge], str]] = {
    "question_of_state": state,
    "question_of_those_in_state": those_in_state,
}
