"""Frames of checking how things are, and of making sure that they are so.

What is checked comes as a frame of a condition in the argument, with the role "says": "the door is closed" is a
``condition_of_state``, "nobody is in the garage" a ``condition_of_place`` that is negated.
"""

from dataclasses import replace
from typing import Dict, List, Optional, Sequence, Tuple

from home_servers.body import CannotDo
from home_servers.looking import ANYTHING, OPPOSITES, counted, described, say_list, sentence
from home_servers.memory import PERSONS, Known, is_any, is_whole, wanted_names
from home_servers.skills import HEARERS, Skills, argument
from roboframenet_ros.spoken_text import join_with_or
from typed_arguments import EmbeddedFrame, FilledFrame, TypedArgument
from word_classes import without_determiner

_STATE, _PLACE = "condition_of_state", "condition_of_place"
#: So many doors are named when it is open which one is meant, the nearest first.
_MOST_NAMED = 4
#: Actions that bring a state about: kind and value.
_ACTIONS: Dict[str, Tuple[str, str]] = {
    "closed": ("close", ""),
    "shut": ("close", ""),
    "open": ("open", ""),
    "off": ("switch", "off"),
    "on": ("switch", "on"),
    "locked": ("lock", ""),
    "unlocked": ("unlock", ""),
}


def statements(content: TypedArgument) -> Tuple[EmbeddedFrame, ...]:
    """Return what a content says of things: states and places that all hold; nothing when it says anything else."""
    found = tuple(frame for frame in content.frames if frame.role == "says" and frame.frame_name)
    return found if all(_is_checked(frame) for frame in found) else ()


def _is_checked(frame: EmbeddedFrame) -> bool:
    is_of_robot = _theme(frame).text.lower() in HEARERS
    return frame.frame_name in (_STATE, _PLACE) and frame.mood == "statement" and not is_of_robot


def _theme(frame: EmbeddedFrame) -> TypedArgument:
    return _element(frame, "theme")


def _element(frame: EmbeddedFrame, name: str) -> TypedArgument:
    return next((one for one in frame.frame_elements if one.name == name), TypedArgument(name=name))


def inspect(skills: Skills, frame: FilledFrame) -> None:
    """Go to something, look at it, and say how it is, or whether it is as it was said to be."""
    wanted = argument(frame, "desired_state")
    said = statements(wanted)
    for statement in said:
        _inspect_statement(skills, statement)
    if said:
        return
    for one in skills.find_all(argument(frame, "ground")):
        if wanted.text:
            _answer_state(skills, one, wanted.text, is_negated=False)
        else:
            _inspect_one(skills, one)


def _inspect_statement(skills: Skills, statement: EmbeddedFrame) -> None:
    if statement.frame_name == _PLACE:
        is_so, seen = _is_at_place(skills, statement)
        skills.answer(f"{'Yes' if is_so else 'No'}, {seen}")
        return
    for one in _meant(skills, statement):
        _answer_state(skills, one, _element(statement, "state").text, is_negated=statement.is_negated)


def _answer_state(skills: Skills, one: Known, state: str, *, is_negated: bool) -> None:
    has_state = _has_state(_seen(skills, one), state)
    if has_state is None:
        skills.answer(f"I cannot see whether {one.the_name_is} {state}.")
        return
    yes = "Yes" if has_state is not is_negated else "No"
    skills.answer(f"{yes}, {one.the_name_is} {'' if has_state else 'not '}{state}.")


def _seen(skills: Skills, one: Known) -> Known:
    """Go to something and look at it."""
    skills.go(one.id)
    skills.attempt("look", theme=one.id)
    return skills.memory.get(one.id) or one


def _inspect_one(skills: Skills, one: Known) -> None:
    if one.sort != "room":
        skills.answer(sentence(described(skills, _seen(skills, one))))
        return
    skills.go(one.id)
    skills.attempt("look")
    say_list(skills, [thing for thing in skills.memory.all("thing") if thing.room == one.id], f"In {one.the_name}")


def _has_state(one: Known, word: str) -> Optional[bool]:
    word = "closed" if word.lower() == "shut" else word.lower()
    if word in one.states:
        return True
    return False if OPPOSITES.get(word) in one.states else None


def verify(skills: Skills, frame: FilledFrame) -> None:
    """Make sure that things are open, closed, on or off, and change what is not; look whether they are at a place.

    Raises:
        CannotDo: it is not so, and the robot does not change it, or cannot see it
    """
    content = argument(frame, "content")
    found = statements(content)
    if not found:
        raise CannotDo(f'I do not know how to check "{content.text}".')
    for one in found:
        if one.frame_name == _STATE:
            bring_all_about(skills, _meant(skills, one), _wanted(one))
            continue
        is_so, seen = _is_at_place(skills, one)
        if not is_so:
            raise CannotDo(seen)
        skills.answer(seen)


def _wanted(statement: EmbeddedFrame) -> str:
    """Return the state that things shall have.

    Raises:
        CannotDo: they shall not be in some state, which leaves open how they shall be
    """
    state = _element(statement, "state").text.lower()
    if not statement.is_negated:
        return state
    if state not in OPPOSITES or is_whole(_theme(statement)):
        raise CannotDo(f'I do not know how to check "{statement.words}".')
    return OPPOSITES[state]


def _meant(skills: Skills, statement: EmbeddedFrame) -> List[Known]:
    """Return the things that a statement is about.

    Raises:
        CannotDo: one of several doors is meant, and nobody said which
    """
    theme = _theme(statement)
    # "No light is on" is said of all lights.
    is_denied = statement.is_negated and not theme.quantifier and theme.possessor is None
    is_of_all = theme.is_plural or is_whole(theme) or is_denied
    found = skills.find_all(replace(theme, is_plural=is_of_all), "door", "furniture", "thing")
    same = skills.memory.find(theme, "door", here=skills.body.place()) if found[0].sort == "door" else []
    is_named = any(name.lower() in wanted_names(theme) for name in found[0].names)
    if is_of_all or is_any(theme) or theme.referents or is_named or len(same) < 2:
        return found
    names = [one.the_name for one in same[:_MOST_NAMED]] + ["another one"] * (len(same) > _MOST_NAMED)
    raise CannotDo(f"I do not know which door is meant: {join_with_or(names)}.")


def _is_at_place(skills: Skills, statement: EmbeddedFrame) -> Tuple[bool, str]:
    """Look whether things are where they are said to be, and return what the robot sees there."""
    theme, location = _theme(statement), _element(statement, "location")
    place = skills.find(location)
    found = counted(skills, theme, location)
    where = f"{location.relation.replace('_', ' ')} {place.the_name}"
    if found:
        names = ", ".join(sorted({one.the_name for one in found}))
        are_enough = len(found) >= max(1, theme.count or 1)
        return are_enough is not statement.is_negated, f"I see {names} {where}."
    about = without_determiner(theme.text)
    nothing = "nobody" if about in PERSONS else "nothing" if about in ANYTHING else f"no {about}"
    return statement.is_negated, f"I see {nothing} {where}."


def bring_all_about(skills: Skills, things: Sequence[Known], wanted: str) -> None:
    """Bring a state of things about. What shows no such state, a passage without a door, is passed over beside others.

    Raises:
        CannotDo: it cannot be brought about, or one of them has lost the state again
    """
    left = list(things)
    for one in things:
        is_so = _has_state(_seen(skills, one), wanted)
        if is_so is not None:
            left = []
            _bring_about(skills, one, wanted, is_so=is_so)
    for one in left:
        _bring_about(skills, one, wanted, is_so=False)
    # Who closes all doors goes through some of them again.
    for one in [one for one in things if _shows(skills, one, wanted) is False]:
        _bring_about(skills, one, wanted, is_so=False)
    lost = [one for one in things if _shows(skills, one, wanted) is False]
    if lost:
        raise CannotDo(f"{lost[0].the_name_is.capitalize()} not {wanted}.")


def _shows(skills: Skills, one: Known, wanted: str) -> Optional[bool]:
    return _has_state(skills.memory.get(one.id) or one, wanted)


def _bring_about(skills: Skills, one: Known, wanted: str, *, is_so: bool) -> None:
    if is_so:
        skills.answer(sentence(f"{one.the_name_is} {wanted}"))
        return
    if wanted not in _ACTIONS:
        raise CannotDo(f"I cannot see whether {one.the_name_is} {wanted}.")
    kind, value = _ACTIONS[wanted]
    skills.attempt(kind, theme=one.id, value=value)
