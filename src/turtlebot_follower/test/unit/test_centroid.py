"""The centroid against plain Python, and clouds that cannot be read."""

import numpy as np
import pytest

from turtlebot_follower.centroid import Box, CloudError, centroid, points_of

OFFSETS = {"x": 0, "y": 4, "z": 8}
FLOATS = {"x": 7, "y": 7, "z": 7}


def pack(points, *, point_step=16, order="<", height=1, padding=0):
    """Bytes of a cloud, its points in rows with a padding behind each."""
    array = np.full((height, len(points) // height, point_step // 4), 99.0, dtype=order + "f4")
    array[..., :3] = np.array(points, dtype=float).reshape(height, -1, 3)
    data = b"".join(row.tobytes() + b"\x01" * padding for row in array)
    return {
        "data": data,
        "height": height,
        "width": len(points) // height,
        "point_step": point_step,
        "row_step": len(points) // height * point_step + padding,
        "is_bigendian": order == ">",
        "offsets": OFFSETS,
        "datatypes": FLOATS,
    }


INSIDE = [(0.1, -0.2, 0.6), (-0.1, -0.3, 0.7), (0.15, -0.2, 0.5)]
OUTSIDE = [
    (0.3, -0.2, 0.6),
    (-0.3, -0.2, 0.6),
    (0.0, -0.05, 0.6),
    (0.0, -0.6, 0.6),
    (0.0, 0.2, 0.6),
    (0.0, -0.2, 0.9),
    (np.nan, np.nan, np.nan),
    (0.0, -0.2, -0.1),
    (0.0, np.nan, 0.6),
]


@pytest.mark.parametrize(
    "options", [{}, {"order": ">"}, {"point_step": 32}, {"height": 3}, {"height": 4, "padding": 8}, {"point_step": 12}]
)
def test_centroid_is_the_mean_of_what_is_in_the_box(options):
    found = centroid(points_of(**pack(INSIDE + OUTSIDE, **options)), box=Box(), min_share=0.1)
    assert found.count == 3
    assert found.x_m == pytest.approx(0.05) and found.z_m == pytest.approx(0.6)


def test_too_few_points_are_nobody():
    points = points_of(**pack(INSIDE + OUTSIDE))
    assert centroid(points, box=Box(), min_share=0.26) is None
    assert centroid(points_of(**pack(OUTSIDE)), box=Box(), min_share=0.0) is None
    assert centroid(points_of(**pack([])), box=Box(), min_share=0.0) is None


def test_every_other_point_of_every_other_row_is_enough():
    cloud = points_of(**pack([INSIDE[0]] * 16, height=4), pixel_step=2)
    assert cloud.shape == (2, 2)
    assert centroid(cloud, box=Box(), min_share=0.5).count == 4


@pytest.mark.parametrize(
    "change,words",
    [
        ({"offsets": {"x": 0, "y": 4}}, '"z"'),
        ({"datatypes": {"x": 7, "y": 7, "z": 8}}, "float32"),
        ({"width": 50}, "too few"),
        ({"row_step": 1}, "too few"),
        ({"offsets": {"x": 0, "y": 4, "z": 14}}, "outside"),
        ({"offsets": {"x": -4, "y": 4, "z": 8}}, "outside"),
    ],
)
def test_cloud_that_cannot_be_read(change, words):
    with pytest.raises(CloudError) as caught:
        points_of(**{**pack(INSIDE), **change})
    assert words in str(caught.value)


@pytest.mark.parametrize("wrong", [{"min_x_m": 0.3}, {"max_z_m": 0.0}, {"min_y_m": float("nan")}])
def test_box_without_room_is_refused(wrong):
    with pytest.raises(ValueError):
        Box(**wrong)
