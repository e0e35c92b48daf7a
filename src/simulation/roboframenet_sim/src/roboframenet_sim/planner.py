"""Plans the shortest path on an occupancy grid: A*, then only the necessary corners."""

import heapq
import math
from typing import Dict, List, Sequence, Tuple

import numpy as np

from roboframenet_sim.occupancy_grid import Cell, OccupancyGrid

Point = Tuple[float, float]
"""x and y in metres."""

STEPS = [(down, right, math.hypot(down, right)) for down in (-1, 0, 1) for right in (-1, 0, 1) if down or right]


class NoPath(Exception):
    """There is no path; the message is the reason, for a person."""


def nearest_free_cell(grid: OccupancyGrid, *, near: Cell, reach_m: float) -> Cell:
    """Return the free cell nearest to a cell.

    Raises:
        NoPath: no free cell is within reach
    """
    if grid.is_cell_free(near):
        return near
    free = np.argwhere(~grid.is_taken)
    if len(free):
        distances = np.hypot(free[:, 0] - near[0], free[:, 1] - near[1])
        best = int(distances.argmin())
        if distances[best] * grid.resolution_m <= reach_m:
            return int(free[best, 0]), int(free[best, 1])
    raise NoPath(f"the robot stands in an obstacle, with no free floor within {reach_m:g} m")


def _search(grid: OccupancyGrid, *, start: Cell, goal: Cell) -> List[Cell]:
    def guess(cell: Cell) -> float:
        down, right = abs(cell[0] - goal[0]), abs(cell[1] - goal[1])
        return max(down, right) + (math.sqrt(2.0) - 1.0) * min(down, right)

    came_from: Dict[Cell, Cell] = {}
    cost: Dict[Cell, float] = {start: 0.0}
    done = set()
    queue = [(guess(start), start)]
    while queue:
        _, cell = heapq.heappop(queue)
        if cell == goal:
            path = [cell]
            while cell in came_from:
                cell = came_from[cell]
                path.append(cell)
            return path[::-1]
        if cell in done:
            continue
        done.add(cell)
        for down, right, length in STEPS:
            beside = (cell[0] + down, cell[1] + right)
            if beside in done or not grid.is_cell_free(beside):
                continue
            # A diagonal step must not cut a corner.
            if (
                down
                and right
                and not (grid.is_cell_free((cell[0] + down, cell[1])) and grid.is_cell_free((cell[0], cell[1] + right)))
            ):
                continue
            new_cost = cost[cell] + length
            if new_cost < cost.get(beside, math.inf):
                cost[beside] = new_cost
                came_from[beside] = cell
                heapq.heappush(queue, (new_cost + guess(beside), beside))
    raise NoPath("no path leads there: the robot or the goal is walled in")


def is_clear(grid: OccupancyGrid, begin: Point, end: Point) -> bool:
    """Whether the straight line between two points is free."""
    length_m = math.hypot(end[0] - begin[0], end[1] - begin[1])
    pieces = max(1, math.ceil(length_m / (grid.resolution_m / 4.0)))
    return all(
        grid.is_free(begin[0] + (end[0] - begin[0]) * index / pieces, begin[1] + (end[1] - begin[1]) * index / pieces)
        for index in range(pieces + 1)
    )


def _straighten(grid: OccupancyGrid, points: Sequence[Point]) -> List[Point]:
    corners = [points[0]]
    index = 0
    while index < len(points) - 1:
        # Find the farthest visible point. Visibility is not monotonic, so walk outwards instead of bisecting.
        farthest = index + 1
        for ahead in range(index + 2, len(points)):
            if is_clear(grid, points[index], points[ahead]):
                farthest = ahead
            elif ahead - farthest > 40:
                break
        corners.append(points[farthest])
        index = farthest
    return corners


def plan(grid: OccupancyGrid, *, start: Point, goal: Point, escape_m: float = 0.3) -> List[Point]:
    """Return a short path as the corners of a polyline, from the start to the goal.

    Args:
        grid: already inflated by the radius of the robot
        start: position of the robot; it may be slightly too near to an obstacle
        goal: position to reach
        escape_m: largest distance from the free floor of a robot that is too near to an obstacle
    Raises:
        NoPath: the goal is occupied or outside the map, or walls are in between
    """
    if not all(math.isfinite(number) for number in (*start, *goal)):
        raise NoPath("the start or the goal is not finite")
    goal_cell = grid.cell_of(*goal)
    if not grid.is_cell_free(goal_cell):
        raise NoPath("at x {:.2f}, y {:.2f} the robot would stand in an obstacle or outside the map".format(*goal))
    start_cell = nearest_free_cell(grid, near=grid.cell_of(*start), reach_m=escape_m)
    cells = _search(grid, start=start_cell, goal=goal_cell)
    points = [grid.centre_of(cell) for cell in cells[1:-1]] + [goal]
    first = start if grid.is_free(*start) else grid.centre_of(start_cell)
    corners = _straighten(grid, [first] + points)
    return corners if first == start else [start] + corners
