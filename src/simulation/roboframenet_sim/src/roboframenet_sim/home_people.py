"""The persons of a home: they stand, sit, walk and follow, and take and put down things by the rules of the robot."""

import math
import random
from dataclasses import dataclass, field
from typing import Dict, List, Tuple, Union

from roboframenet_sim.base import Pose
from roboframenet_sim.home_actions import Failure
from roboframenet_sim.home_floor import Floor
from roboframenet_sim.home_state import ROBOT, Place, Plan, Point, State
from roboframenet_sim.planner import NoPath

WALK_M_PER_S = 0.9
#: Whoever follows keeps this distance.
FOLLOW_M = 1.0
#: A person reaches so far.
REACH_M = 1.2
#: A person opens a door from so far.
_DOOR_M = 0.6
#: Whoever follows looks for a new way so often, seconds.
_NEW_WAY_S = 1.0
#: What persons do when the robot asks for it, and by which words they know.
_REQUESTS = (
    ("follow", ("follow me", "come with me")),
    ("stand", ("we are there", "wait", "stop", "stand", "stay")),
    ("sit", ("sit", "take a seat")),
)


@dataclass
class _Walk:
    """Where a person walks, and what comes then."""

    corners: List[Point] = field(default_factory=list)
    sits_at: str = ""
    rest_s: float = 0.0
    way_age_s: float = 0.0


class People:
    """Moves the persons.

    Args:
        plan: of the home; its habits say who walks where by turns
        floor: of the plan
        seed: of how long somebody stays
    """

    def __init__(self, plan: Plan, floor: Floor, *, seed: int = 0) -> None:
        self._plan = plan
        self._floor = floor
        self._random = random.Random(seed + 1)
        self._walks: Dict[str, _Walk] = {}
        self._turns: Dict[str, int] = {}
        self._waits_s: Dict[str, float] = {person: self._rest_s() for person in plan.habits}

    def _rest_s(self) -> float:
        return self._random.uniform(120.0, 300.0)

    def order(self, state: State, person: str, order: str, target: str) -> Union[State, Failure]:
        """Begin what a person is told: stand, sit, walk, follow, take, put."""
        if person not in state.people or self._plan.entities[person].kind != "person":
            return Failure("unknown", f"There is nobody called {person}.")
        name = self._plan.entities[person].name
        if target and target not in self._plan.entities and target != "robot":
            return Failure("unknown", f"There is no {target}.")
        if order in ("stand", "sit"):
            self._walks.pop(person, None)
            return state.with_person(person, posture="standing" if order == "stand" else "sitting", follows="")
        if order == "follow":
            self._walks.pop(person, None)
            return state.with_person(person, posture="standing", follows=target)
        if order == "walk":
            return self._begin_walk(state, person, target)
        if order == "take":
            return self._take(state, person, name, target)
        if order == "put":
            return self._put(state, person, name, target)
        return Failure("unknown", f"{name} cannot {order}.")

    def hear(self, state: State, person: str, text: str) -> Tuple[State, str]:
        """A person hears what the robot says, and does or answers it when it names the person.

        Returns:
            the state, and the answer; empty for none
        """
        words = text.lower()
        name = self._plan.entities[person].name
        if name.lower() not in words:
            return state, ""
        for order, signs in _REQUESTS:
            if any(sign in words for sign in signs):
                changed = self.order(state, person, order, ROBOT if order == "follow" else "")
                return (state, "") if isinstance(changed, Failure) else (changed, "")
        if text.endswith("?"):
            for (who, about), answer in self._plan.answers.items():
                if who == person and about in words:
                    return state, answer
            return state, "I do not know"
        return state, ""

    def _take(self, state: State, person: str, name: str, thing: str) -> Union[State, Failure]:
        place = state.places.get(thing)
        if place is None or place.relation == "held":
            return Failure("gone", f"{name} cannot take it.", thing)
        if any(self._floor.is_hidden_in(state, one.holder, one.relation) for one in self._plan.holders(state, thing)):
            return Failure("closed", f"{name} cannot get at it.", thing)
        if self._distance_m(state, person, thing) > REACH_M:
            return Failure("too_far", f"{name} is too far away from it.", thing)
        if len(state.held_by(person)) >= 2:
            return Failure("hands_full", f"{name} has no hand free.", person)
        return state.with_place(thing, Place("held", person))

    def _put(self, state: State, person: str, name: str, thing: str) -> Union[State, Failure]:
        if thing not in state.held_by(person):
            return Failure("not_held", f"{name} does not hold it.", thing)
        point = self._plan.position(state, person)
        near = [
            (entity.distance_m(point), entity.id)
            for entity in self._plan.of_kind("furniture")
            if "surface" in entity.traits and entity.distance_m(point) <= REACH_M
        ]
        if near:
            furniture = self._plan.entities[min(near)[1]]
            x_m = min(max(point[0], furniture.x_m[0] + 0.1), furniture.x_m[1] - 0.1)
            y_m = min(max(point[1], furniture.y_m[0] + 0.1), furniture.y_m[1] - 0.1)
            return state.with_place(thing, Place("on", furniture.id, x_m, y_m))
        return state.with_place(thing, Place("on", self._plan.room_at(point), *point))

    def _distance_m(self, state: State, person: str, target: str) -> float:
        begin, end = self._plan.position(state, person), self._plan.position(state, target)
        return math.hypot(begin[0] - end[0], begin[1] - end[1])

    def _begin_walk(self, state: State, person: str, target: str) -> Union[State, Failure]:
        start = self._plan.position(state, person)
        try:
            goal = self._floor.place_to_stand(state, target, reach_m=0.9, start=start, is_person=True)
            corners = self._floor.way(state, start, goal, is_person=True)
        except NoPath as error:
            return Failure("no_way", f"{self._plan.entities[person].name} cannot get there: {error}.")
        entity = self._plan.entities.get(target)
        seat = target if entity is not None and "seat" in entity.traits else ""
        self._walks[person] = _Walk(corners[1:], seat)
        return state.with_person(person, posture="walking", follows="")

    def step(self, state: State, duration_s: float) -> State:
        """Advance the time."""
        for person in state.people:
            state = self._step_person(state, person, duration_s)
        return state

    def _step_person(self, state: State, person: str, duration_s: float) -> State:
        now = state.people[person]
        if now.follows:
            return self._step_follower(state, person, now.follows, duration_s)
        walk = self._walks.get(person)
        if walk is None:
            return self._step_habit(state, person, duration_s)
        state, is_there = self._advance(state, person, walk, duration_s)
        if not is_there:
            return state
        del self._walks[person]
        return state.with_person(person, posture="sitting" if walk.sits_at else "standing")

    def _step_habit(self, state: State, person: str, duration_s: float) -> State:
        if person not in self._waits_s:
            return state
        self._waits_s[person] -= duration_s
        if self._waits_s[person] > 0.0:
            return state
        self._waits_s[person] = self._rest_s()
        places = self._plan.habits[person]
        self._turns[person] = (self._turns.get(person, 0) + 1) % len(places)
        changed = self._begin_walk(state, person, places[self._turns[person]])
        return state if isinstance(changed, Failure) else changed

    def _step_follower(self, state: State, person: str, leader: str, duration_s: float) -> State:
        walk = self._walks.setdefault(person, _Walk(way_age_s=_NEW_WAY_S))
        walk.way_age_s += duration_s
        if self._distance_m(state, person, leader) <= FOLLOW_M:
            walk.corners = []
        elif walk.way_age_s >= _NEW_WAY_S:
            walk.way_age_s = 0.0
            start = self._plan.position(state, person)
            try:
                goal = self._floor.place_to_stand(state, leader, reach_m=FOLLOW_M, start=start, is_person=True)
                walk.corners = self._floor.way(state, start, goal, is_person=True)[1:]
            except NoPath:
                walk.corners = []
        if not walk.corners:
            if state.people[person].posture != "standing":
                state = state.with_person(person, posture="standing")
            return state
        return self._advance(state, person, walk, duration_s)[0]

    def _advance(self, state: State, person: str, walk: _Walk, duration_s: float) -> Tuple[State, bool]:
        """Walk on; returns the state, and whether the person is there."""
        pose = state.people[person].pose
        left_m = WALK_M_PER_S * duration_s
        x_m, y_m, yaw_rad = pose.x_m, pose.y_m, pose.yaw_rad
        while walk.corners and left_m > 0.0:
            corner = walk.corners[0]
            distance_m = math.hypot(corner[0] - x_m, corner[1] - y_m)
            if distance_m > 1e-6:
                yaw_rad = math.atan2(corner[1] - y_m, corner[0] - x_m)
            share = min(1.0, left_m / distance_m) if distance_m > 1e-9 else 1.0
            x_m, y_m = x_m + share * (corner[0] - x_m), y_m + share * (corner[1] - y_m)
            if share < 1.0:
                # What rounding leaves of the way must not be walked again and again.
                break
            left_m -= distance_m
            walk.corners.pop(0)
        state = self._open_doors(state, (x_m, y_m))
        return state.with_person(person, pose=Pose(x_m, y_m, yaw_rad), posture="walking"), not walk.corners

    def _open_doors(self, state: State, point: Point) -> State:
        for door in self._plan.of_kind("door"):
            if "closable" in door.traits and not state.is_(door.id, "is_open") and not state.is_(door.id, "is_locked"):
                low_x, high_x = sorted(door.x_m)
                low_y, high_y = sorted(door.y_m)
                away_m = math.hypot(
                    max(low_x - point[0], 0.0, point[0] - high_x), max(low_y - point[1], 0.0, point[1] - high_y)
                )
                if away_m <= _DOOR_M:
                    state = state.with_property(door.id, is_open=True)
        return state
