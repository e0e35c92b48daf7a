"""Rigid transforms, and the upright box around a turned one. Quaternions are (x, y, z, w) of length 1."""

import math
from dataclasses import dataclass
from typing import Tuple

Vector = Tuple[float, float, float]
Quaternion = Tuple[float, float, float, float]

NO_TURN: Quaternion = (0.0, 0.0, 0.0, 1.0)
ORIGIN: Vector = (0.0, 0.0, 0.0)
_AXES: Tuple[Vector, Vector, Vector] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def turned(vector: Vector, by: Quaternion) -> Vector:
    """Return a vector after a turn."""
    x, y, z = vector
    qx, qy, qz, qw = by
    # v + 2 q x (q x v + w v)
    cx, cy, cz = qy * z - qz * y + qw * x, qz * x - qx * z + qw * y, qx * y - qy * x + qw * z
    return x + 2.0 * (qy * cz - qz * cy), y + 2.0 * (qz * cx - qx * cz), z + 2.0 * (qx * cy - qy * cx)


def product(first: Quaternion, second: Quaternion) -> Quaternion:
    """Return the turn that does the second one first."""
    ax, ay, az, aw = first
    bx, by, bz, bw = second
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def about_z(angle_rad: float) -> Quaternion:
    """Return the turn of a heading."""
    return (0.0, 0.0, math.sin(angle_rad / 2.0), math.cos(angle_rad / 2.0))


def of_roll_pitch_yaw(roll_rad: float, pitch_rad: float, yaw_rad: float) -> Quaternion:
    """Return a turn about the fixed axes x, y and z, in this order (REP 103)."""
    about_x = (math.sin(roll_rad / 2.0), 0.0, 0.0, math.cos(roll_rad / 2.0))
    about_y = (0.0, math.sin(pitch_rad / 2.0), 0.0, math.cos(pitch_rad / 2.0))
    return product(about_z(yaw_rad), product(about_y, about_x))


def distance_m(first: Vector, second: Vector) -> float:
    """Return the distance between two points, metres."""
    return math.sqrt(sum((a - b) ** 2 for a, b in zip(first, second)))


@dataclass(frozen=True)
class Transform:
    """Where one frame is in another: position in metres, and turn."""

    position: Vector = ORIGIN
    turn: Quaternion = NO_TURN

    @property
    def is_rigid(self) -> bool:
        """Whether its numbers are finite, and its turn has the length 1; messages may have any."""
        return all(map(math.isfinite, self.position)) and 0.9 < sum(number * number for number in self.turn) < 1.1

    def of_point(self, point: Vector) -> Vector:
        """Return a point of the inner frame as the outer one has it."""
        x, y, z = turned(point, self.turn)
        return self.position[0] + x, self.position[1] + y, self.position[2] + z

    def then(self, inner: "Transform") -> "Transform":
        """Return where a frame is that the inner frame knows."""
        return Transform(self.of_point(inner.position), product(self.turn, inner.turn))

    def inverse(self) -> "Transform":
        """Return where the outer frame is in the inner one."""
        x, y, z, w = self.turn
        back = (-x, -y, -z, w)
        px, py, pz = turned(self.position, back)
        return Transform((-px, -py, -pz), back)


@dataclass(frozen=True)
class UprightBox:
    """A box that stands on a horizontal face: the middle of its bottom, its edges, and its heading."""

    bottom: Vector
    size_m: Vector
    heading_rad: float


def upright_box(center: Transform, size_m: Vector) -> UprightBox:
    """Return a box upright: its most vertical axis becomes its height, whatever its frame calls up.

    Args:
        center: where its centre is, in a frame whose z axis points up (REP 103)
        size_m: its edges along its own axes
    """
    directions = [turned(axis, center.turn) for axis in _AXES]
    up = max(range(3), key=lambda axis: abs(directions[axis][2]))
    first, second = (axis for axis in range(3) if axis != up)
    # A tilted box reaches further up and down than its height says.
    height = sum(abs(direction[2]) * size for direction, size in zip(directions, size_m))
    x, y, z = center.position
    heading = math.atan2(directions[first][1], directions[first][0])
    return UprightBox((x, y, z - height / 2.0), (size_m[first], size_m[second], height), heading)
