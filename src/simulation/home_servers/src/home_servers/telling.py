"""What the robot tells: facts of its own, what it goes and looks at, or the words themselves."""

import datetime
import os
from dataclasses import dataclass
from functools import lru_cache
from typing import Tuple

import yaml

from home_servers.body import CannotDo
from home_servers.looking import counted, described
from home_servers.memory import PERSONS
from home_servers.skills import POSTURES, Skills
from referring_expressions.describing import counted_noun
from roboframenet_ros.spoken_text import join_with_and
from typed_arguments import EmbeddedFrame, TypedArgument
from word_classes import without_determiner

_FACTS = os.path.join(os.path.dirname(os.path.realpath(__file__)), "facts.yaml")


@dataclass(frozen=True)
class Fact:
    """A fact that the robot tells when its words are in what is asked for.

    Attributes:
        words: all of them, lower case
        text: with {now} and {tomorrow}, local times
    """

    words: Tuple[str, ...]
    text: str


@lru_cache(maxsize=1)
def shipped_facts() -> Tuple[Fact, ...]:
    """Read the facts of the package."""
    with open(_FACTS, encoding="utf-8") as file:
        return tuple(Fact(tuple(one["words"]), one["text"]) for one in yaml.safe_load(file))


def told(skills: Skills, message: TypedArgument) -> str:
    """Return what is told, without a full stop: what the robot knows or sees of it, or the words themselves.

    Raises:
        CannotDo: it is not known, and was not found
    """
    said = [frame for frame in message.frames if frame.role == "says"]
    for frame in said:
        if frame.frame_name == "question_of_number":
            return _number(skills, frame)
        if frame.frame_name == "question_of_being_there" and _element(frame, "location").text:
            return _whether_there(skills, frame)
        if frame.frame_name == "question_of_who_is_there":
            return _who(skills, frame)
        if frame.frame_name == "question_of_place":
            return described(skills, skills.find(_element(frame, "theme")))
        if frame.frame_name in ("question_of_state", "question_of_colour"):
            return _look(skills, _element(frame, "theme"))
    about = _property_of_a_person(skills, message)
    if about:
        return about
    words = message.text.lower().replace("?", "").split()
    now = skills.body.clock()
    for fact in shipped_facts():
        if set(fact.words) <= set(words):
            return fact.text.format(now=now, tomorrow=now + datetime.timedelta(days=1))
    known = [one for one in skills.memory.find(message, "thing", "furniture") if one.room]
    if known:
        return described(skills, known[0])
    if any(frame.mood == "question" for frame in said):
        raise CannotDo(f"I do not know {message.text.rstrip(' ?.!')}.")
    return message.text[5:] if message.text.lower().startswith("that ") else message.text


def _element(frame: EmbeddedFrame, name: str) -> TypedArgument:
    return next((one for one in frame.frame_elements if one.name == name), TypedArgument(name=name))


def _number(skills: Skills, frame: EmbeddedFrame) -> str:
    """Go there, look, and count."""
    theme, place = _element(frame, "theme"), _element(frame, "location")
    state = _element(frame, "state").text.lower()
    found = counted(skills, theme, place)
    if state:
        found = [one for one in found if state in one.states]
    where = f" {place.words}" if place.text else ""
    return f"there {'is' if len(found) == 1 else 'are'} {len(found)} {counted_noun(theme, len(found))}{where}"


def _whether_there(skills: Skills, frame: EmbeddedFrame) -> str:
    """Go there, look, and say whether something is there."""
    theme, place = _element(frame, "theme"), _element(frame, "location")
    found = counted(skills, theme, place)
    if found:
        names = join_with_and(sorted({one.the_name for one in found}))
        return f"{names} {'are' if found[1:] or found[0].is_plural else 'is'} {place.words}"
    return f"there is no {without_determiner(theme.text)} {place.words}"


def _who(skills: Skills, frame: EmbeddedFrame) -> str:
    """Go there, look, and say who is there."""
    place = _element(frame, "location")
    names = sorted(one.name for one in counted(skills, TypedArgument("theme", "people"), place))
    return f"{join_with_and(names) or 'nobody'} {'are' if names[1:] else 'is'} {place.words or 'here'}"


def _look(skills: Skills, theme: TypedArgument) -> str:
    """Go there, look, and say how it is."""
    one = skills.find(theme)
    skills.go(one.id)
    skills.attempt("look", theme=one.id)
    now = skills.memory.get(one.id) or one
    looks = f"; {now.it_is} {' and '.join(now.attributes)}" if now.attributes and now.sort != "door" else ""
    return f"{described(skills, now)}{looks}"


def _property_of_a_person(skills: Skills, message: TypedArgument) -> str:
    """Return the name or the posture of whom a message is about: "the name of the person at the desk"."""
    person = message.complement
    if person is None or not PERSONS.intersection((person.lemma.lower(), person.head.lower())):
        return ""
    place = next(
        (one for frame in message.frames + person.frames for one in frame.frame_elements if one.name == "location"),
        None,
    )
    one = skills.find(person, "person", near=place)
    skills.go(one.id)
    skills.attempt("look", theme=one.id)
    now = skills.memory.get(one.id) or one
    posture = next((state for state in now.states if state in POSTURES), "")
    if message.lemma == "name":
        return f"it is {now.name}"
    return f"{now.name} is {posture}" if posture else described(skills, now)
