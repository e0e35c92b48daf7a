"""Planning and path following on small grids."""

import math
import random

import numpy as np
import pytest

from roboframenet_sim.base import DifferentialBase, Pose
from roboframenet_sim.home_floor import crosses, crosses_one
from roboframenet_sim.occupancy_grid import OccupancyGrid
from roboframenet_sim.path_following import FollowingLimits, PathFollower
from roboframenet_sim.planner import NoPath, is_clear, plan


def grid_of(picture):
    """Rows from north to south, '#' is taken; cells of one metre, the origin in the south-west corner."""
    rows = [list(line.strip()) for line in picture.strip().splitlines()]
    return OccupancyGrid(1.0, 0.0, 0.0, np.array(rows[::-1]) == "#")


WALL = grid_of("""
    .......
    ...#...
    ...#...
    ...#...
    .......
""")


def length(corners):
    return sum(math.hypot(b[0] - a[0], b[1] - a[1]) for a, b in zip(corners, corners[1:]))


def test_free_floor_is_crossed_in_a_straight_line():
    assert plan(grid_of("....\n....\n...."), start=(0.5, 0.5), goal=(3.2, 2.1)) == [(0.5, 0.5), (3.2, 2.1)]


def test_path_leads_round_a_wall():
    corners = plan(WALL, start=(0.5, 2.5), goal=(6.5, 2.5))
    assert corners[0] == (0.5, 2.5) and corners[-1] == (6.5, 2.5)
    assert all(is_clear(WALL, a, b) for a, b in zip(corners, corners[1:]))
    assert 6.5 < length(corners) < 8.5


def test_path_does_not_slip_between_diagonal_cells():
    with pytest.raises(NoPath, match="walled in"):
        plan(grid_of("..#\n.#.\n#.."), start=(0.5, 2.5), goal=(2.5, 0.5))


@pytest.mark.parametrize("picture", ["..#..\n..#..", ".###.\n.#.#.\n.###.".replace(".#.#.", ".#.##")])
def test_walls_between_are_no_path(picture):
    grid = grid_of(picture)
    goal = (4.5, 0.5) if grid.is_taken.shape[0] == 2 else (2.5, 1.5)
    with pytest.raises(NoPath, match="walled in"):
        plan(grid, start=(0.5, 0.5), goal=goal)


@pytest.mark.parametrize("goal", [(3.5, 2.5), (50.0, 1.0), (math.nan, 1.0)])
def test_goal_that_cannot_be_stood_on_is_no_path(goal):
    with pytest.raises(NoPath):
        plan(WALL, start=(0.5, 0.5), goal=goal)


def test_robot_that_stands_too_near_may_leave():
    corners = plan(WALL, start=(2.95, 2.5), goal=(0.5, 2.5), escape_m=1.0)
    assert corners[0] == (2.95, 2.5)
    assert plan(WALL, start=(3.1, 2.5), goal=(0.5, 2.5), escape_m=1.2)[-1] == (0.5, 2.5)
    with pytest.raises(NoPath, match="stands in an obstacle"):
        plan(WALL, start=(3.1, 2.5), goal=(0.5, 2.5), escape_m=0.1)


def test_start_is_the_goal():
    assert plan(WALL, start=(0.5, 0.5), goal=(0.5, 0.5))[-1] == (0.5, 0.5)


@pytest.mark.parametrize("yaw_rad", [0.0, 3.0, -1.5])
def test_follower_keeps_to_the_path_and_arrives(yaw_rad):
    corners = plan(WALL, start=(0.5, 2.5), goal=(6.5, 2.5))
    base = DifferentialBase(pose=Pose(0.5, 2.5, -2.0), is_free=WALL.is_free)
    follower = PathFollower(corners, yaw_rad=yaw_rad)
    for _ in range(5000):
        velocity = follower.command(base.pose)
        if velocity is None:
            break
        assert abs(velocity.linear_m_per_s) <= FollowingLimits.linear_m_per_s
        base.command(velocity)
        base.step(0.02)
    assert velocity is None
    assert (base.pose.x_m, base.pose.y_m) == (pytest.approx(6.5, abs=0.05), pytest.approx(2.5, abs=0.05))
    assert math.remainder(base.pose.yaw_rad - yaw_rad, 2 * math.pi) == pytest.approx(0.0, abs=0.05)


def test_follower_that_is_there_says_so():
    assert PathFollower([(1.0, 1.0)], yaw_rad=0.0).command(Pose(1.0, 1.0, 0.0)) is None


def test_limits_that_make_no_sense_are_refused():
    with pytest.raises(ValueError, match="goal_tolerance_m"):
        FollowingLimits(goal_tolerance_m=-1.0)


def test_a_line_crosses_one_wall_as_it_crosses_it_among_others() -> None:
    numbers = random.Random(5)
    found = []
    for _ in range(500):
        # Whole numbers: many lines touch an end, or are parallel.
        x1, y1, x2, y2, *wall = (float(numbers.randint(0, 4)) for _ in range(8))
        ends = (wall[0], wall[1], wall[2], wall[3])
        found.append(crosses_one((x1, y1), (x2, y2), ends))
        assert found[-1] == crosses((x1, y1), (x2, y2), np.array([ends])), (x1, y1, x2, y2, ends)
    assert 50 < sum(found) < 450
