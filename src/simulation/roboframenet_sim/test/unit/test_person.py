"""The person's walk."""

import math

import pytest

from roboframenet_sim.base import Pose
from roboframenet_sim.person import Person, PersonAct, PersonSettings


def watch(person, seconds, step_s=0.02):
    track = [person.pose]
    for _ in range(round(seconds / step_s)):
        person.step(step_s)
        track.append(person.pose)
    return track


def test_person_stands_before_the_robot_at_first():
    person = Person(robot=Pose(1.0, 1.0, math.pi / 2))
    watch(person, 5.0)
    assert (person.pose.x_m, person.pose.y_m) == (pytest.approx(1.0), pytest.approx(1.8))


def test_walk_is_ten_metres_of_curve_at_half_a_metre_per_second():
    person = Person()
    person.order(PersonAct.WALK, robot=Pose())
    track = watch(person, 30.0)
    steps = [math.hypot(b.x_m - a.x_m, b.y_m - a.y_m) for a, b in zip(track, track[1:])]
    assert sum(steps) == pytest.approx(10.0, abs=0.02)
    assert max(steps) / 0.02 == pytest.approx(0.5, rel=0.01)
    yaws = [pose.yaw_rad for pose in track]
    assert max(yaws) == pytest.approx(5.0 / 4.0, abs=0.01)
    assert yaws[-1] == pytest.approx(0.0, abs=0.02)
    assert person.act is PersonAct.STAND and person.speed_m_per_s == pytest.approx(0.0, abs=0.05)


def test_person_who_leaves_is_gone():
    person = Person()
    person.order(PersonAct.LEAVE, robot=Pose())
    watch(person, 1.0)
    assert person.is_present and person.pose.y_m > 0.2 and person.pose.x_m == pytest.approx(0.8)
    watch(person, 6.0)
    assert not person.is_present


def test_person_comes_back_to_where_the_robot_is():
    person = Person()
    person.order(PersonAct.LEAVE, robot=Pose())
    watch(person, 7.0)
    person.order(PersonAct.COME, robot=Pose(5.0, 0.0, 0.0))
    assert person.is_present and person.pose.x_m == pytest.approx(5.8)


def test_person_who_is_told_to_stand_stops_on_the_way():
    person = Person()
    person.order(PersonAct.WALK, robot=Pose())
    watch(person, 5.0)
    person.order(PersonAct.STAND, robot=Pose())
    watch(person, 2.0)
    before = person.pose
    watch(person, 2.0)
    assert person.pose == before and 1.0 < person.walked_m < 4.0


def test_settings_that_make_no_sense_are_refused():
    with pytest.raises(ValueError, match="radius_m"):
        PersonSettings(radius_m=0.0)
