"""Frames of looking, finding, counting and comparing: the robot says what it has seen."""

from dataclasses import replace
from typing import List

from home_servers.body import CannotDo
from home_servers.memory import PERSONS, Known
from home_servers.skills import HEARERS, SPEAKERS, Skills, argument, said
from roboframenet_ros.spoken_text import with_capital
from typed_arguments import FilledFrame, TypedArgument
from word_classes import without_determiner, word_class

#: Pronouns for any thing.
ANYTHING = word_class("general_thing_nouns")
#: What states are called; others are called by themselves.
STATES = ("open", "closed", "locked", "on", "off", "dirty", "clean", "wet", "full", "empty")
OPPOSITES = {
    "open": "closed",
    "closed": "open",
    "on": "off",
    "off": "on",
    "dirty": "clean",
    "clean": "dirty",
    "locked": "unlocked",
    "unlocked": "locked",
    "shut": "open",
}


def described(skills: Skills, one: Known) -> str:
    """Return where something is and how it is, in words."""
    parts: List[str] = []
    holder = skills.memory.get(one.holder)
    room = skills.memory.get(one.room)
    if one.relation == "held" and holder is not None:
        parts.append(f"{holder.name} has it")
    elif holder is not None and holder.sort != "room":
        parts.append(f"{one.relation.replace('_', ' ')} {holder.the_name}")
    if room is not None and room.id != one.id:
        parts.append(f"in {room.the_name}")
    states = [state for state in one.states if state in STATES]
    words = " ".join(parts) or "here"
    return f"{one.the_name_is} {words}" + (f", {' and '.join(states)}" if states else "")


def sentence(words: str) -> str:
    """Return words as a sentence."""
    return with_capital(words) + "."


def locate(skills: Skills, frame: FilledFrame) -> None:
    """Look for something, go there and say where it is."""
    near = argument(frame, "ground") if said(frame, "ground") else None
    for one in skills.find_all(argument(frame, "sought_entity"), near=near):
        skills.go(one.id)
        skills.attempt("look", theme=one.id)
        skills.answer(sentence(described(skills, skills.memory.get(one.id) or one)))


def perceive(skills: Skills, frame: FilledFrame) -> None:
    """Go to something and look at it, or listen to it."""
    for one in skills.find_all(argument(frame, "phenomenon")):
        skills.go(one.id)
        skills.attempt("look", theme=one.id)


def count(skills: Skills, frame: FilledFrame) -> None:
    """Go there, look, and say how many there are."""
    words, place = argument(frame, "entity"), argument(frame, "ground")
    state = frame.text("state").lower()
    found = [one for one in counted(skills, words, place) if not state or state in one.states]
    what = words.text if said(frame, "entity") else "things"
    if len(found) == 1:
        one = words.text.replace(words.head, words.lemma) if words.is_plural and words.lemma else words.text
        what = one if said(frame, "entity") else "thing"
    skills.answer(f"I see {len(found)} {what}.".replace(" the ", " "))


def counted(skills: Skills, theme: TypedArgument, place: TypedArgument) -> List[Known]:
    """Return what the robot sees of a kind at a place, or where it is."""
    ground = skills.find(place) if place.text else skills.room_here()
    if ground is None:
        raise CannotDo("I do not know where I am.")
    skills.look_in(ground) if place.text else skills.attempt("look")
    is_of_people = bool(PERSONS.intersection((theme.lemma.lower(), theme.head.lower(), theme.text.lower())))
    if is_of_people:
        found = skills.memory.all("person")
    elif theme.text.lower() in ANYTHING:
        found = skills.memory.all("thing")
    else:
        found = skills.memory.find(theme, "thing", "furniture")
    return [one for one in found if skills.is_at(one, ground, place.relation)]


def list_things(skills: Skills, frame: FilledFrame) -> None:
    """Look, and name things one by one."""
    words = argument(frame, "items")
    if said(frame, "place"):
        place = skills.find(argument(frame, "place"))
        skills.look_in(place)
        found = [one for one in skills.memory.all() if skills.is_at(one, place, argument(frame, "place").relation)]
    else:
        place = None
        skills.attempt("look")
        found = skills.memory.find(words)
    meant = {one.id for one in skills.memory.find(words)}
    named = [one for one in found if one.id in meant] or (found if place is not None else [])
    if not named:
        raise CannotDo(f"I have not seen any {words.text}.")
    say_list(skills, named, "I know" if place is None else f"At {place.the_name}")


def say_list(skills: Skills, found: List[Known], begin: str) -> None:
    """Answer with the names of what was found."""
    names = sorted({one.the_name for one in found})
    skills.answer(f"{begin}: {', '.join(names) if names else 'nothing'}.")


def identify(skills: Skills, frame: FilledFrame) -> None:
    """Look at somebody or something, and say who or what it is."""
    words = argument(frame, "entity")
    for one in skills.find_all(words, near=argument(frame, "place") if said(frame, "place") else None):
        skills.go(one.id)
        skills.attempt("look", theme=one.id)
        what = one.name if one.sort == "person" else f"a {one.name}: {', '.join(one.names)}"
        skills.answer(f"This is {what}.")


def compare(skills: Skills, frame: FilledFrame) -> None:
    """Look at two things, and say in what they differ."""
    item, standard = argument(frame, "item"), argument(frame, "standard")
    if standard.text:
        first = skills.find(item, "thing", "furniture")
        others = [one for one in skills.memory.find(standard, "thing", "furniture") if one.id != first.id]
        others = others or [
            one for one in skills.find_all(standard, "thing", "furniture", least=2) if one.id != first.id
        ]
        found = [first, *others]
    elif item.members:
        found = [skills.find(member, "thing", "furniture") for member in item.members]
    else:
        found = skills.find_all(item, "thing", "furniture", least=2)
    for one in found[:2]:
        skills.go(one.id)
        skills.attempt("look", theme=one.id)
    words = [f"{one.the_name_is} {' and '.join(one.attributes) or 'plain'}" for one in found[:2]]
    skills.answer(sentence(" and ".join(words)))


def find_out(skills: Skills, frame: FilledFrame) -> None:
    """Look for what is asked: where something is.

    Raises:
        CannotDo: something else is asked, or it was not found
    """
    words = argument(frame, "content")
    if "where" not in (words.text.lower().partition(" ")[0], frame.text("question_word").lower()):
        raise CannotDo("I can only find out where something is.")
    names = [one for one in skills.memory.all("thing", "furniture", "person") if _is_named(one, words.text)]
    if not names:
        for room in skills.memory.all("room"):
            try:
                skills.look_in(room)
            except CannotDo:
                continue
            names = [one for one in skills.memory.all("thing", "person") if _is_named(one, words.text)]
            if names:
                break
    if not names:
        raise CannotDo(f"I could not find out {words.text}.")
    skills.answer(sentence(described(skills, names[0])))


def _is_named(one: Known, text: str) -> bool:
    words = f" {text.lower()} "
    return any(f" {name.lower()} " in words for name in one.names)


def scour(skills: Skills, frame: FilledFrame) -> None:
    """Search an area, and say what is there."""
    area = skills.find(argument(frame, "ground"), "room", "furniture")
    skills.look_in(area)
    say_list(skills, [one for one in skills.memory.all("thing", "person") if skills.is_at(one, area)], "I have found")


def photograph(skills: Skills, frame: FilledFrame) -> None:
    """Take a picture: of what is ahead, or of what was named."""
    words = argument(frame, "represented")
    if words.text and words.quantifier in ("every", "all", "each") and words.lemma == "room":
        for room in skills.memory.all("room"):
            skills.go(room.id)
            skills.attempt("photograph", theme=room.id)
        return
    target = skills.find(words).id if words.text else ""
    if target:
        skills.go(target)
        skills.attempt("look", theme=target)
    skills.attempt("photograph", theme=target)


def be_located(skills: Skills, frame: FilledFrame) -> None:
    """Remember where something is said to be."""
    near = argument(frame, "place") if said(frame, "place") else None
    theme, place = argument(frame, "theme"), skills.find(argument(frame, "location"), near=near)
    for name in {theme.head.lower(), theme.lemma.lower(), theme.text.lower()} - {""}:
        skills.memory.tell(name, place.id)
    meant = skills.memory.find(theme, "thing")
    if len(meant) == 1 and meant[0].holder != place.id:
        # Where it was seen counts no longer.
        skills.memory.forget_place(meant[0].id)
        relation = argument(frame, "location").relation or "at"
        skills.body.tell(Known(meant[0].id, "thing", (), relation=relation, holder=place.id))


def be_in_category(skills: Skills, frame: FilledFrame) -> None:
    """Remember what something is, or how it is, as somebody says.

    Raises:
        CannotDo: it is not known
    """
    item, category = argument(frame, "item"), argument(frame, "category")
    if item.text.lower() in SPEAKERS or item.text.lower() in HEARERS:
        raise CannotDo("I can remember that only about places and things.")
    found = skills.memory.find(item)
    if not found:
        raise CannotDo(f"I have not seen {item.text}.")
    one, word = found[0], category.lemma.lower() or without_determiner(category.text).lower()
    if category.quantifier in ("a", "an", "the"):
        name = without_determiner(category.text).lower()
        skills.memory.name(one.id, name)
        skills.body.tell(Known(one.id, one.sort, (*one.names, name)))
    elif word in OPPOSITES or word in STATES:
        states = tuple(state for state in one.states if state != OPPOSITES.get(word))
        skills.memory.update([replace(one, states=(*states, word), stamp_s=skills.body.now_s())])
        skills.body.tell(Known(one.id, one.sort, (), states=(word,)))
    else:
        attributes = tuple(dict.fromkeys((*one.attributes, word)))
        skills.memory.update([replace(one, attributes=attributes, stamp_s=skills.body.now_s())])
        skills.body.tell(Known(one.id, one.sort, (), attributes=attributes))
