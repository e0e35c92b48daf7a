"""Frames of taking, putting, giving, opening, switching and moving things."""

import math
import re
from typing import Dict, List, Optional

from home_servers.body import CannotDo
from home_servers.checking import bring_all_about
from home_servers.memory import Known
from home_servers.places import RELATIONS
from home_servers.skills import HERE, Skill, Skills, argument, said
from roboframenet_ros.spoken_text import with_capital
from typed_arguments import FilledFrame, TypedArgument

#: Words for directions of pushing, pulling and sliding.
_AWAY = ("left", "right", "forward", "back", "backward")
#: Furniture on which things are put when no place is named.
TABLES = ("table", "counter", "desk")
#: What comes of actions on doors.
_STATES = {"open": "open", "close": "closed"}
_RECIPROCALS = ("other", "another")
#: An angle when none is said.
_HALF_TURN_RAD = math.pi / 2.0
#: A level in front of its unit: "21.5 degrees".
_NUMBER = re.compile(r"\d+(\.\d+)?")


def things(skills: Skills, frame: FilledFrame, element: str = "theme", source: str = "source") -> List[Known]:
    """Return the things that an element means, wherever they are."""
    near = argument(frame, source) if said(frame, source) else None
    return skills.find_all(argument(frame, element), "thing", near=near)


def take(skills: Skills, frame: FilledFrame) -> None:
    """Take one or more things."""
    for thing in things(skills, frame):
        skills.take(thing)


def grasp(skills: Skills, frame: FilledFrame) -> None:
    """Grasp a thing."""
    for thing in things(skills, frame, "entity", "source" if said(frame, "source") else "location"):
        skills.take(thing)


def goal_of(skills: Skills, goal: TypedArgument) -> Known:
    """Return the place or person that a goal means."""
    if goal.text.lower() in HERE:
        return skills.speaker()
    return skills.find(goal)


def _goal_to_put_at(frame: FilledFrame) -> TypedArgument:
    """Return the goal of a frame.

    Raises:
        CannotDo: nothing can be put there so; nothing is taken before that is known
    """
    goal = argument(frame, "goal")
    if goal.relation not in RELATIONS:
        raise CannotDo(f"I cannot put anything {goal.relation.replace('_', ' ')} {goal.text}.")
    return goal


def put(skills: Skills, frame: FilledFrame) -> None:
    """Put things somewhere; say so of what is there already. What was not seen yet may be where it shall be."""
    goal = _goal_to_put_at(frame)
    near = argument(frame, "source") if said(frame, "source") else None
    likely = [] if goal.text.lower() in HERE else skills.memory.find(goal, "furniture", here=skills.body.place())[:1]
    for thing in skills.find_all(argument(frame, "theme"), "thing", near=near, at_first=likely):
        place = goal_of(skills, goal)
        if _is_there_already(skills, thing, place, goal.relation):
            now = skills.memory.get(thing.id) or thing
            skills.answer(f"{with_capital(now.the_name_is)} {now.relation} {place.the_name} already.")
            continue
        skills.take(thing)
        skills.put(thing.id, place, goal.relation)


def _is_there_already(skills: Skills, thing: Known, place: Known, relation: str) -> bool:
    """Whether a thing is where it shall be put; the robot goes and looks before it says so."""

    def is_there() -> bool:
        now = skills.memory.get(thing.id)
        return now is not None and now.holder == place.id and now.relation in RELATIONS[relation]

    if not is_there():
        return False
    skills.look_in(place)
    return is_there()


def bring(skills: Skills, frame: FilledFrame) -> None:
    """Bring things to a place or a person; to whoever speaks when nobody else is named."""
    goal, whom = _goal_to_put_at(frame), argument(frame, "beneficiary")
    for thing in things(skills, frame):
        skills.take(thing)
        if goal.text:
            skills.put(thing.id, goal_of(skills, goal), goal.relation)
        else:
            skills.put(thing.id, skills.find(whom, "person") if whom.text else skills.speaker(), "to")


def let_go(skills: Skills, frame: FilledFrame) -> None:
    """Let go of what is held, where the robot is or at a goal."""
    held = list(skills.body.held())
    theme, goal = argument(frame, "theme"), argument(frame, "goal")
    if theme.text:
        meant = [one.id for one in skills.memory.find(theme, "thing")]
        held = [thing for thing in meant if thing in held]
    if not held:
        raise CannotDo(f"I do not hold {theme.text or 'anything'}.")
    for thing in held[:1]:
        if goal.text:
            skills.put(thing, goal_of(skills, goal), goal.relation)
        else:
            skills.put_down(thing)


def give(skills: Skills, frame: FilledFrame) -> None:
    """Hand things to somebody."""
    for thing in things(skills, frame):
        skills.take(thing)
        skills.put(thing.id, skills.find(argument(frame, "recipient"), "person"), "to")


def give_drink(skills: Skills, frame: FilledFrame) -> None:
    """Pour a drink into a glass, and bring it."""
    drink = skills.find(argument(frame, "drink"), "thing")
    with skills.borrowed(drink):
        cup = skills.find(TypedArgument(text="glass"), "thing")
        skills.attempt("pour", theme=drink.id, goal=cup.id)
    skills.take(cup)
    skills.put(cup.id, skills.find(argument(frame, "recipient"), "person"), "to")


def serve(skills: Skills, frame: FilledFrame) -> None:
    """Bring food or drinks to people; to whoever speaks when nobody is named."""
    whom = argument(frame, "recipient")
    for thing in things(skills, frame):
        skills.take(thing)
        skills.put(thing.id, skills.find(whom, "person") if whom.text else skills.speaker(), "to")


def offer(skills: Skills, frame: FilledFrame) -> None:
    """Hold something out to somebody, who takes it."""
    for thing in things(skills, frame):
        skills.take(thing)
        person = skills.person(argument(frame, "recipient"))
        skills.say(f"{person.name}, would you like {thing.the_name}?")
        skills.put(thing.id, person, "to")


def discard(skills: Skills, frame: FilledFrame) -> None:
    """Put things into the bin, or into what was named."""
    goal = argument(frame, "goal") if said(frame, "goal") else TypedArgument(text="bin")
    for thing in things(skills, frame):
        skills.take(thing)
        skills.put(thing.id, skills.find(goal, "furniture", "thing"), "into")


def throw(skills: Skills, frame: FilledFrame) -> None:
    """Throw a thing, to somebody or away from the robot."""
    whom = argument(frame, "recipient") if said(frame, "recipient") else argument(frame, "goal")
    for thing in things(skills, frame):
        skills.take(thing)
        target = skills.find(whom).id if whom.text else ""
        if target:
            skills.go(target, reach_m=2.5)
        skills.attempt("throw", theme=thing.id, goal=target)


def stack(skills: Skills, frame: FilledFrame) -> None:
    """Put things on top of each other, at the goal or where the first one is."""
    near = argument(frame, "source") if said(frame, "source") else None
    # "On top of each other" is no place.
    has_place = said(frame, "goal") and not argument(frame, "goal").text.lower().endswith(_RECIPROCALS)
    found = skills.find_all(argument(frame, "theme"), "thing", near=near, least=1 if has_place else 2)
    if has_place:
        skills.take(found[0])
        skills.put(found[0].id, goal_of(skills, argument(frame, "goal")), "on")
    for below, thing in zip(found, found[1:]):
        skills.take(thing)
        skills.put(thing.id, below, "on")


def portal(element: str, kind: str) -> Skill:
    """Return the skill that opens, closes, locks or unlocks what an element names."""

    def act(skills: Skills, frame: FilledFrame) -> None:
        whole = argument(frame, "containing_object")
        words = argument(frame, element)
        if whole.text:
            # "The door of the cupboard" is opened with the cupboard; a room has a door of its own.
            named = TypedArgument(element, f"{words.lemma or words.text} of {whole.text}")
            words = named if skills.memory.find(named, "door", "furniture", "thing") else whole
        with skills.borrowed(skills.find(argument(frame, "key"), "thing") if said(frame, "key") else None):
            found = skills.find_all(words, "door", "furniture", "thing")
            if len(found) > 1 and kind in _STATES:
                bring_all_about(skills, found, _STATES[kind])
                return
            for one in found:
                skills.attempt(kind, theme=one.id)

    return act


def switch(skills: Skills, frame: FilledFrame) -> None:
    """Switch a device on or off, or to a level or a setting."""
    device, wanted = argument(frame, "device"), argument(frame, "operational_state")
    for one in skills.find_all(device, "furniture", "thing"):
        _switch_one(skills, one, wanted)


def _switch_one(skills: Skills, one: Known, wanted: TypedArgument) -> None:
    words = wanted.text.lower()
    number = _NUMBER.match(words)
    if words in ("on", "off"):
        skills.attempt("switch", theme=one.id, value=words)
    elif words in ("up", "down", "higher", "lower"):
        _change_level(skills, one, 20.0 if words in ("up", "higher") else -20.0)
    elif wanted.si is not None or wanted.count is not None or number:
        amount = wanted.count if wanted.count is not None else wanted.si
        skills.attempt("switch", theme=one.id, amount=float(number.group() if number else amount or 0.0))
    elif words:
        skills.attempt("switch", theme=one.id, value=words)
    else:
        raise CannotDo(f"Should I switch {one.the_name} on or off?")


def _change_level(skills: Skills, one: Known, change: float) -> None:
    skills.go(one.id)
    skills.attempt("look", theme=one.id)
    one = skills.memory.get(one.id) or one
    level = next((float(state.split("=")[1]) for state in one.states if state.startswith("level=")), 50.0)
    skills.attempt("switch", theme=one.id, amount=max(0.0, min(100.0, level + change)))


def level(change: float, names: "Dict[str, str]", element: str = "item") -> Skill:
    """Return the skill that changes the level of a device.

    Args:
        change: per cent when no amount is said
        names: devices of settings: the volume is that of the radio
        element: that names the device or the setting
    """

    sign = math.copysign(1.0, change)

    def act(skills: Skills, frame: FilledFrame) -> None:
        item = argument(frame, element)
        wanted = names.get((item.lemma or item.text).lower())
        by, to = _per_cent(argument(frame, "difference")), _per_cent(argument(frame, "value"))
        for one in skills.find_all(TypedArgument(text=wanted) if wanted else item, "furniture", "thing"):
            if to is not None:
                skills.attempt("switch", theme=one.id, amount=to)
            else:
                _change_level(skills, one, change if by is None else by * sign)

    return act


def _per_cent(argument: TypedArgument) -> Optional[float]:
    """Return the level that was said ("30 percent", "the maximum"); None if none was.

    Raises:
        CannotDo: it is no number
    """
    if not argument.text:
        return None
    if "minimum" in argument.text or "maximum" in argument.text:
        return 0.0 if "minimum" in argument.text else 100.0
    number = argument.text.split()[0]
    amount = argument.count if argument.count is not None else argument.si
    if amount is None and not number.isdigit():
        raise CannotDo(f'I do not know how much "{argument.text}" is.')
    return float(number if amount is None else amount)


def press(skills: Skills, frame: FilledFrame) -> None:
    """Press a button."""
    near = argument(frame, "place") if said(frame, "place") else None
    for one in skills.find_all(argument(frame, "entity"), "furniture", "thing", near=near):
        skills.attempt("press", theme=one.id)


def restart(skills: Skills, frame: FilledFrame) -> None:
    """Switch a device off and on."""
    if not said(frame, "device"):
        raise CannotDo("I cannot restart myself.")
    for one in skills.find_all(argument(frame, "device"), "furniture", "thing"):
        skills.attempt("switch", theme=one.id, value="off")
        skills.wait(2.0)
        skills.attempt("switch", theme=one.id, value="on")


def cancel(skills: Skills, frame: FilledFrame) -> None:
    """Switch an alarm off."""
    for one in skills.find_all(argument(frame, "activity"), "furniture", "thing"):
        skills.attempt("switch", theme=one.id, value="off")


def rotate(skills: Skills, frame: FilledFrame) -> None:
    """Turn a thing around its axis; a quarter turn when no angle is said."""
    angle = argument(frame, "angle")
    amount = angle.si if angle.si is not None else _HALF_TURN_RAD
    if angle.si is None and angle.text:
        amount = math.radians(float(angle.text))
    direction = argument(frame, "direction")
    sign = -1.0 if (direction.direction or direction.text) in ("right", "clockwise") else 1.0
    for one in skills.find_all(argument(frame, "theme")):
        skills.attempt("rotate", theme=one.id, amount=sign * amount)


def push(way: str) -> Skill:
    """Return the skill that pushes ("forward"), pulls ("nearer") or slides a thing."""

    def act(skills: Skills, frame: FilledFrame) -> None:
        goal, direction = argument(frame, "goal"), argument(frame, "direction")
        word = direction.direction or goal.direction or direction.text or goal.text
        for thing in things(skills, frame):
            if goal.text and word not in _AWAY:
                place = goal_of(skills, goal)
                skills.go(thing.id)
                relation = goal.relation if goal.relation in ("under", "behind", "in_front_of") else "beside"
                _move_to(skills, thing, place, relation)
            elif word and word not in _AWAY:
                raise CannotDo(f"I cannot move {thing.the_name} {word}.")
            else:
                skills.attempt("push", theme=thing.id, value=word or way)

    return act


def _move_to(skills: Skills, thing: Known, place: Known, relation: str) -> None:
    """Take along what a hand holds; push what is too heavy."""
    try:
        skills.take(thing)
    except CannotDo:
        skills.attempt("tow", theme=thing.id, goal=place.id, relation=relation)
        return
    if place.sort in ("person", "room"):
        skills.go(place.id)
        skills.put_down(thing.id)
    else:
        skills.put(thing.id, place, relation)


def detach(skills: Skills, frame: FilledFrame) -> None:
    """Unplug or detach something."""
    for one in skills.find_all(argument(frame, "item")):
        skills.attempt("detach", theme=one.id)


def attach(skills: Skills, frame: FilledFrame) -> None:
    """Plug something in, or attach it to something."""
    goal = argument(frame, "goal")
    for item in skills.find_all(argument(frame, "item")):
        if not goal.text:
            skills.attempt("attach", theme=item.id)
            continue
        place = skills.find(goal)
        skills.take(item)
        skills.go(place.id)
        skills.attempt("attach", theme=item.id, goal=place.id)


def raise_thing(way: str) -> Skill:
    """Return the skill that raises or lowers something."""

    def act(skills: Skills, frame: FilledFrame) -> None:
        for one in skills.find_all(argument(frame, "theme")):
            skills.attempt("raise", theme=one.id, value=way)

    return act


def arm(way: str) -> Skill:
    """Return the skill that extends or tucks the arm."""

    def act(skills: Skills, frame: FilledFrame) -> None:
        limb = argument(frame, "limb")
        if limb.modifiers or limb.is_plural or (limb.count or 1) > 1:
            raise CannotDo(f'I move one arm, and cannot choose "{limb.words or limb.text}".')
        skills.attempt("arm", value=way)

    return act


def fetch(skills: Skills, frame: FilledFrame) -> None:
    """Bring a thing from a place."""
    bring(skills, frame)


def empty(skills: Skills, frame: FilledFrame) -> None:
    """Take everything out of something, one by one, to the nearest table or to the goal."""
    place = skills.find(argument(frame, "object"), "furniture", "thing", "room")
    skills.look_in(place) if place.sort == "furniture" else skills.go(place.id)
    inside = [one for one in skills.memory.all("thing") if one.holder == place.id and one.relation in ("in", "on")]
    if not inside:
        skills.answer(f"{place.the_name.capitalize()} is empty.".replace("The the", "The"))
        return
    goal = argument(frame, "goal")
    target = goal_of(skills, goal) if goal.text else _table(skills, place)
    for thing in inside:
        skills.take(thing)
        skills.put(thing.id, target, goal.relation or "to")


def _table(skills: Skills, place: Known) -> Known:
    tables = [one for one in skills.memory.all("furniture") if one.category in TABLES and one.id != place.id]
    if not tables:
        raise CannotDo("I know no table.")
    return min(
        tables,
        key=lambda one: (one.room != place.room, math.hypot(one.x_m - place.x_m, one.y_m - place.y_m)),
    )


def load(skills: Skills, frame: FilledFrame) -> None:
    """Put things into a machine; dirty ones when none are named."""
    machine = skills.find(argument(frame, "goal"), "furniture", "thing")
    if said(frame, "theme"):
        found = things(skills, frame)
    else:
        category = "clothes" if "wash" in machine.name and "dish" not in machine.name else "dish"
        found = [one for one in skills.memory.all("thing") if one.is_a(category) and "dirty" in one.states]
        if not found:
            for room in skills.memory.all("furniture"):
                if room.name in ("laundry basket", "kitchen table"):
                    skills.look_in(room)
            found = [one for one in skills.memory.all("thing") if one.is_a(category) and "dirty" in one.states]
    if not found:
        raise CannotDo(f"I have seen nothing to put into {machine.the_name}.")
    for thing in found:
        skills.take(thing)
        skills.put(thing.id, machine, "into")
