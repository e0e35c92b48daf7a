"""Answers to questions about what persons and the robot hold and have: "What is Anna holding?"."""

from typing import Callable, Dict, FrozenSet

from question_answering.robot_knowledge import RobotKnowledge
from question_answering.wording import (
    MOST_NAMED,
    Arguments,
    Objects,
    found_of,
    full_name,
    indefinite,
    name_for,
    verb_of,
)
from referring_expressions import unknown_of
from referring_expressions.describing import name_of, place_of
from roboframenet_ros.spoken_text import join_with_and, with_capital
from typed_arguments import TypedArgument
from world_model import Sort, WorldObject
from world_model.world_object import ROBOT_ID


def what_is_held(arguments: Arguments, known: RobotKnowledge) -> str:
    """Say what a person or the robot holds, or whether it is something."""
    agent, theme = arguments.get("agent"), arguments.get("theme")
    holders = found_of(agent, known) if agent is not None else known.situation.objects([ROBOT_ID])
    if not holders and agent is not None:
        return unknown_of(agent)
    if theme is not None:
        return _whether_held(theme, holders, known)
    return " ".join(_of_holder(one, known) for one in holders) or "I hold nothing."


def _whether_held(theme: TypedArgument, holders: Objects, known: RobotKnowledge) -> str:
    things = found_of(theme, known, is_wide=not theme.referents)
    if not things:
        return unknown_of(theme)
    ids = {one.id for one in things}
    if ids & known.world.at("held_by", holders):
        return " ".join(["Yes.", *(_of_holder(one, known) for one in holders)])
    if any(one.id in ids for holder in holders for one in _owned(holder, known)):
        return " ".join(["Yes.", *(_of_owner(one, known) for one in holders)])
    named = [(name_for(theme, one) if len(things) == 1 else full_name(one), one) for one in things]
    told = [
        f"{name} {verb_of([one], name)} {place_of(one, known.world)}"
        for name, one in named[:MOST_NAMED]
        if place_of(one, known.world)
    ]
    holds = " ".join(_of_holder(one, known) for one in holders)
    return f"No, as far as I know: {join_with_and(told)}." if told else holds


def belongings(arguments: Arguments, known: RobotKnowledge) -> str:
    """Say what a person, the robot or a place has: in the hand, in it, on it, and what belongs to a person."""
    owners = found_of(arguments["owner"], known)
    if not owners:
        return unknown_of(arguments["owner"])
    return " ".join(_of_owner(one, known) for one in owners)


def _of_holder(holder: WorldObject, known: RobotKnowledge) -> str:
    held = _without_robot(known.world.at("held_by", (holder,)), known)
    if holder.id == ROBOT_ID:
        return f"I hold {join_with_and(indefinite(held))}." if held else "I hold nothing."
    name = with_capital(name_of(holder))
    if not held:
        return f"I do not know that {name_of(holder)} holds anything."
    return f"{name} holds {join_with_and(indefinite(held))}."


def _of_owner(owner: WorldObject, known: RobotKnowledge) -> str:
    owned = _owned(owner, known)
    belongs = f"{with_capital(join_with_and(indefinite(owned)))} {'belongs' if len(owned) == 1 else 'belong'} to"
    if owner.id == ROBOT_ID or owner.sort is Sort.PERSON:
        held = known.world.at("held_by", (owner,))
        sentences = [f"{belongs} {'me' if owner.id == ROBOT_ID else name_of(owner)}."] if owned else []
        if held or owner.id == ROBOT_ID:
            sentences.insert(0, _of_holder(owner, known))
        return " ".join(sentences) or f"I do not know of anything that {name_of(owner)} has."
    inside = _without_robot(known.world.at("in", (owner,)) | known.world.at("on", (owner,)), known)
    if not inside:
        return f"I know of nothing that {name_of(owner)} has."
    return f"{with_capital(name_of(owner))} has {join_with_and(indefinite(inside))}."


def _owned(owner: WorldObject, known: RobotKnowledge) -> Objects:
    return tuple(one for one in known.world.objects if owner in known.world.owners(one))


def _without_robot(ids: FrozenSet[str], known: RobotKnowledge) -> Objects:
    return known.situation.objects(sorted(ids - {ROBOT_ID}))


ABOUT_HOLDERS: Dict[str, Callable[[Arguments, RobotKnowledge], str]] = {
    "question_of_what_is_held": what_is_held,
    "question_of_belongings": belongings,
}
