"""More that the robot can do in a home: moving what is heavy, treating things, gestures; the table of all actions."""

import math
from dataclasses import dataclass, replace
from typing import Dict, Optional, Tuple

from roboframenet_sim.home_actions import (
    MANIPULATION,
    Action,
    Failure,
    Rule,
    Scene,
    can_handle,
    can_reach,
    first,
    has_free_hand,
    has_trait,
    is_held,
    nothing,
    place_at,
)
from roboframenet_sim.home_state import ROBOT, Place, State

#: What is pushed to something comes so near, metres.
PUSHED_TO_M = 1.6
#: How far something is thrown, and how near a person stands who catches it; metres.
THROW_M = 4.0
_PICTURE_M = 6.0


@dataclass(frozen=True)
class Treatment:
    """Something that changes how a thing is.

    Attributes:
        trait: what the thing must be: food, cloth, dish, surface, room
        changes: properties that it has afterwards
        seconds: how long it takes
        tool: trait of a tool in the hand; empty for bare hands
        station: trait of furniture within reach
        is_station_on: whether the station must be on
    """

    trait: str
    changes: Dict[str, object]
    seconds: float = 6.0
    tool: str = ""
    station: str = ""
    is_station_on: bool = False


#: What can be done to things. Whoever adds a line needs no other code: the server of a frame names the treatment.
TREATMENTS: Dict[str, Treatment] = {
    "wipe": Treatment("surface", {"is_dirty": False}, tool="cleans"),
    "scrub": Treatment("washable", {"is_dirty": False, "is_scrubbed": True}, 10.0, tool="cleans"),
    "rinse": Treatment("washable", {"is_wet": True, "is_rinsed": True}, 4.0, station="water"),
    "wash_dish": Treatment("dish", {"is_dirty": False, "is_wet": True}, 8.0, station="water"),
    "dry": Treatment("washable", {"is_wet": False}, 5.0, tool="dries"),
    "sweep": Treatment("room", {"is_dirty": False}, 20.0, tool="sweeps"),
    "cut": Treatment("food", {"form": "cut"}, 8.0, tool="cuts"),
    "chop": Treatment("food", {"form": "chopped"}, 8.0, tool="cuts"),
    "slice": Treatment("food", {"form": "sliced"}, 8.0, tool="cuts"),
    "peel": Treatment("food", {"is_peeled": True}, 8.0, tool="cuts"),
    "mix": Treatment("food", {"is_mixed": True}, 6.0, tool="stirs"),
    "boil": Treatment("food", {"cooked": "boiled"}, 30.0, station="heats", is_station_on=True),
    "fry": Treatment("food", {"cooked": "fried"}, 20.0, station="heats", is_station_on=True),
    "bake": Treatment("food", {"cooked": "baked"}, 30.0, station="bakes", is_station_on=True),
    "fold": Treatment("cloth", {"is_folded": True}, 6.0),
    "iron": Treatment("cloth", {"is_ironed": True}, 12.0, tool="irons"),
    "wash_cloth": Treatment("cloth", {"is_dirty": False, "is_wet": True}, 30.0, station="washes"),
    "sort": Treatment("cloth", {"is_sorted": True}, 3.0),
}


def check_treat(scene: Scene, action: Action) -> Optional[Failure]:
    """The thing is of the kind and within reach, the tool in the hand, the station near."""
    treatment = TREATMENTS.get(action.value)
    if treatment is None:
        return Failure("unknown", f"I do not know how to {action.value}.")
    entity = scene.entity(action.theme)
    if entity is None:
        return Failure("unknown", f"There is no {action.theme}.")
    words = action.value.split("_")[0]
    if treatment.trait == "room":
        here = scene.plan.room_at(scene.plan.position(scene.state, ROBOT))
        if entity.kind != "room":
            return Failure("wrong_kind", f"I cannot {words} {entity.the_name}.", action.theme)
        if here != entity.id:
            return Failure("too_far", f"I am not in {entity.the_name}.", entity.id)
        if scene.plan.robot.hands == 0:
            return Failure("no_hand", "I have no hand.")
    else:
        failure = first(
            has_trait(scene, action.theme, treatment.trait, f"I cannot {words} {{}}."), can_reach(scene, action.theme)
        )
        if failure:
            return failure
    return first(_check_tool(scene, treatment, words), _check_station(scene, treatment, words))


def _check_tool(scene: Scene, treatment: Treatment, words: str) -> Optional[Failure]:
    held = scene.state.held_by(ROBOT)
    if treatment.tool and not any(treatment.tool in scene.plan.entities[thing].traits for thing in held):
        return Failure("no_tool", f"I hold nothing to {words} with.")
    return None


def _check_station(scene: Scene, treatment: Treatment, words: str) -> Optional[Failure]:
    if not treatment.station:
        return None
    near = [
        entity
        for entity in scene.plan.entities.values()
        if treatment.station in entity.traits and can_reach(scene, entity.id) is None
    ]
    if not near:
        return Failure("too_far", f"Nothing here to {words} with.")
    if treatment.is_station_on and not any(scene.state.is_(entity.id, "is_on") for entity in near):
        return Failure("off", f"{near[0].the_name.capitalize()} is off.", near[0].id)
    return None


def effect_treat(scene: Scene, action: Action) -> State:
    """The thing is as the treatment says."""
    changes = TREATMENTS[action.value].changes
    return scene.state.with_property(action.theme, **changes)  # type: ignore[arg-type]


def check_push(scene: Scene, action: Action) -> Optional[Failure]:
    """Something on the floor or on a surface within reach, not too heavy."""
    entity = scene.entity(action.theme)
    if entity is None or entity.kind != "thing":
        return Failure("wrong_kind", f"I cannot move {entity.the_name if entity else action.theme}.", action.theme)
    if entity.mass_kg > scene.plan.robot.most_pushed_kg:
        return Failure("too_heavy", f"{entity.the_name.capitalize()} is too heavy for me.", action.theme)
    place = scene.state.places[action.theme]
    if place.relation == "held":
        return Failure("held", f"Somebody holds {entity.the_name}.", action.theme)
    if place.relation == "in":
        return Failure("wrong_kind", f"{entity.the_name.capitalize()} is inside something.", action.theme)
    failure = first(can_reach(scene, action.theme), has_free_hand(scene))
    if failure or not action.goal:
        return failure
    goal = scene.entity(action.goal)
    if goal is None or action.goal == action.theme or action.relation in ("on", "in"):
        return Failure("wrong_kind", f"I cannot push {entity.the_name} there.", action.theme)
    if goal.kind == "room":
        here = scene.plan.room_at(scene.plan.position(scene.state, ROBOT))
        return None if here == goal.id else Failure("too_far", f"I am not in {goal.the_name}.", goal.id)
    return (
        None
        if scene.distance_m(action.goal) <= PUSHED_TO_M
        else Failure("too_far", f"{goal.the_name.capitalize()} is too far away.", action.goal)
    )


def effect_push(scene: Scene, action: Action) -> State:
    """The thing is half a metre further, or nearer, or beside the goal; it stays on what it is on."""
    state, place = scene.state, scene.state.places[action.theme]
    if action.goal:
        # It is on the floor where the robot has pushed it to.
        room = scene.plan.room_at(scene.plan.position(state, ROBOT))
        at = place_at(scene, room, "on")
        if scene.plan.entities[action.goal].kind == "furniture":
            at = Place(action.relation or "beside", action.goal, at.x_m, at.y_m)
        return state.with_place(action.theme, at).with_property(action.theme, is_moved=True)
    distance_m = 0.3 if math.isnan(action.amount) else action.amount
    yaw_rad = state.robot.pose.yaw_rad + {"left": math.pi / 2, "right": -math.pi / 2}.get(action.value, 0.0)
    sign = -1.0 if action.value in ("back", "backward", "nearer") else 1.0
    x_m, y_m = (
        place.x_m + sign * distance_m * math.cos(yaw_rad),
        place.y_m + sign * distance_m * math.sin(yaw_rad),
    )
    holder = scene.plan.entities[place.holder]
    if holder.kind in ("furniture", "room"):
        # It stops at the edge, or at the wall.
        x_m = min(max(x_m, holder.x_m[0] + 0.05), holder.x_m[1] - 0.05)
        y_m = min(max(y_m, holder.y_m[0] + 0.05), holder.y_m[1] - 0.05)
    return state.with_place(action.theme, replace(place, x_m=x_m, y_m=y_m)).with_property(action.theme, is_moved=True)


def check_throw(scene: Scene, action: Action) -> Optional[Failure]:
    """The robot holds it, and who catches it is near and seen."""
    failure = is_held(scene, action.theme)
    if failure is None and action.goal:
        target = scene.plan.position(scene.state, action.goal)
        me = scene.plan.position(scene.state, ROBOT)
        if scene.distance_m(action.goal) > THROW_M or not scene.floor.sees(scene.state, me, target, but=[action.goal]):
            return Failure(
                "too_far", f"I cannot throw as far as {scene.plan.entities[action.goal].the_name}.", action.goal
            )
    return failure


def effect_throw(scene: Scene, action: Action) -> State:
    """A person has it, or it lies on the floor or in the goal."""
    state = scene.state
    state = state.with_event("gesture", ROBOT, f"threw {action.theme}")
    if action.goal in state.people:
        return state.with_place(action.theme, Place("held", action.goal))
    room = scene.plan.room_at(scene.plan.position(state, ROBOT))
    goal = scene.plan.entities.get(action.goal)
    if goal is not None and goal.kind == "furniture" and "container" in goal.traits:
        return state.with_place(action.theme, place_at(scene, action.goal, "in"))
    yaw_rad, pose = state.robot.pose.yaw_rad, state.robot.pose
    for distance_m in (2.0, 1.5, 1.0, 0.5, 0.0):
        spot = pose.x_m + distance_m * math.cos(yaw_rad), pose.y_m + distance_m * math.sin(yaw_rad)
        if scene.plan.room_at(spot) == room and scene.floor.sees(state, (pose.x_m, pose.y_m), spot):
            break
    return state.with_place(action.theme, Place("on", room, *spot))


def check_pour(scene: Scene, action: Action) -> Optional[Failure]:
    """The robot holds what is poured from, and reaches a vessel or a plant."""
    failure = first(
        is_held(scene, action.theme),
        has_trait(scene, action.goal, "vessel", "I cannot pour anything into {}."),
        can_reach(scene, action.goal),
    )
    if failure is None and not scene.state.get(action.theme, "contents"):
        failure = Failure("empty", f"{scene.plan.entities[action.theme].the_name.capitalize()} is empty.", action.theme)
    return failure


def effect_pour(scene: Scene, action: Action) -> State:
    """The vessel holds what was poured."""
    contents = scene.state.get(action.theme, "contents")
    return scene.state.with_property(action.goal, contents=contents, is_full=True)


def check_attach(scene: Scene, action: Action) -> Optional[Failure]:
    """Both within reach; what has a plug, or is held."""
    failure = first(
        has_trait(scene, action.theme, "attachable", "{} cannot be attached or detached."),
        can_reach(scene, action.theme),
    )
    if failure is None and action.kind == "attach" and action.goal:
        failure = can_reach(scene, action.goal)
    return failure


def effect_attach(scene: Scene, action: Action) -> State:
    """It is attached to the goal and plugged in, or neither."""
    is_attached = action.kind == "attach"
    state = scene.state.with_property(action.theme, is_unplugged=not is_attached, attached_to=action.goal)
    if not is_attached and "switch" in scene.plan.entities[action.theme].traits:
        state = state.with_property(action.theme, is_on=False)
    return state


def check_turn_thing(scene: Scene, action: Action) -> Optional[Failure]:
    """Something within reach and a free hand, or something in the hand."""
    return can_reach(scene, action.theme) or (None if is_held(scene, action.theme) is None else has_free_hand(scene))


def effect_turn_thing(scene: Scene, action: Action) -> State:
    """It is turned by the angle, in radians."""
    angle = scene.state.number(action.theme, "angle_rad") + action.amount
    return scene.state.with_property(action.theme, angle_rad=round(math.remainder(angle, 2 * math.pi), 4))


def effect_press(scene: Scene, action: Action) -> State:
    """It was pressed once more; what has a switch changes."""
    count = scene.state.number(action.theme, "presses") + 1
    state = scene.state.with_property(action.theme, presses=count)
    if "switch" in scene.plan.entities[action.theme].traits:
        state = state.with_property(action.theme, is_on=not state.is_(action.theme, "is_on"))
    return state


def check_raise(scene: Scene, action: Action) -> Optional[Failure]:
    """Something that goes up and down within reach."""
    return can_handle(scene, action.theme, "raisable", "{} cannot be raised or lowered.")


def effect_raise(scene: Scene, action: Action) -> State:
    """It is up or down."""
    return scene.state.with_property(action.theme, is_up=action.value == "up")


def check_lift(scene: Scene, action: Action) -> Optional[Failure]:
    """The lift goes so high."""
    if scene.plan.robot.hands == 0:
        return Failure("no_hand", "I have no lift.")
    if 0.0 <= action.amount <= scene.plan.robot.lift_m:
        return None
    return Failure("too_high", f"My lift goes up to {scene.plan.robot.lift_m:g} m.")


def check_arm(scene: Scene, _action: Action) -> Optional[Failure]:
    """The robot has an arm."""
    return None if scene.plan.robot.hands else Failure("no_hand", "I have no arm.")


def effect_gesture(scene: Scene, action: Action) -> State:
    """Those who see the robot have seen it."""
    seen = tuple(person for person in scene.state.people if scene.distance_m(person) <= ROBOT_SIGHT_M)
    return scene.state.with_event("gesture", ROBOT, f"{action.value} {action.goal or action.theme}".strip(), seen)


#: From so far people see a gesture.
ROBOT_SIGHT_M = 6.0


def check_dock(scene: Scene, action: Action) -> Optional[Failure]:
    """The station is where the robot stands."""
    failure = has_trait(scene, action.theme, "station", "{} is not a charging station.")
    if failure is None and scene.distance_m(action.theme) > 1.0:
        failure = Failure("too_far", "I am not at the charging station.", action.theme)
    return failure


def check_look(scene: Scene, action: Action) -> Optional[Failure]:
    """All round, or at something known."""
    if action.theme and scene.entity(action.theme) is None:
        return Failure("unknown", f"There is no {action.theme}.")
    return None


def effect_look(scene: Scene, action: Action) -> State:
    """The head points there; without a target the robot has looked all round."""
    if action.theme:
        return scene.state.with_robot(looks_at=action.theme)
    return scene.state.with_robot(looks_at="", scanned_s=scene.state.time_s)


def effect_photo(scene: Scene, action: Action) -> State:
    """A picture of what the robot sees."""
    return scene.state.with_event("photo", ROBOT, " ".join(scene.floor.visible(scene.state)))


RULES: Dict[str, Rule] = {
    **MANIPULATION,
    "treat": Rule(check_treat, effect_treat),
    "push": Rule(check_push, effect_push, 3.0, occupies=("arm", "base")),
    "throw": Rule(check_throw, effect_throw, 1.0),
    "pour": Rule(check_pour, effect_pour, 4.0),
    "attach": Rule(check_attach, effect_attach, 3.0),
    "detach": Rule(check_attach, effect_attach, 3.0),
    "rotate": Rule(check_turn_thing, effect_turn_thing),
    "press": Rule(check_turn_thing, effect_press),
    "raise": Rule(check_raise, effect_raise, 3.0),
    "lift": Rule(check_lift, lambda scene, action: scene.state.with_robot(lift_m=action.amount), 2.0, 0.0),
    "arm": Rule(check_arm, lambda scene, action: scene.state.with_robot(arm=action.value), 2.0, 0.0),
    "gesture": Rule(nothing, effect_gesture, 2.0, 1.0, ("arm", "head")),
    "look": Rule(check_look, effect_look, 3.0, 1.0, ("head",)),
    "photograph": Rule(nothing, effect_photo, 0.5, 0.5, ("head",)),
    "dock": Rule(check_dock, lambda scene, _: scene.state.with_robot(is_docked=True), 4.0, 0.0, ("base",)),
    "wait": Rule(nothing, lambda scene, _: scene.state, 0.0, 0.0, ()),
}


def durations_s(action: Action) -> Tuple[float, float]:
    """Return the times until the effect and until the end."""
    rule = RULES[action.kind]
    before_s = rule.before_s
    if action.kind == "treat" and action.value in TREATMENTS:
        before_s = TREATMENTS[action.value].seconds
    if action.kind == "wait":
        before_s = max(0.0, action.amount)
    return before_s, before_s + rule.after_s
