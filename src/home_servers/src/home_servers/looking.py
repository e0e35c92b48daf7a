"""Frames of looking, finding, counting and comparing: the robot says what it has seen."""

from dataclasses import replace
from typing import List, Optional, Tuple

from home_servers.body import CannotDo
from home_servers.memory import PERSONS, Known
from home_servers.skills import HEARERS, SPEAKERS, Skills, argument, said
from home_servers.statements import Statement, statement_of
from typed_arguments import FilledFrame, TypedArgument
from word_classes import without_determiner

#: What states are called; others are called by themselves.
_STATES = ("open", "closed", "locked", "on", "off", "dirty", "clean", "wet", "full", "empty")
_OPPOSITES = {
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
#: What the robot sees where nothing is, for words of any person and any thing.
_NONE = {"person": "nobody", "thing": "nothing"}


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
    states = [state for state in one.states if state in _STATES]
    words = " ".join(parts) or "here"
    return f"{one.the_name} is {words}" + (f", {' and '.join(states)}" if states else "")


def sentence(words: str) -> str:
    """Return words as a sentence."""
    return words[0].upper() + words[1:] + "."


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


def inspect(skills: Skills, frame: FilledFrame) -> None:
    """Go to something, look at it, and say how it is."""
    statement = statement_of(f"{frame.text('ground')} {frame.text('desired_state')}")
    if statement is not None and (statement.is_denied or statement.is_negated):
        _inspect_denied(skills, statement)
        return
    for one in skills.find_all(argument(frame, "ground")):
        _inspect_one(skills, one, frame)


def _inspect_denied(skills: Skills, statement: Statement) -> None:
    """Say whether it is so that no thing is somewhere, or is in some state."""
    if statement.place.text:
        is_so, seen = _is_at_place(skills, statement)
        skills.say(f"{'Yes' if is_so else 'No'}, {seen}")
        return
    for one in _meant(skills, statement):
        skills.go(one.id)
        skills.attempt("look", theme=one.id)
        has_state = _has_state(skills.memory.get(one.id) or one, statement.state)
        words = f"{one.the_name} is {'' if has_state else 'not '}{statement.state}"
        skills.say("I cannot see that." if has_state is None else f"{'No' if has_state else 'Yes'}, {words}.")


def _inspect_one(skills: Skills, one: Known, frame: FilledFrame) -> None:
    skills.go(one.id)
    if one.sort == "room" and not said(frame, "desired_state"):
        skills.attempt("look")
        _say_list(skills, [thing for thing in skills.memory.all("thing") if thing.room == one.id], f"In {one.the_name}")
        return
    skills.attempt("look", theme=one.id)
    now = skills.memory.get(one.id) or one
    wanted = argument(frame, "desired_state")
    if wanted.text:
        is_so = _has_state(now, wanted.text)
        skills.answer(
            "I cannot see that." if is_so is None else f"Yes, {wanted.text}." if is_so else f"No, not {wanted.text}."
        )
        return
    skills.answer(sentence(described(skills, now)))


def _has_state(one: Known, word: str) -> Optional[bool]:
    word = word.lower().split()[-1]
    word = "closed" if word == "shut" else word
    if word in one.states:
        return True
    return False if _OPPOSITES.get(word) in one.states else None


def verify(skills: Skills, frame: FilledFrame) -> None:
    """Make sure that things are open, closed, on or off, and change what is not; look whether they are at a place.

    Raises:
        CannotDo: it is not so, and the robot does not change it, or cannot see it
    """
    words = argument(frame, "content")
    statement = statement_of(words.text)
    if statement is None:
        raise CannotDo(f'I do not know how to check "{words.text}".')
    if statement.place.text:
        is_so, seen = _is_at_place(skills, statement)
        if not is_so:
            raise CannotDo(seen)
        skills.say(seen)
        return
    wanted = _wanted(statement)
    for one in _meant(skills, statement):
        _bring_about(skills, one, wanted)


def _wanted(statement: Statement) -> str:
    """Return the state that things shall have.

    Raises:
        CannotDo: they shall not be in some state, which leaves open how they shall be
    """
    if statement.is_denied == statement.is_negated:
        return statement.state
    if statement.state not in _OPPOSITES:
        raise CannotDo(f'I do not know what is not "{statement.state}".')
    return _OPPOSITES[statement.state]


def _meant(skills: Skills, statement: Statement) -> List[Known]:
    about = replace(statement.about, is_plural=statement.is_of_all)
    return skills.find_all(about, "door", "furniture", "thing")


def _is_at_place(skills: Skills, statement: Statement) -> Tuple[bool, str]:
    """Look whether things are where they are said to be, and return what the robot sees there."""
    place = skills.find(statement.place)
    found = counted(skills, statement.about, statement.place)
    where = f"{statement.place.relation} {place.the_name}"
    is_said_to_be_there = statement.is_denied == statement.is_negated
    if found:
        names = ", ".join(sorted({one.the_name for one in found}))
        return is_said_to_be_there, f"I see {names} {where}."
    about = without_determiner(statement.about.text)
    return not is_said_to_be_there, f"I see {_NONE.get(about, f'no {about}')} {where}."


def _bring_about(skills: Skills, one: Known, wanted: str) -> None:
    skills.go(one.id)
    skills.attempt("look", theme=one.id)
    now = skills.memory.get(one.id) or one
    if _has_state(now, wanted):
        skills.answer(f"It is {wanted}.")
        return
    actions = {
        "closed": ("close", ""),
        "shut": ("close", ""),
        "open": ("open", ""),
        "off": ("switch", "off"),
        "on": ("switch", "on"),
        "locked": ("lock", ""),
        "unlocked": ("unlock", ""),
    }
    if wanted not in actions:
        raise CannotDo(f"I cannot see whether {one.the_name} is {wanted}.")
    kind, value = actions[wanted]
    skills.attempt(kind, theme=one.id, value=value)


def count(skills: Skills, frame: FilledFrame) -> None:
    """Go there, look, and say how many there are."""
    words, place = argument(frame, "entity"), argument(frame, "ground")
    state = frame.text("state").lower()
    found = [one for one in counted(skills, words, place) if not state or state in one.states]
    skills.answer(f"I see {len(found)} {words.text if said(frame, 'entity') else 'things'}.".replace(" the ", " "))


def counted(skills: Skills, theme: TypedArgument, place: TypedArgument) -> List[Known]:
    """Return what the robot sees of a kind at a place, or where it is."""
    ground = skills.find(place) if place.text else skills.room_here()
    if ground is None:
        raise CannotDo("I do not know where I am.")
    skills.look_in(ground) if place.text else skills.attempt("look")
    is_of_people = bool(PERSONS.intersection((theme.lemma.lower(), theme.head.lower(), theme.text.lower())))
    found = skills.memory.all("person") if is_of_people else skills.memory.find(theme, "thing", "furniture")
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
    _say_list(skills, named, "I know" if place is None else f"At {place.the_name}")


def _say_list(skills: Skills, found: List[Known], begin: str) -> None:
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
    words = [f"{one.the_name} is {' and '.join(one.attributes) or 'plain'}" for one in found[:2]]
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
    _say_list(skills, [one for one in skills.memory.all("thing", "person") if skills.is_at(one, area)], "I have found")


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
        raise CannotDo("I remember such things of places and things only.")
    found = skills.memory.find(item)
    if not found:
        raise CannotDo(f"I have not seen {item.text}.")
    one, word = found[0], category.lemma.lower() or without_determiner(category.text).lower()
    if category.quantifier in ("a", "an", "the"):
        name = without_determiner(category.text).lower()
        skills.memory.name(one.id, name)
        skills.body.tell(Known(one.id, one.sort, (*one.names, name)))
    elif word in _OPPOSITES or word in _STATES:
        states = tuple(state for state in one.states if state != _OPPOSITES.get(word))
        skills.memory.update([replace(one, states=(*states, word), stamp_s=skills.body.now_s())])
        skills.body.tell(Known(one.id, one.sort, (), states=(word,)))
    else:
        attributes = tuple(dict.fromkeys((*one.attributes, word)))
        skills.memory.update([replace(one, attributes=attributes, stamp_s=skills.body.now_s())])
        skills.body.tell(Known(one.id, one.sort, (), attributes=attributes))
