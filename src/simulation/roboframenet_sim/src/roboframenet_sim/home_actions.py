"""What the robot can do in a home: preconditions, durations and effects.

An action has three parts: the arm goes there, the effect happens at one moment, the arm comes back. The preconditions
hold at the beginning and at the moment of the effect. A preempted action has had its effect or not, never a part of it.
"""

import math
from dataclasses import dataclass, replace
from typing import Callable, Dict, Optional, Tuple

from roboframenet_sim.home_floor import Floor
from roboframenet_sim.home_state import RELATIONS, ROBOT, Entity, Place, Plan, State

#: So many things fit on or in furniture, or in another thing, per square metre and at least.
_THINGS_PER_M2 = 30
_LEAST_THINGS = 6
#: What is put beside something is so far from it.
_BESIDE_M = 0.12
#: A person takes what is held out at arm's length.
_HAND_OVER_M = 1.3


@dataclass(frozen=True)
class Failure:
    """Why an action cannot be done.

    Attributes:
        code: too_far, too_high, too_low, closed, locked, blocked, hands_full, not_held, too_heavy, gone, full, slipped,
            unknown, wrong_kind, no_tool, no_hand, no_way, busy and others
        sentence: for the person
        entity: what is in the way: the closed door, the full shelf
    """

    code: str
    sentence: str
    entity: str = ""


@dataclass(frozen=True)
class Action:
    """Something to do.

    Attributes:
        kind: one of :data:`RULES`, or "go"
        theme: id of what it is done to
        goal: id of a second entity: where to, for whom
        relation: of the theme to the goal afterwards: on, in, under, beside, ...
        value: on, off, a setting, a treatment, a gesture
        amount: a height, a level, an angle; NaN for none
        tool: id of the tool that the robot holds
        avoided: ids of rooms and doors that a way shall not lead through, with blanks between
    """

    kind: str
    theme: str = ""
    goal: str = ""
    relation: str = ""
    value: str = ""
    amount: float = math.nan
    tool: str = ""
    avoided: str = ""


@dataclass(frozen=True)
class Scene:
    """What preconditions and effects look at: the plan, its floor and the state."""

    plan: Plan
    floor: Floor
    state: State

    def entity(self, ident: str) -> Optional[Entity]:
        """Return an entity, None for an unknown one."""
        return self.plan.entities.get(ident)

    def distance_m(self, target: str) -> float:
        """Distance of the robot from what it wants to reach."""
        point = self.plan.position(self.state, ROBOT)
        entity = self.plan.entities[target]
        if entity.kind in ("furniture", "door"):
            return _extent(entity).distance_m(point)
        end = self.plan.position(self.state, target)
        return math.hypot(end[0] - point[0], end[1] - point[1])


def _extent(entity: Entity) -> Entity:
    """A door whose ends are written the other way round has an extent, too."""
    low_x, high_x = sorted(entity.x_m)
    low_y, high_y = sorted(entity.y_m)
    return Entity(entity.id, entity.kind, entity.names, x_m=(low_x, high_x), y_m=(low_y, high_y))


Check = Callable[[Scene, Action], Optional[Failure]]
Effect = Callable[[Scene, Action], State]


@dataclass(frozen=True)
class Rule:
    """How a kind of action goes.

    Attributes:
        check: the preconditions; None when they hold
        effect: the state after it
        before_s: until the effect
        after_s: from the effect to the end
        occupies: base, arm, head
    """

    check: Check
    effect: Effect
    before_s: float = 2.0
    after_s: float = 1.0
    occupies: Tuple[str, ...] = ("arm",)


def can_reach(scene: Scene, target: str) -> Optional[Failure]:
    """Return why the arm does not reach something; None when it does."""
    entity = scene.entity(target)
    if entity is None:
        return Failure("unknown", f"There is no {target}.")
    limits = scene.plan.robot
    state = scene.state
    if limits.hands == 0:
        return Failure("no_hand", "I have no hand.")
    places = scene.plan.holders(state, target)
    for place in places:
        if scene.floor.is_hidden_in(state, place.holder, place.relation):
            holder = scene.plan.entities[place.holder]
            return Failure("closed", f"{holder.the_name.capitalize()} is closed.", holder.id)
    if any(place.holder == ROBOT for place in places):
        return None
    if scene.distance_m(target) > limits.reach_m:
        return Failure("too_far", f"{entity.the_name.capitalize()} is too far away.", target)
    if not scene.floor.can_reach_past_walls(state, scene.plan.position(state, ROBOT), target):
        return Failure("too_far", f"A wall is between me and {entity.the_name}.", target)
    height_m = scene.plan.height_m(state, target)
    if height_m > limits.highest_m + state.robot.lift_m:
        return Failure("too_high", f"{entity.the_name.capitalize()} is too high for my arm.", target)
    if height_m < limits.lowest_m + state.robot.lift_m and entity.kind == "thing":
        return Failure("too_low", f"{entity.the_name.capitalize()} is too low while my lift is up.", target)
    return None


def has_free_hand(scene: Scene, count: int = 1) -> Optional[Failure]:
    """Return the failure that the hands are full; None when so many are free."""
    if scene.plan.robot.hands == 0:
        return Failure("no_hand", "I have no hand.")
    held = scene.state.held_by(ROBOT)
    if scene.plan.robot.hands - len(held) >= count:
        return None
    names = " and ".join(scene.plan.entities[thing].the_name for thing in held)
    return Failure("hands_full", f"My hands are full: I hold {names}.")


def is_held(scene: Scene, thing: str) -> Optional[Failure]:
    """Return the failure that the robot does not hold something."""
    if thing in scene.state.held_by(ROBOT):
        return None
    entity = scene.entity(thing)
    return Failure("not_held", f"I do not hold {entity.the_name if entity else thing}.", thing)


def has_trait(scene: Scene, target: str, trait: str, sentence: str) -> Optional[Failure]:
    """Return the failure that something is not made for this; `{}` in the sentence is its name."""
    entity = scene.entity(target)
    if entity is None:
        return Failure("unknown", f"There is no {target or 'such thing'}.")
    if trait in entity.traits:
        return None
    words = sentence.format(entity.the_name)
    return Failure("wrong_kind", words[0].upper() + words[1:], target)


def first(*failures: Optional[Failure]) -> Optional[Failure]:
    """Return the first failure."""
    return next((failure for failure in failures if failure is not None), None)


def can_handle(scene: Scene, target: str, trait: str, sentence: str) -> Optional[Failure]:
    """Return why a free hand cannot work something that must have a trait; see :func:`has_trait`."""
    return first(has_trait(scene, target, trait, sentence), can_reach(scene, target), has_free_hand(scene))


def check_grasp(scene: Scene, action: Action) -> Optional[Failure]:
    """Something small, within reach, that nobody else holds, and a free hand."""
    entity = scene.entity(action.theme)
    if entity is None or entity.kind != "thing":
        return Failure("wrong_kind", f"I cannot take {entity.the_name if entity else action.theme}.", action.theme)
    place = scene.state.places[action.theme]
    if place.relation == "held":
        if place.holder == ROBOT:
            return Failure("held", f"I hold {entity.the_name} already.", action.theme)
        who = scene.plan.entities[place.holder].name
        return Failure("gone", f"{who} has {entity.the_name}.", place.holder)
    if entity.mass_kg > scene.plan.robot.most_kg:
        return Failure("too_heavy", f"{entity.the_name.capitalize()} is too heavy for me.", action.theme)
    if scene.state.get(action.theme, "attached_to"):
        return Failure("attached", f"{entity.the_name.capitalize()} is attached.", action.theme)
    return first(has_free_hand(scene), can_reach(scene, action.theme))


def effect_grasp(scene: Scene, action: Action) -> State:
    """The robot holds it."""
    return scene.state.with_place(action.theme, Place("held", ROBOT))


def check_put(scene: Scene, action: Action) -> Optional[Failure]:
    """The robot holds it, reaches the goal, and there is room."""
    goal = scene.entity(action.goal)
    if goal is None:
        return Failure("unknown", f"There is no {action.goal or 'such place'}.")
    failure = first(is_held(scene, action.theme), None if goal.kind == "room" else can_reach(scene, action.goal))
    if failure:
        return failure
    if goal.kind == "room":
        here = scene.plan.room_at(scene.plan.position(scene.state, ROBOT))
        return None if here == goal.id else Failure("too_far", f"I am not in {goal.the_name}.", goal.id)
    if action.theme == action.goal:
        return Failure("wrong_kind", f"I cannot put {goal.the_name} there.", action.goal)
    if action.relation not in RELATIONS or action.relation == "held":
        return Failure("unknown", f"I cannot put anything {action.relation or 'there'}.", action.goal)
    trait = {"on": "surface", "in": "container"}.get(action.relation)
    if trait and trait not in goal.traits:
        return Failure("wrong_kind", f"I cannot put anything {action.relation} {goal.the_name}.", action.goal)
    if scene.floor.is_hidden_in(scene.state, goal.id, action.relation):
        return Failure("closed", f"{goal.the_name.capitalize()} is closed.", goal.id)
    if goal.kind == "door" or (goal.kind == "person" and action.relation in ("on", "in")):
        return Failure("wrong_kind", f"I cannot put anything {action.relation} {goal.the_name}.", action.goal)
    area_m2 = (goal.x_m[1] - goal.x_m[0]) * (goal.y_m[1] - goal.y_m[0])
    if len(scene.state.at(action.goal, action.relation)) >= max(_LEAST_THINGS, area_m2 * _THINGS_PER_M2):
        return Failure("full", f"There is no room {action.relation} {goal.the_name}.", action.goal)
    return None


def effect_put(scene: Scene, action: Action) -> State:
    """The thing is there."""
    return scene.state.with_place(action.theme, place_at(scene, action.goal, action.relation or "on"))


def place_at(scene: Scene, goal: str, relation: str) -> Place:
    """Return a place on, in, ... furniture, a room or a thing: the part that is nearest to the robot."""
    entity = scene.plan.entities[goal]
    point = scene.plan.position(scene.state, ROBOT)
    if entity.kind == "room":
        yaw_rad = scene.state.robot.pose.yaw_rad
        spot = (point[0] + 0.4 * math.cos(yaw_rad), point[1] + 0.4 * math.sin(yaw_rad))
        spot = spot if entity.contains(spot, -0.1) else point
        return Place("on", goal, *spot)
    if entity.kind == "person":
        return place_at(scene, scene.plan.room_at(point), "on")
    if entity.kind != "furniture":
        beside = scene.state.places.get(goal)
        if relation in ("on", "in", "under") or beside is None or beside.relation == "held":
            return Place(relation, goal)
        # It is no part of the thing, and does not move with it.
        return replace(beside, x_m=beside.x_m + _BESIDE_M, y_m=beside.y_m)
    # Slots along the edge, so that things lie beside each other.
    taken = len(scene.state.at(goal))
    inset = 0.15
    x_low, x_high = entity.x_m[0] + inset, entity.x_m[1] - inset
    y_low, y_high = entity.y_m[0] + inset, entity.y_m[1] - inset
    shift = 0.12 * ((taken % 5) - 2)
    along_x = entity.x_m[1] - entity.x_m[0] >= entity.y_m[1] - entity.y_m[0]
    x = min(max(point[0] + (shift if along_x else 0.0), min(x_low, x_high)), max(x_low, x_high))
    y = min(max(point[1] + (0.0 if along_x else shift), min(y_low, y_high)), max(y_low, y_high))
    return Place(relation, goal, x, y)


def check_give(scene: Scene, action: Action) -> Optional[Failure]:
    """The robot holds it, and the person is there and has a hand free."""
    person = scene.entity(action.goal)
    if person is None or person.kind != "person":
        return Failure("unknown", f"There is nobody called {action.goal}.")
    failure = is_held(scene, action.theme)
    if failure:
        return failure
    if scene.distance_m(action.goal) > _HAND_OVER_M:
        return Failure("too_far", f"{person.name} is too far away.", action.goal)
    if len(scene.state.held_by(action.goal)) >= 2:
        return Failure("hands_full", f"{person.name} has no hand free.", action.goal)
    return None


def effect_give(scene: Scene, action: Action) -> State:
    """The person has it."""
    return scene.state.with_place(action.theme, Place("held", action.goal))


def check_receive(scene: Scene, action: Action) -> Optional[Failure]:
    """A person near the robot has it, and the robot has a hand free."""
    place = scene.state.places.get(action.theme)
    if place is None or place.relation != "held" or place.holder not in scene.state.people:
        return Failure("gone", "Nobody has it.", action.theme)
    if scene.distance_m(place.holder) > _HAND_OVER_M:
        return Failure("too_far", f"{scene.plan.entities[place.holder].name} is too far away.", place.holder)
    return has_free_hand(scene)


def check_open(scene: Scene, action: Action) -> Optional[Failure]:
    """A door or container within reach that is not locked or blocked, and a free hand."""
    failure = can_handle(scene, action.theme, "closable", "{} cannot be opened or closed.")
    if failure:
        return failure
    name = scene.plan.entities[action.theme].the_name.capitalize()
    if scene.state.is_(action.theme, "is_locked"):
        return Failure("locked", f"{name} is locked.", action.theme)
    if scene.state.is_(action.theme, "is_blocked"):
        return Failure("blocked", f"{name} is blocked.", action.theme)
    return None


def effect_open(scene: Scene, action: Action) -> State:
    """It is open, or closed."""
    return scene.state.with_property(action.theme, is_open=action.kind == "open")


def check_lock(scene: Scene, action: Action) -> Optional[Failure]:
    """A closed door or container with a lock."""
    failure = can_handle(scene, action.theme, "lockable", "{} has no lock.")
    if failure is None and action.kind == "lock" and scene.state.is_(action.theme, "is_open"):
        name = scene.plan.entities[action.theme].the_name.capitalize()
        failure = Failure("open", f"{name} is open.", action.theme)
    return failure


def effect_lock(scene: Scene, action: Action) -> State:
    """It is locked, or not."""
    return scene.state.with_property(action.theme, is_locked=action.kind == "lock")


def check_switch(scene: Scene, action: Action) -> Optional[Failure]:
    """A device with a switch within reach; a free hand, and power."""
    failure = can_handle(scene, action.theme, "switch", "{} has no switch.")
    if failure is None and action.value == "on" and scene.state.is_(action.theme, "is_unplugged"):
        name = scene.plan.entities[action.theme].the_name.capitalize()
        failure = Failure("unplugged", f"{name} is not plugged in.", action.theme)
    return failure


def effect_switch(scene: Scene, action: Action) -> State:
    """It is on or off; with a level or a setting it is on."""
    if action.value in ("on", "off"):
        return scene.state.with_property(action.theme, is_on=action.value == "on")
    if action.value:
        return scene.state.with_property(action.theme, is_on=True, setting=action.value)
    state = scene.state.with_property(action.theme, is_on=True)
    return state.with_property(action.theme, level=max(0.0, min(100.0, action.amount)))


def nothing(_scene: Scene, _action: Action) -> Optional[Failure]:
    """No precondition."""
    return None


def _manipulation() -> Dict[str, Rule]:
    return {
        "grasp": Rule(check_grasp, effect_grasp),
        "put": Rule(check_put, effect_put),
        "give": Rule(check_give, effect_give),
        "receive": Rule(check_receive, effect_grasp),
        "open": Rule(check_open, effect_open, 3.0),
        "close": Rule(check_open, effect_open, 3.0),
        "lock": Rule(check_lock, effect_lock, 3.0),
        "unlock": Rule(check_lock, effect_lock, 3.0),
        "switch": Rule(check_switch, effect_switch),
    }


#: How each kind of action with things goes; :mod:`roboframenet_sim.home_rules` adds the others.
MANIPULATION: Dict[str, Rule] = _manipulation()
