"""The floor of a home: walls, ways and lines of sight."""

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Dict, FrozenSet, Iterable, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from roboframenet_sim.home_state import ROBOT, Entity, Plan, Point, State, Value
from roboframenet_sim.occupancy_grid import OccupancyGrid, grid_of_room
from roboframenet_sim.planner import NoPath, nearest_free_cell, plan
from roboframenet_sim.room import Box, Room

if TYPE_CHECKING:
    from numpy.typing import NDArray

Wall = Tuple[float, float, float, float]
RESOLUTION_M = 0.1
WALL_THICKNESS_M = 0.1
#: Radius of a person on the floor.
PERSON_RADIUS_M = 0.2
#: Height of the eyes of the robot; what is in an open drawer or fridge is recognised from near only.
NEAR_SIGHT_M = 1.8
#: Whoever stands too near to something, or sits on it, gets so far to the free floor.
ESCAPE_M = 1.2
#: Ways keep this distance more from what stands there than the base needs, so that it need not drive exactly.
_MARGIN_M = 0.08
#: So many floors with different closed doors are kept.
_MOST_GRIDS = 32


class Closed(NoPath):
    """The way leads through a closed door.

    Attributes:
        door: its id
    """

    def __init__(self, door: str, sentence: str) -> None:
        super().__init__(sentence)
        self.door = door


@dataclass(frozen=True)
class _Side:
    """A side of a room: along x at y = `at`, or the other way round."""

    is_along_x: bool
    at: float
    low: float
    high: float


def _is_on(door: Entity, side: _Side) -> bool:
    across, along = (door.y_m, door.x_m) if side.is_along_x else (door.x_m, door.y_m)
    is_near = all(abs(end - side.at) < 0.05 for end in across)
    return is_near and min(along) >= side.low - 1e-6 and max(along) <= side.high + 1e-6


def walls_of(plan: Plan) -> List[Wall]:
    """Return the sides of all rooms, with gaps where doors are."""
    walls: List[Wall] = []
    doors = list(plan.of_kind("door"))
    for room in plan.of_kind("room"):
        for side in (
            _Side(True, room.y_m[0], *room.x_m),
            _Side(True, room.y_m[1], *room.x_m),
            _Side(False, room.x_m[0], *room.y_m),
            _Side(False, room.x_m[1], *room.y_m),
        ):
            begin = side.low
            gaps = sorted(door.x_m if side.is_along_x else door.y_m for door in doors if _is_on(door, side))
            for low, high in [*gaps, (side.high, side.high)]:
                if low - begin > 1e-6:
                    walls.append((begin, side.at, low, side.at) if side.is_along_x else (side.at, begin, side.at, low))
                begin = max(begin, high)
    return walls


def crosses(begin: Point, end: Point, walls: "NDArray[np.float64]") -> bool:
    """Whether a line crosses one of the walls."""
    if not len(walls):
        return False
    dx, dy = end[0] - begin[0], end[1] - begin[1]
    wx, wy = walls[:, 2] - walls[:, 0], walls[:, 3] - walls[:, 1]
    ox, oy = walls[:, 0] - begin[0], walls[:, 1] - begin[1]
    cross = dx * wy - dy * wx
    with np.errstate(divide="ignore", invalid="ignore"):
        along = (ox * wy - oy * wx) / cross
        on_wall = (ox * dy - oy * dx) / cross
    return bool(np.any((np.abs(cross) > 1e-12) & (along > 1e-6) & (along < 1 - 1e-6) & (on_wall >= 0) & (on_wall <= 1)))


def crosses_one(begin: Point, end: Point, wall: Wall) -> bool:
    """Whether a line crosses a wall: the same as `crosses`, without arrays for a single wall."""
    dx, dy = end[0] - begin[0], end[1] - begin[1]
    wx, wy = wall[2] - wall[0], wall[3] - wall[1]
    ox, oy = wall[0] - begin[0], wall[1] - begin[1]
    cross = dx * wy - dy * wx
    if abs(cross) <= 1e-12:
        return False
    return 1e-6 < (ox * wy - oy * wx) / cross < 1 - 1e-6 and 0 <= (ox * dy - oy * dx) / cross <= 1


class Floor:
    """The geometry of a plan, with what is worked out of it once.

    Args:
        plan: of the home
    """

    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        rooms = list(plan.of_kind("room"))
        self._x_m = min(r.x_m[0] for r in rooms) - 0.2, max(r.x_m[1] for r in rooms) + 0.2
        self._y_m = min(r.y_m[0] for r in rooms) - 0.2, max(r.y_m[1] for r in rooms) + 0.2
        self._walls = walls_of(plan)
        self._grids: Dict[Tuple[FrozenSet[str], float], OccupancyGrid] = {}
        self._sights: Dict[FrozenSet[str], NDArray[np.float64]] = {}
        self._doors = tuple(door for door in plan.of_kind("door") if "open" not in door.traits)
        self._closed: Tuple[Optional[Mapping[str, Mapping[str, Value]]], FrozenSet[str]] = (None, frozenset())
        tall = [entity for entity in plan.of_kind("furniture") if entity.is_tall]
        #: The diagonals of tall furniture, two a piece, and whose they are.
        self._tall_ids = tuple(entity.id for entity in tall for _ in range(2))
        self._tall = np.array(
            [
                diagonal
                for entity in tall
                for diagonal in (
                    (entity.x_m[0], entity.y_m[0], entity.x_m[1], entity.y_m[1]),
                    (entity.x_m[0], entity.y_m[1], entity.x_m[1], entity.y_m[0]),
                )
            ]
        ).reshape(-1, 4)

    def closed_doors(self, state: State) -> FrozenSet[str]:
        """Return the ids of the doors that nobody gets through."""
        # Each step of the simulation asks, and the properties of a state never change.
        properties, closed = self._closed
        if state.properties is not properties:
            closed = frozenset(
                door.id for door in self._doors if not state.is_(door.id, "is_open") or state.is_(door.id, "is_blocked")
            )
            self._closed = state.properties, closed
        return closed

    def grid(self, closed: FrozenSet[str], radius_m: float) -> OccupancyGrid:
        """Return the floor that a round robot or person can use."""
        key = (closed, radius_m)
        if key not in self._grids:
            if len(self._grids) >= _MOST_GRIDS:
                self._grids.pop(next(iter(self._grids)))
            room = Room(
                resolution_m=RESOLUTION_M,
                wall_thickness_m=WALL_THICKNESS_M,
                x_m=self._x_m,
                y_m=self._y_m,
                walls=(*self._walls, *map(self._leaf, sorted(closed))),
                boxes=tuple(
                    Box(entity.id, entity.x_m, entity.y_m)
                    for entity in self._plan.of_kind("furniture")
                    if "flat" not in entity.traits
                ),
            )
            self._grids[key] = grid_of_room(room).inflated(radius_m)
        return self._grids[key]

    def _leaf(self, door: str) -> Wall:
        entity = self._plan.entities[door]
        return entity.x_m[0], entity.y_m[0], entity.x_m[1], entity.y_m[1]

    def is_free(self, state: State, x_m: float, y_m: float) -> bool:
        """Whether the middle of the robot may be at a point."""
        return self.grid(self.closed_doors(state), self._plan.robot.radius_m - _MARGIN_M).is_free(x_m, y_m)

    def borders(self, avoided: Iterable[str]) -> FrozenSet[str]:
        """Return the doors and passages through which no way leads that avoids some rooms and doors."""
        unwanted = frozenset(avoided)
        return frozenset(
            door.id for door in self._plan.of_kind("door") if door.id in unwanted or unwanted.intersection(door.rooms)
        )

    def way(
        self,
        state: State,
        start: Point,
        goal: Point,
        *,
        is_person: bool = False,
        without: FrozenSet[str] = frozenset(),
    ) -> List[Point]:
        """Return the corners of a short way.

        Args:
            state: which doors are closed; a person opens those that are not locked
            start: of the way
            goal: its end
            is_person: who goes
            without: doors and passages that it does not lead through, see :meth:`borders`
        Raises:
            Closed: only a closed door is in the way
            NoPath: there is no way
        """
        closed = self.closed_doors(state)
        radius_m = PERSON_RADIUS_M if is_person else self._plan.robot.radius_m
        if is_person:
            closed = frozenset(door for door in closed if state.is_(door, "is_locked"))
        try:
            return plan(self.grid(closed | without, radius_m), start=start, goal=goal, escape_m=ESCAPE_M)
        except NoPath:
            if not closed - without:
                raise
        corners = plan(self.grid(without, radius_m), start=start, goal=goal, escape_m=ESCAPE_M)
        for begin, end in zip(corners, corners[1:]):
            crossed = [door for door in sorted(closed) if self.leads_through(door, begin, end)]
            if crossed:
                first = min(crossed, key=lambda door: self._plan.entities[door].distance_m(begin))
                entity = self._plan.entities[first]
                how = "blocked" if state.is_(first, "is_blocked") else "closed"
                raise Closed(first, f"{entity.the_name.capitalize()} is {how}.")
        raise NoPath("there is no way to that place")

    def leads_through(self, door: str, begin: Point, end: Point) -> bool:
        """Whether a straight line leads through a door."""
        return crosses_one(begin, end, self._leaf(door))

    def place_to_stand(
        self,
        state: State,
        target: str,
        *,
        reach_m: float,
        start: Optional[Point] = None,
        is_person: bool = False,
        without: FrozenSet[str] = frozenset(),
    ) -> Point:
        """Return a free point beside an entity from which it can be reached.

        Args:
            state: of the home
            target: id of an entity
            reach_m: largest distance from the entity
            start: where to come from; None: where the robot is
            is_person: who will stand there
            without: doors and passages that the way there does not lead through
        Raises:
            NoPath: there is none
        """
        entity = self._plan.entities.get(target)
        closed = self.closed_doors(state) | without
        grid = self.grid(closed, PERSON_RADIUS_M if is_person else self._plan.robot.radius_m)
        rows, columns = np.nonzero(~grid.is_taken)
        x = grid.origin_x_m + (columns + 0.5) * grid.resolution_m
        y = grid.origin_y_m + (rows + 0.5) * grid.resolution_m
        begin = start or self._plan.position(state, ROBOT)
        can_get_there = self._is_connected(without, begin, is_person=is_person)[rows, columns]
        is_on_this_side = self._is_connected(closed, begin, is_person=is_person)[rows, columns]
        if entity is not None and entity.kind == "room":
            centre = entity.centre
            inside = (
                can_get_there & (x > entity.x_m[0]) & (x < entity.x_m[1]) & (y > entity.y_m[0]) & (y < entity.y_m[1])
            )
            return self._best(x[inside], y[inside], np.hypot(x[inside] - centre[0], y[inside] - centre[1]), entity)
        if entity is not None and entity.kind in ("furniture", "door"):
            low_x, high_x = sorted(entity.x_m)
            low_y, high_y = sorted(entity.y_m)
            away = np.hypot(
                np.maximum(np.maximum(low_x - x, x - high_x), 0.0), np.maximum(np.maximum(low_y - y, y - high_y), 0.0)
            )
        else:
            point = self._plan.position(state, target)
            away = np.hypot(x - point[0], y - point[1])
        near = (away <= reach_m) & can_get_there
        if entity is not None and entity.kind == "door":
            # The leaf needs room to swing, and the robot room to turn.
            near &= away >= min(0.5, reach_m / 2.0)
        elif target == ROBOT or target in state.people:
            near &= away >= min(0.6, reach_m / 2.0)
        x, y, away, is_on_this_side = x[near], y[near], away[near], is_on_this_side[near]
        here_m = np.hypot(x - begin[0], y - begin[1])
        is_door = entity is not None and entity.kind == "door"
        # A way without a closed door is preferred, and the near side of a door.
        cost = (here_m if is_door else np.round(away, 1) + 0.05 * here_m) + 100.0 * ~is_on_this_side
        order = np.argsort(cost, kind="stable")
        for index in order[:400]:
            point = (float(x[index]), float(y[index]))
            if self.can_reach_past_walls(state, point, target):
                return point
        name = entity.the_name if entity else "it"
        raise NoPath(f"there is no free place beside {name}")

    def _is_connected(self, closed: FrozenSet[str], start: Point, *, is_person: bool) -> "NDArray[np.bool_]":
        """Return the cells to which a way leads when these doors are closed."""
        radius_m = PERSON_RADIUS_M if is_person else self._plan.robot.radius_m
        grid = self.grid(closed, radius_m)
        try:
            cell = nearest_free_cell(grid, near=grid.cell_of(*start), reach_m=ESCAPE_M)
        except NoPath:
            return np.asarray(~grid.is_taken)
        return np.asarray(grid.parts == grid.parts[cell])

    @staticmethod
    def _best(x: "NDArray[np.float64]", y: "NDArray[np.float64]", cost: "NDArray[np.float64]", entity: Entity) -> Point:
        if not len(x):
            raise NoPath(f"there is no free place in {entity.the_name}")
        best = int(cost.argmin())
        return float(x[best]), float(y[best])

    def can_reach_past_walls(self, state: State, point: Point, target: str) -> bool:
        """Whether no wall and no closed door is between a point and an entity."""
        entity = self._plan.entities.get(target)
        if entity is not None and entity.kind == "door":
            return True
        walls = self._walls_seen(self.closed_doors(state))
        if entity is not None and entity.kind == "furniture":
            # The nearest point of its extent, a little inside.
            end = tuple(
                min(max(value, low + 0.02), high - 0.02) for value, (low, high) in zip(point, (entity.x_m, entity.y_m))
            )
            return not crosses(point, (end[0], end[1]), walls)
        return not crosses(point, self._plan.position(state, target), walls)

    def _walls_seen(self, closed: FrozenSet[str]) -> "NDArray[np.float64]":
        if closed not in self._sights:
            if len(self._sights) >= _MOST_GRIDS:
                self._sights.pop(next(iter(self._sights)))
            self._sights[closed] = np.array([*self._walls, *map(self._leaf, sorted(closed))], dtype=float)
        return self._sights[closed]

    def outlines(self, state: State) -> "NDArray[np.float64]":
        """Return what a laser meets: walls, closed doors and the sides of furniture; x and y of both ends of each."""
        sides = [
            side
            for entity in self._plan.of_kind("furniture")
            if "flat" not in entity.traits
            for (low_x, high_x), (low_y, high_y) in ((entity.x_m, entity.y_m),)
            for side in (
                (low_x, low_y, high_x, low_y),
                (high_x, low_y, high_x, high_y),
                (high_x, high_y, low_x, high_y),
                (low_x, high_y, low_x, low_y),
            )
        ]
        return np.vstack([self._walls_seen(self.closed_doors(state)), np.array(sides, dtype=float).reshape(-1, 4)])

    def sees(self, state: State, begin: Point, end: Point, *, but: Sequence[str] = ()) -> bool:
        """Whether the line between two points meets no wall, closed door or tall furniture.

        Args:
            state: of the home
            begin: of the line
            end: of the line
            but: ids of tall furniture that does not count, because the end is in or on it
        """
        if crosses(begin, end, self._walls_seen(self.closed_doors(state))):
            return False
        tall = self._tall
        if any(ident in but for ident in self._tall_ids):
            tall = tall[[ident not in but for ident in self._tall_ids]]
        return not crosses(begin, end, tall)

    def sight_of(self, state: State) -> Tuple[object, ...]:
        """Return all of a state on which it depends what the robot sees, and how."""
        robot = replace(state.robot, battery=0.0)
        return (robot, self._sees_all_round(state), state.places, state.people, state.properties)

    @staticmethod
    def _sees_all_round(state: State) -> bool:
        return state.time_s - state.robot.scanned_s <= 1.0

    def visible(self, state: State, *, eyes: str = ROBOT) -> Tuple[str, ...]:
        """Return the ids of what the robot, or a person, sees now.

        Things in closed furniture or closed things are hidden, those in open ones are seen from near. The room where
        the eyes are is seen.
        """
        limits = self._plan.robot
        begin = self._plan.position(state, eyes)
        yaw_rad = state.robot.pose.yaw_rad if eyes == ROBOT else state.people[eyes].pose.yaw_rad
        is_all_round = eyes == ROBOT and self._sees_all_round(state)
        if eyes == ROBOT and state.robot.looks_at and not is_all_round:
            at = self._plan.position(state, state.robot.looks_at)
            yaw_rad = math.atan2(at[1] - begin[1], at[0] - begin[0])
        seen: List[str] = []
        here = self._plan.room_at(begin)
        if here:
            seen.append(here)
        for entity in self._plan.entities.values():
            if entity.kind == "room" or entity.id == eyes:
                continue
            end = self._plan.position(state, entity.id)
            distance_m = math.hypot(end[0] - begin[0], end[1] - begin[1])
            is_thing = entity.kind == "thing"
            if distance_m > (limits.sight_m if is_thing else limits.person_sight_m):
                continue
            if distance_m > 0.5 and not is_all_round:
                off = math.remainder(math.atan2(end[1] - begin[1], end[0] - begin[0]) - yaw_rad, 2.0 * math.pi)
                if abs(off) > limits.view_rad / 2.0:
                    continue
            if entity.kind == "door":
                # A door is part of a wall: its near side counts.
                end = (end[0] + 0.1 * (begin[0] - end[0]), end[1] + 0.1 * (begin[1] - end[1]))
            but = [entity.id]
            if is_thing:
                places = self._plan.holders(state, entity.id)
                if any(self.is_hidden_in(state, place.holder, place.relation) for place in places):
                    continue
                if any(place.relation in ("in", "under", "behind") for place in places) and distance_m > NEAR_SIGHT_M:
                    continue
                but += [place.holder for place in places]
            if self.sees(state, begin, end, but=but):
                seen.append(entity.id)
        return tuple(seen)

    def is_hidden_in(self, state: State, holder: str, relation: str) -> bool:
        """Whether what is so placed is hidden because its holder is closed."""
        entity = self._plan.entities.get(holder)
        if entity is None or relation != "in" or "closable" not in entity.traits:
            return False
        return not state.is_(holder, "is_open")
