"""The ground around the robot: poses, and the picture of a map."""

import math
from dataclasses import dataclass
from typing import Optional, Sequence, Tuple

import numpy as np

from web_console.png import as_png
from web_console.views import Point, PoseView

#: Values of an occupancy grid, in percent: from here on a cell is drawn as occupied.
_OCCUPIED = 50
#: Longest side of the picture, in pixels; a larger map is drawn smaller.
_LONGEST_SIDE = 1600
_MOST_POINTS = 400
#: Less than this is no motion, metres and radians.
_STILL_M = 0.003
_STILL_RAD = 0.004
#: Palette of the picture: unknown, free, occupied; the page gives them the colours of its theme.
_PALETTE = bytes((0, 0, 0, 255, 255, 255, 0, 0, 0))
_TRANSPARENCY = bytes((0, 24, 255))


@dataclass(frozen=True)
class Pose:
    """A position and a heading, in metres and radians."""

    x_m: float
    y_m: float
    heading_rad: float

    def compose(self, other: "Pose") -> "Pose":
        """Return a pose given in this one."""
        cos, sin = math.cos(self.heading_rad), math.sin(self.heading_rad)
        return Pose(
            self.x_m + cos * other.x_m - sin * other.y_m,
            self.y_m + sin * other.x_m + cos * other.y_m,
            wrapped(self.heading_rad + other.heading_rad),
        )

    def inverse(self) -> "Pose":
        """Return the pose of the origin in this one."""
        cos, sin = math.cos(self.heading_rad), math.sin(self.heading_rad)
        return Pose(-cos * self.x_m - sin * self.y_m, sin * self.x_m - cos * self.y_m, wrapped(-self.heading_rad))


def wrapped(angle_rad: float) -> float:
    """Return an angle between -pi and pi."""
    return math.atan2(math.sin(angle_rad), math.cos(angle_rad))


def heading_of(x: float, y: float, z: float, w: float) -> float:
    """Return the heading of a quaternion, radians."""
    return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


class Localization:
    """Where the robot is: by odometry, and by the localization in the map once it has said where.

    Odometry is frequent and drifts; the localization is rare. What lies between the two is kept until the next one.
    """

    def __init__(self) -> None:
        self._odometry: Optional[Pose] = None
        self._localized: Optional[Pose] = None
        self._offset: Optional[Pose] = None
        self._frames = ("odom", "map")
        self._told: Optional[PoseView] = None

    def moved(self, pose: Pose, frame: str) -> None:
        """Odometry says where the robot is."""
        self._odometry = pose
        self._frames = (frame, self._frames[1])
        if self._localized is not None and self._offset is None:
            self._offset = self._localized.compose(pose.inverse())

    def localized(self, pose: Pose, frame: str) -> None:
        """The localization says where the robot is."""
        self._localized = pose
        self._frames = (self._frames[0], frame)
        self._offset = None if self._odometry is None else pose.compose(self._odometry.inverse())

    def pose(self) -> Optional[PoseView]:
        """Where the robot is now; None when nobody has said."""
        if self._odometry is not None and self._offset is not None:
            return _view(self._offset.compose(self._odometry), self._frames[1])
        if self._localized is not None:
            return _view(self._localized, self._frames[1])
        return None if self._odometry is None else _view(self._odometry, self._frames[0])

    def news(self) -> Optional[PoseView]:
        """The pose, when it differs from the one that was returned last; otherwise None."""
        now, before = self.pose(), self._told
        if now is None or (
            before is not None
            and now.frame == before.frame
            and math.hypot(now.x_m - before.x_m, now.y_m - before.y_m) < _STILL_M
            and abs(wrapped(now.heading_rad - before.heading_rad)) < _STILL_RAD
        ):
            return None
        self._told = now
        return now


def _view(pose: Pose, frame: str) -> PoseView:
    return PoseView(round(pose.x_m, 3), round(pose.y_m, 3), round(pose.heading_rad, 4), frame)


def thinned(points: Sequence[Tuple[float, float]]) -> Tuple[Point, ...]:
    """Return at most 400 points of a path, its ends among them; points that are no numbers are left out."""
    finite = [point for point in points if all(map(math.isfinite, point))]
    step = max(1, math.ceil(len(finite) / _MOST_POINTS))
    kept = finite[::step]
    if finite and kept[-1] != finite[-1]:
        kept.append(finite[-1])
    return tuple(Point(round(x, 3), round(y, 3)) for x, y in kept)


def map_png(cells: "np.ndarray[Tuple[int, int], np.dtype[np.int8]]") -> bytes:
    """Draw an occupancy grid as PNG, north up: unknown is transparent, free almost so, occupied opaque.

    Args:
        cells: rows from the smallest y, -1 for unknown, otherwise 0 to 100 percent
    """
    step = max(1, math.ceil(max(cells.shape) / _LONGEST_SIDE))
    if step > 1:
        rows, columns = (size // step * step for size in cells.shape)
        blocks = cells[:rows, :columns].reshape(rows // step, step, columns // step, step)
        # A thin wall must not vanish.
        cells = blocks.max(axis=(1, 3))
    colours = np.where(cells < 0, 0, np.where(cells >= _OCCUPIED, 2, 1)).astype(np.uint8)[::-1]
    return as_png(colours[:, :, np.newaxis], level=6, palette=_PALETTE, transparency=_TRANSPARENCY)
