"""Computes the point cloud of a depth camera that sees a person, walls and the floor.

All objects are upright, so their distance depends only on the column of the image. The picture is the outer product of
a few rows and columns, without a loop over pixels.
"""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from roboframenet_sim.base import Pose

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Camera:
    """A depth camera above the centre of the robot, looking forward.

    The field of view is that of the Turtlebot's first depth cameras: 640 pixels at a focal length of 525.

    Raises:
        ValueError: a size is not positive
    """

    width_px: int = 640
    height_px: int = 480
    height_m: float = 0.3
    nearest_m: float = 0.35
    farthest_m: float = 5.0

    def __post_init__(self) -> None:
        for name in ("width_px", "height_px"):
            value = getattr(self, name)
            if not (isinstance(value, int) and 2 <= value <= 4096):
                raise ValueError(f"{name} must be 2 to 4096, got {value!r}")
        if not 0.0 < self.nearest_m < self.farthest_m:
            raise ValueError(f"the camera sees from {self.nearest_m!r} to {self.farthest_m!r} m: nothing")

    @property
    def focal_px(self) -> float:
        """Focal length in pixels."""
        return 525.0 * self.width_px / 640.0


@dataclass(frozen=True)
class Cylinder:
    """An upright cylinder that stands on the floor, such as a person."""

    x_m: float
    y_m: float
    radius_m: float
    height_m: float


NO_WALLS = np.zeros((0, 4))


def _depth_of_cylinder(cylinder: Cylinder, *, pose: Pose, slopes: "NDArray[np.float32]") -> "NDArray[np.floating[Any]]":
    cos, sin = math.cos(pose.yaw_rad), math.sin(pose.yaw_rad)
    dx, dy = cylinder.x_m - pose.x_m, cylinder.y_m - pose.y_m
    ahead, left = cos * dx + sin * dy, cos * dy - sin * dx
    # |(t, -slope t) - (ahead, left)| = radius, solved for the nearer t.
    a = 1.0 + slopes**2
    b = ahead - slopes * left
    rest = b**2 - a * (ahead**2 + left**2 - cylinder.radius_m**2)
    with np.errstate(invalid="ignore"):
        depth = (b - np.sqrt(rest)) / a
    return np.where((rest >= 0.0) & (depth > 0.0), depth, np.inf)


def _depth_of_walls(
    walls: "NDArray[np.float64]", *, pose: Pose, slopes: "NDArray[np.float32]"
) -> "NDArray[np.floating[Any]]":
    if not len(walls):
        return np.full(slopes.shape, np.inf)
    cos, sin = math.cos(pose.yaw_rad), math.sin(pose.yaw_rad)
    ends = walls.reshape(-1, 2, 2) - np.array([pose.x_m, pose.y_m])
    ahead = ends[..., 0] * cos + ends[..., 1] * sin
    left = ends[..., 1] * cos - ends[..., 0] * sin
    # The ray (t, -slope t) crosses the line through both ends where its offset from the ray changes sign.
    offset = left[:, :, None] + slopes[None, None, :] * ahead[:, :, None]
    first, second = offset[:, 0], offset[:, 1]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = first / (first - second)
        depth = ahead[:, :1] + share * (ahead[:, 1:] - ahead[:, :1])
    hits: NDArray[np.floating[Any]] = np.where((first * second <= 0.0) & (depth > 0.0), depth, np.inf)
    nearest: NDArray[np.floating[Any]] = hits.min(axis=0)
    return nearest


def render(
    camera: Camera,
    *,
    pose: Pose,
    person: Optional[Cylinder] = None,
    walls: "NDArray[np.float64]" = NO_WALLS,
    wall_height_m: float = 2.0,
) -> "NDArray[np.float32]":
    """Return the point cloud of the camera.

    Args:
        camera: the camera
        pose: pose of the robot
        person: the person in front of the robot; None for none
        walls: (n, 4) array: x, y of one end and x, y of the other, in metres
        wall_height_m: height of all walls
    Returns:
        (height, width, 3) array of float32: x right, y down, z forward (REP 103, optical frame), in metres;
        NaN where nothing is in range
    """
    columns = ((np.arange(camera.width_px) - (camera.width_px - 1) / 2.0) / camera.focal_px).astype(np.float32)
    rows = ((np.arange(camera.height_px) - (camera.height_px - 1) / 2.0) / camera.focal_px).astype(np.float32)
    with np.errstate(divide="ignore"):
        floor = np.where(rows > 0.0, camera.height_m / rows, np.inf).astype(np.float32)
    depth = np.repeat(floor[:, None], camera.width_px, axis=1)
    upright = [(_depth_of_walls(walls, pose=pose, slopes=columns), wall_height_m)]
    if person is not None:
        upright.append((_depth_of_cylinder(person, pose=pose, slopes=columns), person.height_m))
    for column_depth, height_m in upright:
        column_depth = column_depth.astype(np.float32)
        seen = np.flatnonzero(column_depth < camera.farthest_m)
        # Below its foot the floor is nearer; above its top the object ends.
        top = rows[:, None] * column_depth[None, seen] >= camera.height_m - height_m
        depth[:, seen] = np.where(top, np.minimum(depth[:, seen], column_depth[None, seen]), depth[:, seen])
    depth[(depth < camera.nearest_m) | (depth > camera.farthest_m)] = np.nan
    cloud = np.empty((camera.height_px, camera.width_px, 3), dtype=np.float32)
    np.multiply(depth, columns[None, :], out=cloud[..., 0])
    np.multiply(depth, rows[:, None], out=cloud[..., 1])
    cloud[..., 2] = depth
    return cloud
