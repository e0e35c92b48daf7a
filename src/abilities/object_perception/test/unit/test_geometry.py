"""Transforms, and boxes that stand upright."""

import math

import pytest

from object_perception.geometry import Transform, about_z, distance_m, of_roll_pitch_yaw, turned, upright_box

#: An optical frame on a robot that looks along x: its z is ahead, its x right, its y down.
OPTICAL = of_roll_pitch_yaw(-math.pi / 2.0, 0.0, -math.pi / 2.0)


def test_an_optical_frame_looks_ahead() -> None:
    assert turned((0.0, 0.0, 1.0), OPTICAL) == pytest.approx((1.0, 0.0, 0.0))
    assert turned((1.0, 0.0, 0.0), OPTICAL) == pytest.approx((0.0, -1.0, 0.0))
    assert turned((0.0, 1.0, 0.0), OPTICAL) == pytest.approx((0.0, 0.0, -1.0))


def test_a_transform_and_its_inverse_are_nothing() -> None:
    place = Transform((1.0, -2.0, 0.5), of_roll_pitch_yaw(0.3, -0.8, 2.0))
    point = (0.4, 5.0, -1.0)
    assert place.inverse().of_point(place.of_point(point)) == pytest.approx(point)
    both = place.then(place.inverse())
    assert distance_m(both.position, (0.0, 0.0, 0.0)) == pytest.approx(0.0, abs=1e-12)
    assert abs(both.turn[3]) == pytest.approx(1.0)


def test_then_is_one_after_the_other() -> None:
    outer, inner = Transform((1.0, 0.0, 0.0), about_z(math.pi / 2.0)), Transform((2.0, 0.0, 0.0), about_z(0.1))
    assert outer.then(inner).of_point((0.3, 0.0, 0.0)) == pytest.approx(outer.of_point(inner.of_point((0.3, 0, 0))))
    assert outer.then(inner).position == pytest.approx((1.0, 2.0, 0.0))


def test_a_box_of_an_optical_frame_stands_upright() -> None:
    # 0.1 wide, 0.3 high, 0.2 deep, as a camera that looks along x has it.
    box = upright_box(Transform((2.0, 0.0, 1.0), OPTICAL), (0.1, 0.3, 0.2))
    assert box.bottom == pytest.approx((2.0, 0.0, 0.85))
    assert box.size_m == pytest.approx((0.1, 0.2, 0.3))
    assert abs(box.heading_rad) == pytest.approx(math.pi / 2.0)


def test_a_tilted_box_reaches_further() -> None:
    box = upright_box(Transform((0.0, 0.0, 0.0), of_roll_pitch_yaw(0.2, 0.0, 0.0)), (0.1, 0.4, 1.0))
    assert box.size_m[2] == pytest.approx(math.cos(0.2) + 0.4 * math.sin(0.2))
