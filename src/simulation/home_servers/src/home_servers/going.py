"""Frames of driving, following, guiding, waiting and charging."""

import math
from typing import Optional

from home_servers.body import CannotDo
from home_servers.memory import Known, is_whole
from home_servers.places import is_beside, is_inside
from home_servers.skills import HEARERS, HERE, SPEAKERS, Skills, argument, said
from typed_arguments import FilledFrame, TypedArgument

#: Whoever is followed or guided is so near.
_NEAR_M = 1.3
#: Nouns for the room where the robot is.
ROOMS = ("room", "place", "here")
#: A look for somebody who comes, seconds.
_LOOK_S = 2.0
#: Who has walked, and has stood for so long, has arrived.
_ARRIVED_S = 60.0
#: Who does not walk for so long goes nowhere.
_STAYED_S = 180.0
#: Who is seen so much farther has walked.
_STEP_M = 0.5
_MOST_LOOKS = 60


def goal_of(skills: Skills, frame: FilledFrame, element: str = "goal") -> Known:
    """Return the place that an element means; the speaker for "here"."""
    words = argument(frame, element)
    if words.text.lower() in HERE or words.text.lower() in SPEAKERS:
        return skills.speaker()
    return skills.find(words)


def avoid(skills: Skills, words: TypedArgument) -> None:
    """Keep out of rooms and doors until the goal ends.

    Raises:
        CannotDo: the robot knows no such rooms and doors, or is in one
    """
    found = skills.memory.find(words, "room", "door", here=skills.body.place())
    places = found if words.is_plural or is_whole(words) else found[:1]
    if not places:
        raise CannotDo(f"I can keep out of rooms and doors that I know, but not of {words.text}.")
    here = next((place for place in places if place.id == skills.body.room()), None)
    if here is not None:
        raise CannotDo(f"I cannot keep out of {here.the_name}: I am there.")
    skills.avoided = " ".join(place.id for place in places)


def navigate(skills: Skills, frame: FilledFrame) -> None:
    """Drive into a room, or to the edge of a thing or a person, not through what is to be avoided."""
    if said(frame, "avoided"):
        avoid(skills, argument(frame, "avoided"))
    goal, relation = goal_of(skills, frame), argument(frame, "goal").relation
    # Of rooms the robot knows only the inside, and it fits into no thing.
    if is_beside(relation) if goal.sort == "room" else is_inside(relation):
        raise CannotDo(f"I cannot go {relation.replace('_', ' ')} {goal.the_name}.")
    if {goal.id, goal.room}.intersection(skills.avoided.split()):
        raise CannotDo(f"I cannot go to {goal.the_name}: that is where I shall not go.")
    skills.go(goal.id)


def depart(skills: Skills, frame: FilledFrame) -> None:
    """Drive out of a room, to the hall or the nearest other room."""
    words = argument(frame, "source")
    here = skills.room_here()
    is_here = here is not None and (words.lemma or words.text).lower() in ROOMS
    source = here if is_here and here is not None else skills.find(words, "room")
    if skills.body.room() != source.id:
        raise CannotDo(f"I am not in {source.the_name}.")
    others = [room for room in skills.memory.all("room") if room.id != source.id]
    hall = [room for room in others if room.name == "hall"]
    if not others:
        raise CannotDo("I know no other room.")
    point = skills.body.place()
    others.sort(key=lambda room: math.hypot(room.x_m - point[0], room.y_m - point[1]))
    skills.go((hall or others)[0].id)


def move_along(skills: Skills, frame: FilledFrame) -> None:
    """Drive through a door or a room, to what comes after it, or along a corridor to its end."""
    path = skills.find(argument(frame, "path"), "room", "door", "furniture", "thing")
    here = skills.body.room()
    if path.sort in ("furniture", "thing"):
        raise CannotDo(f"I know the way through doors and rooms, but not past or along {path.the_name}.")
    if path.sort == "room":
        # Who is there already goes on to the end of it.
        doors = [door for door in skills.memory.all("door") if path.id == here and path.id in door.attributes]
        far = max(doors, key=lambda door: math.dist(skills.body.place(), (door.x_m, door.y_m)), default=path)
        skills.go(far.id)
        return
    skills.go(path.id)
    beyond = next((ident for ident in path.attributes if ident != here), "")
    if not beyond:
        raise CannotDo(f"{path.the_name.capitalize()} leads out of the home.")
    if "closed" in (skills.memory.get(path.id) or path).states:
        skills.attempt("open", theme=path.id)
    skills.go(beyond)


def face(skills: Skills, frame: FilledFrame) -> None:
    """Turn until the robot faces something."""
    skills.attempt("face", goal=skills.find(argument(frame, "goal")).id)


def follow(skills: Skills, frame: FilledFrame) -> None:
    """Find somebody, and stay behind them until the goal is reached, they walk no more, or the goal is preempted."""
    near = argument(frame, "source") if said(frame, "source") else None
    person = skills.find(argument(frame, "cotheme"), "person", near=near)
    goal = goal_of(skills, frame) if said(frame, "goal") else None
    # They may have begun to walk since the robot has met them.
    at, has_walked, since_s = skills.memory.met_at.get(person.id, (person.x_m, person.y_m)), False, skills.body.now_s()
    while True:
        skills.go(person.id, reach_m=_NEAR_M)
        skills.attempt("look", theme=person.id)
        person = skills.memory.get(person.id) or person
        if goal is not None and _is_at(skills, goal):
            return
        now_s = skills.body.now_s()
        if math.hypot(person.x_m - at[0], person.y_m - at[1]) > _STEP_M:
            at, has_walked, since_s = (person.x_m, person.y_m), True, now_s
        if goal is None and has_walked and now_s - since_s >= _ARRIVED_S:
            return
        if goal is None and now_s - since_s >= _STAYED_S:
            raise CannotDo(f"{person.name} does not go anywhere.")
        skills.wait(_LOOK_S / 2.0)


def _is_at(skills: Skills, goal: Known) -> bool:
    if goal.sort == "room":
        return skills.body.room() == goal.id
    here = skills.body.place()
    return math.hypot(goal.x_m - here[0], goal.y_m - here[1]) < 2.0


def guide(skills: Skills, frame: FilledFrame) -> None:
    """Fetch somebody, drive ahead, and wait when they stay behind."""
    words = argument(frame, "cotheme")
    near = argument(frame, "source") if said(frame, "source") else None
    person = skills.find(words, "person", near=near) if words.text else skills.speaker()
    goal = goal_of(skills, frame)
    skills.go(person.id, reach_m=_NEAR_M)
    skills.say(f"{person.name}, please follow me.")
    skills.go(goal.id)
    for _ in range(_MOST_LOOKS):
        skills.attempt("look")
        now = skills.memory.get(person.id) or person
        here = skills.body.place()
        if math.hypot(now.x_m - here[0], now.y_m - here[1]) <= 2.5:
            skills.say(f"{person.name}, we are there.")
            return
        skills.wait(_LOOK_S)
    raise CannotDo(f"I have lost {person.name}.")


def await_(skills: Skills, frame: FilledFrame) -> None:
    """Wait until somebody comes."""
    if said(frame, "place"):
        skills.go(skills.find(argument(frame, "place")).id)
    words = argument(frame, "expected")
    for _ in range(_MOST_LOOKS):
        skills.attempt("look")
        person = _seen_now(skills, words)
        if person is not None:
            skills.say(f"Hello, {person.name}.")
            return
        skills.wait(_LOOK_S)
    raise CannotDo(f"{words.text.capitalize()} did not come.")


def _seen_now(skills: Skills, words: TypedArgument) -> Optional[Known]:
    is_speaker = words.text.lower() in SPEAKERS
    people = [skills.speaker()] if is_speaker else skills.memory.find(words, "person")
    now_s = skills.body.now_s()
    return next((one for one in people if now_s - one.stamp_s < 6.0), None)


def wait(skills: Skills, frame: FilledFrame) -> None:
    """Stay for a while: as long as was said, or ten seconds."""
    duration = argument(frame, "duration")
    skills.wait(duration.si if duration.si is not None else 10.0)


def patrol(skills: Skills, frame: FilledFrame) -> None:
    """Drive to each of the areas three times, and look."""
    areas = skills.find_all(argument(frame, "ground"), "room", "furniture", "door")
    for _ in range(3):
        for area in areas:
            skills.go(area.id)
            skills.attempt("look")


def dock(skills: Skills, frame: FilledFrame) -> None:
    """Drive to the charging station, and connect."""
    named = argument(frame, "station")
    station = skills.find(named if named.text else TypedArgument(text="charging station"), "furniture")
    skills.go(station.id)
    skills.attempt("dock", theme=station.id)


def charge(skills: Skills, frame: FilledFrame) -> None:
    """Charge the robot, or plug in a device."""
    device = argument(frame, "device")
    words = set(device.text.lower().split())
    if not device.text or words & ({"your", "battery", "batteries"} | HEARERS):
        dock(skills, frame)
        return
    one = skills.find(device, "thing", "furniture")
    skills.attempt("attach", theme=one.id)
