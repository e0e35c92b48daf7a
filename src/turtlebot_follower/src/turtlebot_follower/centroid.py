"""The centroid of the points in front of the robot, in a point cloud.

The cloud is in the optical frame of the camera (REP 103): x right, y down, z forward, metres.
"""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Mapping, Optional

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Box:
    """The box in which a person is searched for.

    The names and values are those of the Turtlebot's follower. The y limits count upwards from the camera, opposite to
    the y of the cloud. The box begins above the camera, so it never contains the floor.

    Raises:
        ValueError: a limit is not a finite number, or the box is empty
    """

    min_x_m: float = -0.2
    max_x_m: float = 0.2
    min_y_m: float = 0.1
    max_y_m: float = 0.5
    max_z_m: float = 0.8

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if not (isinstance(value, (int, float)) and math.isfinite(value)):
                raise ValueError(f"{name} must be a finite number, got {value!r}")
        if not (self.min_x_m < self.max_x_m and self.min_y_m < self.max_y_m and self.max_z_m > 0.0):
            raise ValueError(f"the box is empty: {self}")


@dataclass(frozen=True)
class Centroid:
    """Mean of the points in the box: metres to the right and metres ahead."""

    x_m: float
    z_m: float
    count: int


class CloudError(ValueError):
    """A point cloud that cannot be read; the message says why."""


FLOAT32 = 7
"""Code of PointField for four-byte floats."""


def points_of(
    data: bytes,
    *,
    height: int,
    width: int,
    point_step: int,
    row_step: int,
    is_bigendian: bool,
    offsets: Mapping[str, int],
    datatypes: Mapping[str, int],
    pixel_step: int = 1,
) -> "NDArray[np.void]":
    """View the points of a PointCloud2 without copying them.

    Args:
        data: of the message
        height: rows
        width: points in a row
        point_step: bytes from one point to the next
        row_step: bytes from one row to the next
        is_bigendian: byte order
        offsets: byte offset of x, y and z in a point
        datatypes: PointField code of x, y and z
        pixel_step: use only every n-th point of every n-th row
    Returns:
        structured array (rows, columns) with the fields x, y, z
    Raises:
        CloudError: a field is missing or is not float32, or the data are too short
    """
    for axis in "xyz":
        if axis not in offsets:
            raise CloudError(f'the cloud has no field "{axis}"')
        if datatypes.get(axis) != FLOAT32:
            raise CloudError(f'the field "{axis}" is not float32')
        if not 0 <= offsets[axis] <= point_step - 4:
            raise CloudError(f'the field "{axis}" lies outside of the point')
    if row_step < width * point_step or len(data) < row_step * height:
        raise CloudError(f"{len(data)} bytes are too few for {height} rows of {width} points")
    order = ">" if is_bigendian else "<"
    point = np.dtype(
        {
            "names": list("xyz"),
            "formats": [order + "f4"] * 3,
            "offsets": [offsets[axis] for axis in "xyz"],
            "itemsize": point_step,
        }
    )
    rows: NDArray[np.void] = np.ndarray(shape=(height, width), dtype=point, buffer=data, strides=(row_step, point_step))
    # An unorganised cloud is a single row.
    return rows[::pixel_step, ::pixel_step] if height > 1 else rows[:, ::pixel_step]


def centroid(points: "NDArray[np.void]", *, box: Box, min_share: float) -> Optional[Centroid]:
    """Return the centroid of the points in the box.

    Args:
        points: structured array with the fields x, y, z; NaN where the camera saw nothing
        box: where to look
        min_share: share of all points that must be in the box for a person
    Returns:
        None if too few points are in the box
    """
    if not points.size:
        return None
    # Few points are near, so the first test removes most of them. Comparisons with NaN are false.
    with np.errstate(invalid="ignore"):
        near = points[(points["z"] < box.max_z_m) & (points["z"] > 0.0)]
        inside = near[
            (near["x"] > box.min_x_m)
            & (near["x"] < box.max_x_m)
            & (-near["y"] > box.min_y_m)
            & (-near["y"] < box.max_y_m)
        ]
    if len(inside) < max(1.0, min_share * points.size):
        return None
    return Centroid(
        x_m=float(inside["x"].mean(dtype=np.float64)), z_m=float(inside["z"].mean(dtype=np.float64)), count=len(inside)
    )
