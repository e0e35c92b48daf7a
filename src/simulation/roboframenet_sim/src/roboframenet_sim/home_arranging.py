"""A home that is arranged before something is tried in it: things and persons are put where a test wants them."""

from dataclasses import replace
from typing import Mapping

from roboframenet_sim.home_floor import Floor
from roboframenet_sim.home_state import Entity, Place, Plan, Point, State
from roboframenet_sim.planner import NoPath

#: Things that are put on one piece of furniture stand so far from each other.
_APART_M = 0.15
#: They stand so far from its edge.
_INSET_M = 0.15
_POSTURES = ("standing", "sitting")


class ArrangementError(ValueError):
    """A home cannot be arranged so; the message says why."""


def arranged(plan: Plan, floor: Floor, state: State, wishes: Mapping[str, str]) -> State:
    """Return a state with things and persons elsewhere.

    Args:
        plan, floor: of the home
        state: what is otherwise
        wishes: by id: "on desk", "in fridge" for a thing; "at sofa", "at sofa sitting" for a person
    Raises:
        ArrangementError: there is no such thing or place, or no room for a person
    """
    for ident, words in wishes.items():
        relation, target, posture, *rest = (*words.split(), "", "", "")[:4]
        entity, goal = plan.entities.get(ident), plan.entities.get(target)
        if entity is None or goal is None or any(rest):
            raise ArrangementError(f"{ident}: {words!r} is no place of the home")
        if entity.kind == "person" and relation == "at" and posture in ("", *_POSTURES):
            state = _with_person(plan, floor, state, ident, goal, posture or "standing")
        elif entity.kind == "thing" and relation in ("on", "in") and not posture:
            state = state.with_place(ident, Place(relation, target, *_spot(plan, state, goal)))
        else:
            raise ArrangementError(f"{ident}: {words!r} is no place for it")
    return state


def _with_person(plan: Plan, floor: Floor, state: State, person: str, goal: Entity, posture: str) -> State:
    start = plan.position(state, person)
    try:
        x_m, y_m = floor.place_to_stand(state, goal.id, reach_m=0.9, start=start, is_person=True)
    except NoPath as error:
        raise ArrangementError(f"{person}: nobody can stand at {goal.id}: {error}") from error
    return state.with_person(person, pose=replace(state.people[person].pose, x_m=x_m, y_m=y_m), posture=posture)


def _spot(plan: Plan, state: State, goal: Entity) -> Point:
    """Return a place at the edge that is nearest to the middle of the room, beside what is there already."""
    if goal.kind == "thing":
        return 0.0, 0.0
    middle = plan.entities[goal.room].centre if goal.room else goal.centre
    count = len(state.at(goal.id))
    shift_m = _APART_M * ((count + 1) // 2) * (-1.0) ** count
    is_wide = goal.x_m[1] - goal.x_m[0] >= goal.y_m[1] - goal.y_m[0]
    x_m, y_m = middle[0] + (shift_m if is_wide else 0.0), middle[1] + (0.0 if is_wide else shift_m)
    return _inside(x_m, goal.x_m), _inside(y_m, goal.y_m)


def _inside(value_m: float, ends_m: Point) -> float:
    inset_m = min(_INSET_M, (ends_m[1] - ends_m[0]) / 2.0)
    return min(max(value_m, ends_m[0] + inset_m), ends_m[1] - inset_m)
