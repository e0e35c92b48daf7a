"""The depth camera against geometry."""

import math

import numpy as np
import pytest

from roboframenet_sim.base import Pose
from roboframenet_sim.point_cloud import Camera, Cylinder, render

CAMERA = Camera(width_px=161, height_px=121)
CENTRE = (60, 80)


def person_at(x_m, y_m):
    return Cylinder(x_m=x_m, y_m=y_m, radius_m=0.2, height_m=1.7)


def test_nothing_but_floor():
    cloud = render(CAMERA, pose=Pose(1.0, 2.0, 0.3))
    assert np.isnan(cloud[:60]).all()
    assert np.nanmax(np.abs(cloud[61:, :, 1] - 0.3)) < 1e-6


def test_person_straight_ahead_is_as_far_as_the_skin():
    cloud = render(CAMERA, pose=Pose(), person=person_at(0.8, 0.0))
    assert cloud[CENTRE] == pytest.approx([0.0, 0.0, 0.6], abs=1e-5)
    seen = cloud[:61][np.isfinite(cloud[:61, :, 2])]
    assert seen[:, 0].min() == pytest.approx(-seen[:, 0].max(), abs=1e-5)
    assert seen[:, 0].max() <= 0.2


@pytest.mark.parametrize("yaw_rad", [0.0, 0.7, -2.5])
def test_person_to_the_left_is_at_negative_x(yaw_rad):
    ahead, left = 0.9, 0.25
    person = person_at(
        ahead * math.cos(yaw_rad) - left * math.sin(yaw_rad), ahead * math.sin(yaw_rad) + left * math.cos(yaw_rad)
    )
    cloud = render(CAMERA, pose=Pose(yaw_rad=yaw_rad), person=person)
    seen = cloud[:61][np.isfinite(cloud[:61, :, 2])]
    assert seen[:, 0].mean() == pytest.approx(-0.25, abs=0.06)
    on_skin = np.hypot(seen[:, 2] - ahead, seen[:, 0] + left)
    assert np.abs(on_skin - 0.2).max() < 1e-5


def test_wall_hides_what_is_behind_and_ends_where_it_ends():
    wall = np.array([[2.0, -0.2, 2.0, 5.0]])
    cloud = render(CAMERA, pose=Pose(), person=person_at(3.0, 1.0), walls=wall)
    assert cloud[CENTRE][2] == pytest.approx(2.0)
    assert cloud[60, 0, 2] == pytest.approx(2.0)
    assert np.isnan(cloud[60, 160, 2])


def test_person_before_a_wall_is_seen_over_it():
    cloud = render(CAMERA, pose=Pose(), person=person_at(0.8, 0.0), walls=np.array([[2.0, -5.0, 2.0, 5.0]]))
    assert cloud[CENTRE][2] == pytest.approx(0.6, abs=1e-5)
    assert cloud[60, 0, 2] == pytest.approx(2.0)


def test_person_ends_at_the_top():
    cloud = render(CAMERA, pose=Pose(), person=Cylinder(x_m=2.0, y_m=0.0, radius_m=0.2, height_m=0.8))
    column = cloud[:, 80]
    assert (-np.nanmin(column[:, 1])) == pytest.approx(0.5, abs=0.03)


def test_person_behind_the_robot_or_too_near_is_not_seen():
    assert np.isnan(render(CAMERA, pose=Pose(), person=person_at(-1.0, 0.0))[:60]).all()
    assert np.isnan(render(CAMERA, pose=Pose(), person=person_at(0.5, 0.0))[CENTRE]).all()


def test_full_size_is_float32():
    cloud = render(Camera(), pose=Pose(), person=person_at(0.8, 0.0))
    assert cloud.shape == (480, 640, 3) and cloud.dtype == np.float32


@pytest.mark.parametrize("wrong", [{"width_px": 0}, {"height_px": 1.5}, {"nearest_m": 6.0}])
def test_camera_that_makes_no_sense_is_refused(wrong):
    with pytest.raises(ValueError):
        Camera(**wrong)
