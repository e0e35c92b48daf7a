"""What a camera sees: pixels, depths, and the part of the room that is in its view.

A camera looks along z; x points to the right of its image, and y down (REP 103, optical frames).
"""

import enum
import math
from dataclasses import dataclass
from typing import Any, Optional, Protocol, Tuple

import numpy as np

from object_perception.geometry import Transform, Vector

#: The middle of a box of a detection: its rim shows what is behind the thing.
_MIDDLE = 0.5
#: Depths of which fewer pixels of the middle are valid are not believed.
_LEAST_VALID = 0.2
#: Part of an image at each edge in which a thing may be cut off.
_EDGE = 0.1


class DepthError(ValueError):
    """A depth image cannot be read; the message says why."""


@dataclass(frozen=True)
class Camera:
    """A pinhole camera: focal lengths and centre in pixels, and the size of its image."""

    focal_x: float
    focal_y: float
    center_x: float
    center_y: float
    width: int
    height: int

    def point_at(self, column: float, row: float, depth_m: float) -> Vector:
        """Return the point in the optical frame that a pixel shows, at a depth along z."""
        return (
            (column - self.center_x) * depth_m / self.focal_x,
            (row - self.center_y) * depth_m / self.focal_y,
            depth_m,
        )

    def pixel_of(self, point: Vector) -> Optional[Tuple[float, float]]:
        """Return column and row of a point in the optical frame; None if it is behind the camera."""
        x, y, z = point
        if z <= 0.0:
            return None
        return self.center_x + self.focal_x * x / z, self.center_y + self.focal_y * y / z


#: Depths in metres by row and column; 0 where nothing was measured. No type of numpy says so for Python 3.8.
Depths = Any

_ENCODINGS = {"16UC1": ("u2", 0.001), "mono16": ("u2", 0.001), "32FC1": ("f4", 1.0)}


def depths_of(
    data: bytes, *, width: int, height: int, row_bytes: int, encoding: str, is_bigendian: bool = False
) -> Depths:
    """Read a depth image (REP 118: 16UC1 in millimetres, 32FC1 in metres).

    Raises:
        DepthError: another encoding, or too few bytes
    """
    if encoding not in _ENCODINGS:
        raise DepthError(f"the depth image has the encoding {encoding!r}, expected one of {', '.join(_ENCODINGS)}")
    kind, unit_m = _ENCODINGS[encoding]
    pixel = np.dtype((">" if is_bigendian else "<") + kind)
    if row_bytes < width * pixel.itemsize or len(data) < row_bytes * height:
        raise DepthError(f"the depth image has {len(data)} bytes, which is too few for {width} x {height} pixels")
    rows = np.frombuffer(data, dtype=np.uint8, count=row_bytes * height).reshape(height, row_bytes)
    depths = rows[:, : width * pixel.itemsize].copy().view(pixel).astype(np.float64) * unit_m
    return np.where(np.isfinite(depths) & (depths > 0.0), depths, 0.0)


def depth_in_box(depths: Depths, column: float, row: float, width: float, height: float) -> Optional[float]:
    """Return how far the thing in a box is: the median of the middle of the box, metres.

    Args:
        depths: of the image in which the box is
        column, row: the centre of the box, pixels
        width, height: its edges, pixels
    Returns:
        None if too few pixels there have a depth
    """
    rows, columns = depths.shape
    half_x, half_y = max(width * _MIDDLE / 2.0, 0.5), max(height * _MIDDLE / 2.0, 0.5)
    left, right = math.floor(max(column - half_x, 0.0)), math.ceil(min(column + half_x, float(columns)))
    top, bottom = math.floor(max(row - half_y, 0.0)), math.ceil(min(row + half_y, float(rows)))
    if left >= right or top >= bottom:
        return None
    middle = depths[top:bottom, left:right]
    valid = middle[middle > 0.0]
    if valid.size == 0 or valid.size < _LEAST_VALID * middle.size:
        return None
    return float(np.median(valid))


class View(Protocol):
    """What one look could see."""

    def shows(self, point: Vector) -> bool:
        """Whether a thing at a point of the world would have been seen."""


class NoView:
    """A look of which nobody knows what else it could have shown."""

    def shows(self, point: Vector) -> bool:
        """No: nothing is missed."""
        return False


@dataclass(frozen=True)
class ImageView:
    """A look of a camera with depths.

    Attributes:
        camera: that took it
        depths: of the same image
        place: where its optical frame is in the world
        nearest_m, furthest_m: depths at which its detector finds things
        slack_m: what is so much nearer than a thing hides it
    """

    camera: Camera
    depths: Depths
    place: Transform
    nearest_m: float
    furthest_m: float
    slack_m: float = 0.3

    def shows(self, point: Vector) -> bool:
        """Whether a thing there would have been seen: in the image, not too far, and with nothing before it."""
        seen = self.place.inverse().of_point(point)
        pixel = self.camera.pixel_of(seen)
        if pixel is None or not self.nearest_m <= seen[2] <= self.furthest_m:
            return False
        column, row = pixel[0] / self.camera.width, pixel[1] / self.camera.height
        if not (_EDGE <= column <= 1.0 - _EDGE and _EDGE <= row <= 1.0 - _EDGE):
            return False
        measured = depth_in_box(self.depths, pixel[0], pixel[1], 4.0, 4.0)
        # Without a depth nobody knows what is before it.
        return measured is not None and measured > seen[2] - self.slack_m


class Forward(str, enum.Enum):
    """The axis along which a sensor looks: z for optical frames, x for lidars and bases."""

    Z = "z"
    X = "x"


@dataclass(frozen=True)
class ConeView:
    """A look of a sensor of which only the angle and the range are known.

    Attributes:
        place: where its frame is in the world
        angle_rad: between the middle of its view and the rim
        nearest_m, furthest_m: distances at which it finds things
        forward: where it looks
    """

    place: Transform
    angle_rad: float
    nearest_m: float
    furthest_m: float
    forward: Forward = Forward.Z

    def shows(self, point: Vector) -> bool:
        """Whether a thing there is in the cone; what hides it is not known."""
        x, y, z = self.place.inverse().of_point(point)
        ahead, aside = (z, math.hypot(x, y)) if self.forward is Forward.Z else (x, math.hypot(y, z))
        return self.nearest_m <= math.hypot(ahead, aside) <= self.furthest_m and (
            math.atan2(aside, ahead) <= self.angle_rad
        )
