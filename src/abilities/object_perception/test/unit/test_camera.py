"""Depth images, and what a camera could have seen."""

import math

import numpy as np
import pytest

from object_perception.camera import Camera, ConeView, DepthError, Forward, ImageView, depth_in_box, depths_of
from object_perception.geometry import Transform, of_roll_pitch_yaw

CAMERA = Camera(100.0, 100.0, 40.0, 30.0, 80, 60)
AHEAD = of_roll_pitch_yaw(-math.pi / 2.0, 0.0, -math.pi / 2.0)


def test_a_point_is_where_its_pixel_is() -> None:
    point = CAMERA.point_at(55.0, 20.0, 2.0)
    assert point == pytest.approx((0.3, -0.2, 2.0))
    assert CAMERA.pixel_of(point) == pytest.approx((55.0, 20.0))
    assert CAMERA.pixel_of((0.0, 0.0, -1.0)) is None


@pytest.mark.parametrize("is_bigendian", [False, True])
@pytest.mark.parametrize("encoding, kind, unit", [("16UC1", "u2", 1000.0), ("32FC1", "f4", 1.0)])
def test_depths_are_metres(encoding: str, kind: str, unit: float, is_bigendian: bool) -> None:
    pixels = (np.array([[1.5, 0.0], [2.0, 0.25]]) * unit).astype((">" if is_bigendian else "<") + kind)
    rows = b"".join(row.tobytes() + b"\xff\xff\xff\xff" for row in pixels)
    row_bytes = 2 * pixels.itemsize + 4
    depths = depths_of(rows, width=2, height=2, row_bytes=row_bytes, encoding=encoding, is_bigendian=is_bigendian)
    assert depths.tolist() == [[1.5, 0.0], [2.0, 0.25]]


def test_what_was_not_measured_is_no_depth() -> None:
    pixels = np.array([[math.nan, math.inf, -1.0, 3.0]], dtype="<f4")
    depths = depths_of(pixels.tobytes(), width=4, height=1, row_bytes=16, encoding="32FC1")
    assert depths.tolist() == [[0.0, 0.0, 0.0, 3.0]]


@pytest.mark.parametrize("encoding, size", [("rgb8", 100), ("16UC1", 7), ("32FC1", 8)])
def test_a_wrong_image_is_refused(encoding: str, size: int) -> None:
    with pytest.raises(DepthError):
        depths_of(bytes(size), width=2, height=2, row_bytes=4, encoding=encoding)


def test_the_middle_of_a_box_counts() -> None:
    depths = np.full((60, 80), 4.0)
    depths[20:40, 30:50] = 1.0  # the thing
    depths[28:32, 38:42] = 0.0  # a hole in it
    assert depth_in_box(depths, 40.0, 30.0, 30.0, 30.0) == 1.0
    assert depth_in_box(np.zeros((60, 80)), 40.0, 30.0, 30.0, 30.0) is None
    assert depth_in_box(depths, 500.0, 30.0, 30.0, 30.0) is None


def test_a_view_shows_what_is_in_the_image_and_not_hidden() -> None:
    depths = np.full((60, 80), 4.0)
    depths[:, 60:] = 1.0
    view = ImageView(CAMERA, depths, Transform((0.0, 0.0, 1.0), AHEAD), 0.3, 3.0)
    assert view.shows((2.0, 0.0, 1.0))
    assert not view.shows((2.0, -0.5, 1.0))  # behind what stands at the right
    assert not view.shows((3.5, 0.0, 1.0))  # further than the detector sees
    assert not view.shows((-2.0, 0.0, 1.0))
    assert not view.shows((2.0, 0.79, 1.0))  # at the rim, where things are cut off
    nothing = ImageView(CAMERA, np.zeros((60, 80)), view.place, 0.3, 3.0)
    assert not nothing.shows((2.0, 0.0, 1.0))


@pytest.mark.parametrize("forward, ahead", [(Forward.X, (2.0, 0.0, 0.0)), (Forward.Z, (0.0, 0.0, 2.0))])
def test_a_cone_looks_forward(forward: Forward, ahead: "tuple[float, float, float]") -> None:
    view = ConeView(Transform(), 0.3, 0.5, 3.0, forward)
    assert view.shows(ahead)
    assert not view.shows((-ahead[0], -ahead[1], -ahead[2]))
    assert not view.shows((ahead[0], 1.0, ahead[2]))
    assert not view.shows((2 * ahead[0], 0.0, 2 * ahead[2]))
