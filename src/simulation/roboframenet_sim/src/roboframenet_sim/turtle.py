"""A turtle of turtlesim: a pose on a square field, driven by velocities."""

import math
from dataclasses import dataclass

#: Side of the field; the turtle begins in its middle. Lengths are metres here, as there.
FIELD_M = 11.088889
#: A velocity holds for so long.
COMMAND_S = 1.0


@dataclass
class Turtle:
    """Where the turtle is, and how it moves; x to the right, y up, ``yaw_rad`` from x to y."""

    x_m: float = FIELD_M / 2.0
    y_m: float = FIELD_M / 2.0
    yaw_rad: float = 0.0
    linear_m_per_s: float = 0.0
    angular_rad_per_s: float = 0.0
    _rest_s: float = 0.0

    def drive(self, linear_m_per_s: float, angular_rad_per_s: float) -> None:
        """Take a velocity; one that is no number stops the turtle."""
        is_good = math.isfinite(linear_m_per_s) and math.isfinite(angular_rad_per_s)
        self.linear_m_per_s = linear_m_per_s if is_good else 0.0
        self.angular_rad_per_s = angular_rad_per_s if is_good else 0.0
        self._rest_s = COMMAND_S

    def put(self, x_m: float, y_m: float, yaw_rad: float) -> None:
        """Put the turtle somewhere on the field."""
        self.x_m, self.y_m, self.yaw_rad = _on_field(x_m), _on_field(y_m), _wrapped(yaw_rad)

    def step(self, duration_s: float) -> None:
        """Move for some time; at the edge of the field the turtle slides along it."""
        if self._rest_s <= 0.0:
            self.linear_m_per_s = self.angular_rad_per_s = 0.0
        self._rest_s -= duration_s
        self.yaw_rad = _wrapped(self.yaw_rad + self.angular_rad_per_s * duration_s)
        self.x_m = _on_field(self.x_m + math.cos(self.yaw_rad) * self.linear_m_per_s * duration_s)
        self.y_m = _on_field(self.y_m + math.sin(self.yaw_rad) * self.linear_m_per_s * duration_s)


def _on_field(length_m: float) -> float:
    return min(max(length_m, 0.0), FIELD_M)


def _wrapped(angle_rad: float) -> float:
    return math.remainder(angle_rad, math.tau)
