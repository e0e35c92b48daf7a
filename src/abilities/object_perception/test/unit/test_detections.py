"""Boxes in images and in space become sightings in the frame of the world."""

import math

import numpy as np
import pytest

from object_perception.camera import Camera
from object_perception.detections import BoxInImage, BoxInSpace, best, sightings_in_image, sightings_in_space
from object_perception.geometry import Transform, of_roll_pitch_yaw
from object_perception.pending import Pending
from world_model.world_object import Sort

LABELS = ("-", "mug", "person")
CAMERA = Camera(100.0, 100.0, 40.0, 30.0, 80, 60)
#: At a height of 1.2 m, and looks along y of the world.
PLACE = Transform((1.0, 2.0, 1.2), of_roll_pitch_yaw(-math.pi / 2.0, 0.0, 0.0))


def test_the_best_hypothesis_counts() -> None:
    assert best([(1, 0.4), (2, 0.7)], LABELS) == ("person", 0.7)
    assert best([(1, 0.4), (0, 0.7)], LABELS) is None
    assert best([(9, 0.7)], LABELS) is None
    assert best([(-1, 0.7)], LABELS) is None
    assert best([(1, math.nan), (2, 1.5)], LABELS) is None
    assert best([], LABELS) is None


def test_a_box_in_an_image_is_in_the_world() -> None:
    depths = np.full((60, 80), 2.0)
    box = BoxInImage(50.0, 30.0, 10.0, 20.0, ((1, 0.9),))
    (one,) = sightings_in_image([box], CAMERA, depths, PLACE, labels=LABELS, world_frame="map")
    pose = one.about.pose
    assert pose is not None and one.score == 0.9 and one.about.category == "mug"
    assert (pose.frame_id, pose.x_m, pose.y_m) == ("map", pytest.approx(1.2), pytest.approx(4.0))
    # The middle of its bottom: it is 0.4 m high.
    assert pose.z_m == pytest.approx(1.0)
    assert one.about.size_m == pytest.approx((0.2, 0.2, 0.4))


def test_a_box_without_a_depth_is_left_out() -> None:
    boxes = [BoxInImage(50.0, 30.0, 10.0, 20.0, ((1, 0.9),))]
    nothing = np.zeros((60, 80))
    assert sightings_in_image(boxes, CAMERA, nothing, PLACE, labels=LABELS, world_frame="map") == []


def test_a_box_in_space_is_in_the_world() -> None:
    box = BoxInSpace(Transform((0.0, 0.2, 2.0)), (0.5, 1.8, 0.3), ((2, 0.8),))
    (one,) = sightings_in_space([box], PLACE, labels=LABELS, world_frame="map")
    pose = one.about.pose
    assert pose is not None and one.about.sort is Sort.PERSON
    assert (pose.x_m, pose.y_m, pose.z_m) == pytest.approx((1.0, 4.0, 0.1))
    assert one.about.size_m == pytest.approx((0.5, 0.3, 1.8))


@pytest.mark.parametrize(
    "box",
    [
        BoxInSpace(Transform((math.nan, 0.0, 1.0)), (0.1, 0.1, 0.1), ((1, 0.9),)),
        BoxInSpace(Transform((0.0, 0.0, 1.0)), (-0.1, 0.1, 0.1), ((1, 0.9),)),
        BoxInSpace(Transform((0.0, 0.0, 1.0), (3.0, 0.0, 0.0, 1.0)), (0.1, 0.1, 0.1), ((1, 0.9),)),
    ],
)
def test_a_wrong_box_is_left_out(box: BoxInSpace) -> None:
    assert sightings_in_space([box], PLACE, labels=LABELS, world_frame="map") == []


def test_an_empty_turn_is_none() -> None:
    box = BoxInSpace(Transform((0.0, 0.0, 1.0), (0.0, 0.0, 0.0, 0.0)), (0.1, 0.1, 0.1), ((1, 0.9),))
    assert len(sightings_in_space([box], PLACE, labels=LABELS, world_frame="map")) == 1


def test_looks_wait_in_order_and_no_longer_than_allowed() -> None:
    pending: Pending[str] = Pending(most=2, wait_s=1.0)
    pending.put("a", 10.0)
    pending.put("b", 10.5)
    assert pending.first() == "a" and not pending.is_late(11.0) and pending.is_late(11.1)
    pending.done()
    assert pending.first() == "b" and not pending.is_late(11.1)
    pending.put("c", 12.0)
    pending.put("d", 12.0)
    assert (pending.first(), pending.dropped) == ("c", 1)
