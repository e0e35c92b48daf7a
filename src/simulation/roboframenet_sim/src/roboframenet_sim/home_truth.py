"""The ground truth of a home as a flat mapping, for tests, the demonstration and the log."""

import math
from typing import Dict, List, Mapping, Tuple, Union

from roboframenet_sim.home_state import ROBOT, Plan, State

Truth = Dict[str, Union[str, bool, float]]
#: What is nearer to the robot than this, in metres, is listed as near.
NEAR_M = 1.6


def truth_of(plan: Plan, state: State) -> Truth:
    """Return what is true, by names such as "red_mug.place", "fridge.is_open" and "robot.room".

    Positions are rounded to decimetres.
    """
    me = plan.position(state, ROBOT)
    truth: Truth = {
        "robot.room": plan.room_at(me),
        "robot.holds": " ".join(sorted(state.held_by(ROBOT))),
        "robot.arm": state.robot.arm,
        "robot.is_docked": state.robot.is_docked,
        "robot.looks_at": state.robot.looks_at,
    }
    for thing, place in state.places.items():
        truth[f"{thing}.place"] = f"{place.relation} {place.holder}"
        x_m, y_m = plan.position(state, thing)
        truth[f"{thing}.x"], truth[f"{thing}.y"] = round(x_m, 1), round(y_m, 1)
    for person, now in state.people.items():
        truth[f"{person}.room"] = plan.room_at((now.pose.x_m, now.pose.y_m))
        truth[f"{person}.posture"] = now.posture
        truth[f"{person}.follows"] = now.follows
    for entity, values in state.properties.items():
        for name, value in values.items():
            truth[f"{entity}.{name}"] = value
    for name in plan.entities:
        end = plan.position(state, name)
        near_m = (
            plan.entities[name].distance_m(me)
            if name not in state.places
            else math.hypot(end[0] - me[0], end[1] - me[1])
        )
        if name in state.people:
            near_m = math.hypot(end[0] - me[0], end[1] - me[1])
        truth[f"{name}.is_near"] = near_m <= NEAR_M
    return truth


def changes(before: Mapping[str, object], after: Mapping[str, object]) -> List[Tuple[str, object, object]]:
    """Return what changed of things, furniture, doors and what the robot holds: name, before, after."""
    left_out = (".x", ".y", ".is_near", ".looks_at", ".posture")
    return [
        (name, before.get(name, ""), after[name])
        for name in after
        if after[name] != before.get(name, "") and (after[name] or name in before) and not name.endswith(left_out)
    ]


def describe_changes(before: Mapping[str, object], after: Mapping[str, object]) -> str:
    """Return what changed, in one line."""
    words = []
    for name, _, now in changes(before, after):
        words.append(f"{name}: {now}" if not isinstance(now, bool) else f"{name}: {'yes' if now else 'no'}")
    return ", ".join(words)
