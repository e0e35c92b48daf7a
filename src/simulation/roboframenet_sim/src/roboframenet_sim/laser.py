"""Computes what a planar laser shows of walls and of upright cylinders, such as persons."""

import math
from typing import TYPE_CHECKING, Sequence

import numpy as np

from roboframenet_sim.base import Pose
from roboframenet_sim.point_cloud import Cylinder

if TYPE_CHECKING:
    from numpy.typing import NDArray


def scan(
    pose: Pose,
    angles_rad: "NDArray[np.float64]",
    *,
    walls: "NDArray[np.float64]",
    cylinders: Sequence[Cylinder] = (),
    farthest_m: float = 8.0,
) -> "NDArray[np.float64]":
    """Return the distance along each ray to the first thing that it meets, in metres; infinite for none in range.

    Args:
        pose: of the laser
        angles_rad: of the rays, 0 ahead, positive to the left
        walls: (n, 4) array: x, y of one end and x, y of the other, in metres
        cylinders: persons
        farthest_m: range of the laser
    """
    headings = angles_rad + pose.yaw_rad
    rays = np.stack([np.cos(headings), np.sin(headings)], axis=1)
    nearest = np.full(len(rays), np.inf)
    if len(walls):
        ends = walls.reshape(-1, 2, 2) - np.array([pose.x_m, pose.y_m])
        # Both ends in the frame of each ray: how far along it, and how far beside it.
        along = ends @ rays.T
        beside = ends @ np.stack([-rays[:, 1], rays[:, 0]])
        first, second = beside[:, 0], beside[:, 1]
        with np.errstate(divide="ignore", invalid="ignore"):
            share = first / (first - second)
            distances = along[:, 0] + share * (along[:, 1] - along[:, 0])
        hits = np.where((first * second <= 0.0) & (distances > 0.0), distances, np.inf)
        nearest = np.minimum(nearest, hits.min(axis=0))
    for body in cylinders:
        centre = np.array([body.x_m - pose.x_m, body.y_m - pose.y_m])
        along = rays @ centre
        rest = body.radius_m**2 - (centre @ centre - along**2)
        with np.errstate(invalid="ignore"):
            distances = along - np.sqrt(rest)
        nearest = np.minimum(nearest, np.where((rest >= 0.0) & (distances > 0.0), distances, np.inf))
    return np.where(nearest <= farthest_m, nearest, np.inf)


def angles(count: int, half_angle_rad: float = math.pi / 2.0) -> "NDArray[np.float64]":
    """Return the angles of the rays of a laser that looks ahead, from the right to the left."""
    found: NDArray[np.float64] = np.linspace(-half_angle_rad, half_angle_rad, count)
    return found
