"""The home in time: the robot acts, persons walk and sit, faults happen. No clock: the caller counts the seconds."""

import math
import random
from dataclasses import dataclass, replace
from typing import Dict, Iterable, List, Optional, Tuple

from roboframenet_sim.base import STANDING, DifferentialBase, Pose, Velocity
from roboframenet_sim.home_actions import Action, Failure, Scene
from roboframenet_sim.home_floor import Closed, Floor
from roboframenet_sim.home_people import People
from roboframenet_sim.home_rules import RULES, check_push, durations_s, effect_push
from roboframenet_sim.home_state import NO_FAULTS, ROBOT, Faults, Place, Plan, Point, State
from roboframenet_sim.path_following import PathFollower, wrap
from roboframenet_sim.planner import NoPath

#: Actions that drive the base: to a goal, with a heavy thing to a goal, or on the spot until it faces a goal.
DRIVING = ("go", "tow", "face")
#: From so far people hear what is said, in the room and through open doors.
EARSHOT_M = 7.0
#: A door that is blocked is free again after this time.
BLOCKED_S = 20.0
#: A robot sees from so far that a door on its way is closed.
_DOOR_M = 0.9
#: A robot that does not come nearer for this time is stuck.
_STUCK_S = 8.0
#: Whoever goes to something stops this much nearer than the arm reaches.
_SPARE_M = 0.15


@dataclass(frozen=True)
class Outcome:
    """The end of an action.

    Attributes:
        action: what was done
        failure: why it was not; None when it was
        is_preempted: whether it was ended from outside
    """

    action: Action
    failure: Optional[Failure] = None
    is_preempted: bool = False

    @property
    def is_done(self) -> bool:
        """Whether it was done."""
        return self.failure is None and not self.is_preempted


class _Running:
    """An action with a place in time."""

    def __init__(self, action: Action) -> None:
        self.action = action
        self.before_s, self.total_s = durations_s(action)
        self.elapsed_s = 0.0
        self.has_effect = False


class _Driving:
    """A way that the base follows."""

    def __init__(self, action: Action, corners: List[Point], yaw_rad: float) -> None:
        self.action = action
        self.follower = PathFollower(corners, yaw_rad=yaw_rad)
        self.last = Pose()
        self.still_s = 0.0
        self.doors_met: List[str] = []


class Home:
    """A home that obeys rules.

    Args:
        plan: what never changes
        state: what is at the beginning
        seed: of persons and faults; the same calls with the same seed lead to the same states
        faults: how often something goes wrong
        floor: of the plan, with what another home has worked out of it; None for a new one
        people: the persons, if another home moves them; None for own ones
    """

    #: Longest step of persons and actions; longer ones are divided.
    MAX_STEP_S = 0.1

    def __init__(
        self,
        plan: Plan,
        state: State,
        *,
        seed: int = 0,
        faults: Faults = NO_FAULTS,
        floor: Optional[Floor] = None,
        people: Optional[People] = None,
    ) -> None:
        self.plan = plan
        self.floor = floor or Floor(plan)
        self.faults = faults
        self._state = state
        self._random = random.Random(seed)
        self._running: Dict[str, _Running] = {}
        self._driving: Optional[_Driving] = None
        self._blocked_until_s: Dict[str, float] = {}
        self._moves_people = people is None
        self._people = people or People(plan, self.floor, seed=seed)
        self._outcomes: List[Outcome] = []
        self._seed = seed
        self.base = self._base_at(state.robot.pose)

    def _base_at(self, pose: Pose) -> DifferentialBase:
        return DifferentialBase(pose=pose, is_free=lambda x, y: self.floor.is_free(self._state, x, y), seed=self._seed)

    def start_anew(self, state: State) -> None:
        """Everything is as a state says, at the time that it is now. What runs is preempted, and nobody has habits."""
        self.preempt()
        self._state = replace(state, time_s=self._state.time_s)
        self._blocked_until_s = {}
        self._people = People(replace(self.plan, habits={}), self.floor, seed=self._seed)
        self.base = self._base_at(state.robot.pose)

    @property
    def people(self) -> People:
        """Whoever moves the persons."""
        return self._people

    def adopt(self, state: State) -> None:
        """Take over what another robot of the home, or the persons, have changed."""
        self._state = state

    @property
    def state(self) -> State:
        """What is now. A value: it does not change later."""
        return self._state

    @property
    def scene(self) -> Scene:
        """What preconditions look at."""
        return Scene(self.plan, self.floor, self._state)

    def set_charge(self, charge: float) -> None:
        """Set the charge of the robot's battery, 0 to 1."""
        self._state = self._state.with_robot(battery=charge)

    @property
    def is_busy(self) -> bool:
        """Whether an action runs."""
        return bool(self._running) or self._driving is not None

    def begin(self, action: Action) -> Optional[Failure]:
        """Begin an action.

        Returns:
            why it cannot be done; None when it has begun. Its end is one of :meth:`outcomes`
        """
        if action.kind in DRIVING:
            return self._begin_driving(action)
        rule = RULES.get(action.kind)
        if rule is None:
            return Failure("unknown", f"I cannot {action.kind}.")
        taken = {part for running in self._running.values() for part in RULES[running.action.kind].occupies}
        if self._driving is not None:
            taken.add("base")
        if taken.intersection(rule.occupies) or action.kind in self._running:
            return Failure("busy", "I am busy with something else.")
        failure = rule.check(self.scene, action)
        if failure is None:
            self._running[action.kind] = _Running(action)
        return failure

    def preempt(self, kind: str = "") -> None:
        """End the action of a kind, or all. What had its effect keeps it; the rest leaves no trace."""
        if self._driving is not None and kind in ("", self._driving.action.kind):
            self._end(self._driving.action, is_preempted=True)
            self._driving = None
            self.base.command(STANDING)
        for name in [name for name in self._running if kind in ("", name)]:
            self._end(self._running.pop(name).action, is_preempted=True)

    def outcomes(self) -> Tuple[Outcome, ...]:
        """Return the actions that ended since the last call."""
        ended, self._outcomes = tuple(self._outcomes), []
        return ended

    def perform(self, action: Action, *, step_s: float = 0.1, most_s: float = 600.0) -> Outcome:
        """Do an action to its end; for callers without a clock."""
        failure = self.begin(action)
        if failure is not None:
            return Outcome(action, failure)
        for _ in range(round(most_s / step_s)):
            self.step(step_s)
            for outcome in self.outcomes():
                if outcome.action is action:
                    return outcome
        self.preempt(action.kind)
        return Outcome(action, Failure("blocked", f"I could not {action.kind} in {most_s:g} s."))

    def drive(self, velocity: Velocity) -> None:
        """Take a velocity command, as the base does. It is ignored while an action drives the base."""
        if self._driving is None:
            self.base.command(velocity)

    def say(self, who: str, text: str) -> Tuple[str, ...]:
        """Somebody says something.

        Returns:
            ids of those who hear it: near enough, with no wall and no closed door in between
        """
        mouth = self.plan.position(self._state, who)
        listeners = [*self._state.people, ROBOT]
        heard = tuple(
            one for one in listeners if one != who and self._is_heard(mouth, self.plan.position(self._state, one))
        )
        self._state = self._state.with_event("said", who, text, heard)
        if who == ROBOT:
            for person in heard:
                if self.plan.entities[person].kind != "person":
                    continue
                self._state, reply = self._people.hear(self._state, person, text)
                if reply:
                    self.say(person, reply)
        return heard

    def _is_heard(self, mouth: Point, ear: Point) -> bool:
        distance_m = math.hypot(mouth[0] - ear[0], mouth[1] - ear[1])
        is_same_room = self.plan.room_at(mouth) == self.plan.room_at(ear)
        return distance_m <= EARSHOT_M and (is_same_room or self.floor.sees(self._state, mouth, ear))

    def tell_person(self, person: str, order: str, target: str = "") -> Optional[Failure]:
        """A person does something: stand, sit, walk (to a target), follow (somebody), take or put down (a thing).

        Returns:
            why it cannot be done; None when it is done or begun
        """
        changed = self._people.order(self._state, person, order, target)
        if isinstance(changed, Failure):
            return changed
        self._state = changed
        return None

    def change(self, *, reason: str, **values: Dict[str, object]) -> None:
        """Set properties of entities from outside, as a test or a fault does: `change(reason="test", mug_1={...})`."""
        for entity, properties in values.items():
            if entity not in self.plan.entities:
                raise KeyError(f"{reason}: there is no {entity}")
            self._state = self._state.with_property(entity, **properties)  # type: ignore[arg-type]

    def step(self, duration_s: float) -> None:
        """Advance the time.

        Args:
            duration_s: finite and not negative
        """
        if not (math.isfinite(duration_s) and duration_s >= 0.0):
            raise ValueError(f"duration_s must be a finite number and not negative, got {duration_s!r}")
        pieces = max(1, math.ceil(duration_s / self.MAX_STEP_S - 1e-9))
        for _ in range(pieces):
            self._step(duration_s / pieces)

    def _step(self, duration_s: float) -> None:
        self._state = replace(self._state, time_s=self._state.time_s + duration_s)
        if self._driving is not None:
            self._drive(self._driving, duration_s)
        self.base.step(duration_s)
        if self.base.pose != self._state.robot.pose:
            is_off = (
                self._state.robot.is_docked
                and math.hypot(
                    self.base.pose.x_m - self._state.robot.pose.x_m, self.base.pose.y_m - self._state.robot.pose.y_m
                )
                > 1e-4
            )
            changes: Dict[str, object] = {"pose": self.base.pose, "looks_at": ""}
            if is_off:
                changes["is_docked"] = False
            self._state = self._state.with_robot(**changes)
            if self._driving is not None and self._driving.action.kind == "tow":
                point = self.plan.position(self._state, ROBOT)
                room = self.plan.room_at(point)
                if room:
                    self._state = self._state.with_place(self._driving.action.theme, Place("on", room, *point))
        for kind in list(self._running):
            self._advance(kind, self._running[kind], duration_s)
        if self._state.robot.is_docked and self._state.robot.battery < 1.0:
            self._state = self._state.with_robot(battery=min(1.0, self._state.robot.battery + duration_s / 600.0))
        if self._moves_people:
            self._state = self._people.step(self._state, duration_s)
        self._unblock()

    def _advance(self, kind: str, running: _Running, duration_s: float) -> None:
        running.elapsed_s += duration_s
        action = running.action
        rule = RULES[kind]
        if not running.has_effect and running.elapsed_s >= running.before_s - 1e-9:
            # Somebody may have taken the thing, or closed the door, since the action began.
            failure = rule.check(self.scene, action) or self._slip(action)
            if failure is not None:
                del self._running[kind]
                self._end(action, failure)
                return
            self._state = rule.effect(self.scene, action)
            running.has_effect = True
        if running.elapsed_s >= running.total_s - 1e-9:
            del self._running[kind]
            self._end(action)

    def _slip(self, action: Action) -> Optional[Failure]:
        if action.kind not in ("grasp", "put", "give", "receive") or self._random.random() >= self.faults.slip:
            return None
        room = self.plan.room_at(self.plan.position(self._state, ROBOT))
        entity = self.plan.entities[action.theme]
        if action.kind != "grasp":
            self._state = self._state.with_place(
                action.theme, Place("on", room, *self.plan.position(self._state, ROBOT))
            )
        return Failure("slipped", f"{entity.the_name.capitalize()} slipped out of my hand.", action.theme)

    def _end(self, action: Action, failure: Optional[Failure] = None, *, is_preempted: bool = False) -> None:
        self._outcomes.append(Outcome(action, failure, is_preempted))

    def _begin_driving(self, action: Action) -> Optional[Failure]:
        if self._driving is not None or any("base" in RULES[kind].occupies for kind in self._running):
            return Failure("busy", "I am driving already.")
        target = action.goal
        if target and target not in self.plan.entities:
            return Failure("unknown", f"There is no {target}.")
        start = self.plan.position(self._state, ROBOT)
        if action.kind == "tow":
            failure = check_push(self.scene, replace(action, goal=""))
            if failure is not None:
                return failure
        if action.kind == "face":
            self._driving = _Driving(action, [start], self._heading(target, start, [start]))
            return None
        without = self.floor.borders(action.avoided.split())
        try:
            reach_m = self.plan.robot.reach_m - _SPARE_M if math.isnan(action.amount) else action.amount
            if target:
                goal = self.floor.place_to_stand(self._state, target, reach_m=reach_m, without=without)
            else:
                goal = _point_of(action.value)
            corners = self.floor.way(self._state, start, goal, without=without)
        except Closed as closed:
            return Failure("closed", str(closed), closed.door)
        except (NoPath, ValueError) as error:
            if not without:
                return Failure("no_way", f"I cannot get there: {error}.")
            avoided = " and ".join(self.plan.entities[one].the_name for one in action.avoided.split())
            return Failure("no_way", f"I know no way there that avoids {avoided}.")
        self._driving = _Driving(action, corners, self._heading(target, goal, corners))
        return None

    def _heading(self, target: str, goal: Point, corners: List[Point]) -> float:
        entity = self.plan.entities.get(target)
        if entity is None or entity.kind == "room":
            before = corners[-2] if len(corners) > 1 else goal
            if before == goal:
                return wrap(self._state.robot.pose.yaw_rad)
            return math.atan2(goal[1] - before[1], goal[0] - before[0])
        at = self.plan.position(self._state, target)
        return math.atan2(at[1] - goal[1], at[0] - goal[0])

    def _drive(self, driving: _Driving, duration_s: float) -> None:
        pose = self.base.pose
        for door in self._doors_near(driving, pose):
            if door not in driving.doors_met:
                driving.doors_met.append(door)
                if self._random.random() < self.faults.blocked_door:
                    self._state = self._state.with_property(door, is_blocked=True)
                    self._blocked_until_s[door] = self._state.time_s + BLOCKED_S
        velocity = driving.follower.command(pose)
        if velocity is None:
            self.base.command(STANDING)
            self._finish_driving(driving, None)
            return
        moved = abs(pose.x_m - driving.last.x_m) + abs(pose.y_m - driving.last.y_m)
        is_still = moved < 1e-3 * duration_s and abs(pose.yaw_rad - driving.last.yaw_rad) < 1e-2 * duration_s
        driving.still_s = driving.still_s + duration_s if is_still else 0.0
        driving.last = pose
        blocked = next(
            (door for door in self._doors_near(driving, pose) if door in self.floor.closed_doors(self._state)), ""
        )
        if blocked or driving.still_s > _STUCK_S:
            self.base.command(STANDING)
            entity = self.plan.entities.get(blocked)
            how = "blocked" if blocked and self._state.is_(blocked, "is_blocked") else "closed"
            sentence = f"{entity.the_name.capitalize()} is {how}." if entity else "Something is in my way."
            self._finish_driving(driving, Failure("blocked", sentence, blocked))
            return
        self.base.command(velocity)

    def _doors_near(self, driving: _Driving, pose: Pose) -> Tuple[str, ...]:
        """Return the doors that the robot is about to go through."""
        point = pose.x_m, pose.y_m
        near = [
            door
            for door in self.plan.of_kind("door")
            if "closable" in door.traits and 0.2 < door.distance_m(point) < _DOOR_M
        ]
        corners = (point, *driving.follower.corners_ahead) if near else ()
        ways = list(zip(corners, corners[1:]))
        return tuple(door.id for door in near if any(self.floor.leads_through(door.id, *way) for way in ways))

    def _finish_driving(self, driving: _Driving, failure: Optional[Failure]) -> None:
        self._driving = None
        if driving.action.kind == "tow" and failure is None:
            failure = check_push(self.scene, driving.action)
            if failure is None:
                self._state = effect_push(self.scene, driving.action)
        self._end(driving.action, failure)

    def _unblock(self) -> None:
        if not self._blocked_until_s:
            return
        for door, until_s in list(self._blocked_until_s.items()):
            if self._state.time_s >= until_s:
                del self._blocked_until_s[door]
                self._state = self._state.with_property(door, is_blocked=False)


def _point_of(words: str) -> Point:
    """Read "1.5 -2"."""
    numbers: Iterable[float] = map(float, words.split())
    x_m, y_m = numbers
    return x_m, y_m
