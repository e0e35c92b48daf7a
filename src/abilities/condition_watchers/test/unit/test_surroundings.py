"""What a laser shows, in the simulated room, and the conditions on it."""

import math
from typing import Sequence

import numpy as np
import pytest

from condition_watchers.laser import Scan
from condition_watchers.surroundings import Surroundings, frames
from roboframenet_sim.base import Pose
from roboframenet_sim.laser import angles, scan
from roboframenet_sim.point_cloud import Cylinder
from typed_arguments import Measure, TypedArgument

RAYS = angles(181)
WALL = (2.0, -3.0, 2.0, 3.0)


def scan_of(*walls: Sequence[float], persons: Sequence[Cylinder] = (), x_m: float = 0.0, yaw_rad: float = 0.0) -> Scan:
    pose = Pose(x_m=x_m, y_m=0.0, yaw_rad=yaw_rad)
    ranges = scan(pose, RAYS, walls=np.array(walls, dtype=float).reshape(-1, 4), cylinders=persons)
    return Scan(ranges.tolist(), first_rad=float(RAYS[0]), step_rad=float(RAYS[1] - RAYS[0]), least_m=0.05, most_m=8.0)


def person(x_m: float, y_m: float = 0.0) -> Cylinder:
    return Cylinder(x_m, y_m, 0.25, 1.7)


def holds(shown: Scan, frame: str, distance_m: float = 0.0, **texts: str) -> bool:
    arguments = {name: TypedArgument(name, text) for name, text in texts.items()}
    if distance_m:
        measure = Measure("length", f"{distance_m} metres", distance_m, "metre", distance_m)
        arguments["distance"] = TypedArgument("distance", f"{distance_m} metres", measure=measure)
    return Surroundings(shown).holds(f"condition_of_{frame}", arguments)


def test_wall_and_person_are_told_apart() -> None:
    (wall,) = scan_of(WALL).things()
    assert wall.is_wall and wall.distance_m == pytest.approx(2.0)
    (body,) = scan_of(persons=[person(2.0)]).things()
    assert body.is_as_wide_as_a_person and body.distance_m == pytest.approx(1.75)
    both = scan_of(WALL, persons=[person(1.2)]).things()
    assert sum(thing.is_as_wide_as_a_person for thing in both) == 1
    assert sum(thing.is_wall for thing in both) == 2


def test_corner_is_two_walls() -> None:
    things = scan_of(WALL, (2.0, 3.0, -3.0, 3.0)).things()
    assert [thing.is_wall for thing in things] == [True, True]


@pytest.mark.parametrize(
    "phenomenon, x_m, expected",
    [
        ("a wall", 0.0, False),
        ("a wall", 1.2, True),
        ("an obstacle", 1.2, True),
        ("somebody", 1.2, False),
    ],
)
def test_wall_is_seen_from_near(phenomenon: str, x_m: float, expected: bool) -> None:
    assert holds(scan_of(WALL, x_m=x_m), "perceiving", perceiver="you", phenomenon=phenomenon) is expected


def test_wall_beside_the_way_is_not_ahead() -> None:
    beside = scan_of((-3.0, 0.5, 3.0, 0.5))
    assert holds(beside, "perceiving", perceiver="you", phenomenon="a wall") is False
    assert holds(beside, "obstruction") is False


def test_wall_that_the_robot_drives_at_obliquely_is_ahead() -> None:
    oblique = scan_of(WALL, x_m=1.3, yaw_rad=math.radians(45.0))
    assert holds(oblique, "perceiving", perceiver="you", phenomenon="a wall") is True


def test_person_is_seen_and_is_no_wall() -> None:
    shown = scan_of(persons=[person(0.9)])
    assert holds(shown, "perceiving", perceiver="you", phenomenon="a person") is True
    assert holds(shown, "perceiving", perceiver="you", phenomenon="a wall") is False
    assert holds(shown, "presence", theme="somebody") is True
    assert holds(scan_of(WALL), "presence", theme="somebody") is False


@pytest.mark.parametrize("x_m, expected", [(0.0, False), (1.1, True)])
def test_distance(x_m: float, expected: bool) -> None:
    assert holds(scan_of(WALL, x_m=x_m), "distance", 1.0, theme="you", place="the wall") is expected


def test_distance_that_nobody_said_cannot_be_told() -> None:
    with pytest.raises(ValueError, match="how far"):
        holds(scan_of(WALL), "distance", theme="you", place="the wall")


def test_contact_and_obstruction() -> None:
    assert [holds(scan_of(WALL, x_m=x_m), "contact", theme="you") for x_m in (1.5, 1.75)] == [False, True]
    assert [holds(scan_of(WALL, x_m=x_m), "obstruction") for x_m in (1.3, 1.55)] == [False, True]


def test_readings_that_are_none_show_nothing() -> None:
    readings = [math.nan, math.inf, 0.0, -1.0, 99.0]
    shown = Scan(readings, first_rad=-0.2, step_rad=0.1, least_m=0.05, most_m=8.0)
    assert shown.nearest_m(math.pi) == math.inf
    assert shown.things() == ()
    assert Scan([], first_rad=0.0, step_rad=0.1).things() == ()


def test_laser_does_not_promise_persons_where_something_else_sees_them() -> None:
    assert "condition_of_presence" in frames()
    without = frames(tells_persons=False)
    assert "condition_of_presence" not in without
    assert "person" not in str(without["condition_of_perceiving"])
