"""Several robots in one home: each acts in a home of its own, and what it changes is so for all of them.

To each robot the others are there as persons are: it sees them and hears them, and they are where they are.
"""

import contextlib
from dataclasses import dataclass, replace
from typing import Dict, Iterator, Mapping, Optional, Sequence, Tuple

from roboframenet_sim.base import Pose
from roboframenet_sim.home_engine import Home
from roboframenet_sim.home_state import (
    NO_FAULTS,
    ROBOT,
    Entity,
    Event,
    Faults,
    PersonState,
    Place,
    Plan,
    RobotLimits,
    RobotState,
    State,
)

#: Of what happened, so much is told to each robot again.
_EVENTS = 20


@dataclass(frozen=True)
class Member:
    """A robot of a home.

    Attributes:
        id: unique in the home; the only robot of a home is :data:`ROBOT`
        name: as people call it
        limits: what it can do
        start: its first pose; None for the one of the home file
    """

    id: str
    name: str
    limits: RobotLimits
    start: Optional[Pose] = None


class Company:
    """The robots of a home, and the home.

    Args:
        plan, state: of the home
        members: the robots; the first one counts where somebody asks for "the robot"
        seed: of persons and faults
        faults: how often something goes wrong
    """

    def __init__(
        self, plan: Plan, state: State, members: Sequence[Member], *, seed: int = 0, faults: Faults = NO_FAULTS
    ) -> None:
        self._is_alone = len(members) == 1
        bodies = {one.id: Entity(one.id, "robot", (one.name,), category="robot", height_m=0.5) for one in members}
        starts = {one.id: one.start or state.robot.pose for one in members}
        others = {name: PersonState(pose) for name, pose in starts.items()}
        #: What is so for all: robots are among the people, and hold things by their ids.
        self._common = replace(state, people={**state.people, **others})
        self._robots: Dict[str, RobotState] = {name: replace(state.robot, pose=pose) for name, pose in starts.items()}
        self.homes: Dict[str, Home] = {}
        host: Optional[Home] = None
        for index, one in enumerate(members):
            entities = {**plan.entities, **{name: body for name, body in bodies.items() if name != one.id}}
            mine = replace(plan, entities=entities, robot=one.limits)
            view = state if self._is_alone else self._view(one.id)
            home = Home(mine, view, seed=seed + index, faults=faults, people=host.people if host is not None else None)
            host = host or home
            self.homes[one.id] = home

    @contextlib.contextmanager
    def acting(self, name: str) -> Iterator[Home]:
        """Let a robot act: it finds the home as it is, and what it changes is so for all."""
        home = self.homes[name]
        if self._is_alone:
            yield home
            return
        view = self._view(name)
        home.adopt(view)
        yield home
        self._take(name, home.state, len(view.events))

    def step(self, duration_s: float) -> None:
        """Advance the time."""
        for name in self.homes:
            with self.acting(name) as home:
                home.step(duration_s)

    def _view(self, name: str) -> State:
        """Return the state as a robot finds it."""
        common = self._common
        return replace(
            common,
            robot=self._robots[name],
            places=_held(common, name, ROBOT),
            people=_people(common.people, name, ROBOT, without=name),
            events=tuple(_event(one, name, ROBOT) for one in common.events[-_EVENTS:]),
            time_s=self.homes[name].state.time_s if name in self.homes else common.time_s,
        )

    def _take(self, name: str, state: State, known: int) -> None:
        """Take over what a robot has changed.

        Args:
            name: of the robot
            state: as it left it
            known: number of events that it was told of
        """
        moved = state.robot.pose != self._robots[name].pose
        me = PersonState(state.robot.pose, "walking" if moved else "standing")
        events = (*self._common.events, *(_event(one, ROBOT, name) for one in state.events[known:]))
        self._robots[name] = state.robot
        self._common = replace(
            state,
            places=_held(state, ROBOT, name),
            people={**_people(state.people, ROBOT, name, without=ROBOT), name: me},
            events=events[-State.MOST_EVENTS :],
        )


def _held(state: State, name: str, other: str) -> Dict[str, Place]:
    return {
        thing: replace(place, holder=other) if place.holder == name else place for thing, place in state.places.items()
    }


def _people(people: Mapping[str, PersonState], name: str, other: str, *, without: str) -> Dict[str, PersonState]:
    return {
        person: replace(now, follows=other) if now.follows == name else now
        for person, now in people.items()
        if person != without
    }


def _event(event: Event, name: str, other: str) -> Event:
    to: Tuple[str, ...] = tuple(other if one == name else one for one in event.to)
    return replace(event, who=other if event.who == name else event.who, to=to)
