"""A person in front of the robot, who stands, walks a curve, leaves and comes back."""

import enum
import math
from dataclasses import dataclass

from roboframenet_sim.base import Pose, approach


class PersonAct(enum.Enum):
    """Acts of the person."""

    STAND = "stand"
    WALK = "walk"
    LEAVE = "leave"
    COME = "come"


@dataclass(frozen=True)
class PersonSettings:
    """Parameters of the walk.

    Raises:
        ValueError: a number is not positive
    """

    distance_m: float = 0.6
    """Distance of the person at first and after COME, from the centre of the robot to the person's skin.
    """
    path_m: float = 10.0
    radius_m: float = 4.0
    """The walk is S-shaped: its first half bends to the left with this radius, its second half to the right."""
    speed_m_per_s: float = 0.5
    acceleration_m_per_s2: float = 0.5
    leaving_speed_m_per_s: float = 1.5
    leaving_m: float = 4.0
    """After this distance to the left the person is gone."""
    body_radius_m: float = 0.2
    height_m: float = 1.7

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if not (isinstance(value, (int, float)) and math.isfinite(value) and value > 0.0):
                raise ValueError(f"{name} must be a positive number, got {value!r}")


class Person:
    """A person who follows orders.

    Args:
        settings: parameters of the walk
        robot: pose of the robot; the person starts in front of it
    """

    def __init__(self, settings: PersonSettings = PersonSettings(), *, robot: Pose = Pose()) -> None:
        self.settings = settings
        self.is_present = True
        self.walked_m = 0.0
        self._act = PersonAct.STAND
        self._speed_m_per_s = 0.0
        self.pose = robot
        self._come(robot)

    @property
    def act(self) -> PersonAct:
        """The present act; STAND after a walk."""
        return self._act

    @property
    def speed_m_per_s(self) -> float:
        """Speed along the walk."""
        return self._speed_m_per_s

    def order(self, act: PersonAct, *, robot: Pose) -> None:
        """Start another act.

        Args:
            act: the new act
            robot: present pose of the robot; COME puts the person in front of it
        """
        if act is PersonAct.COME:
            self._come(robot)
            return
        if act is PersonAct.LEAVE:
            self.pose = Pose(self.pose.x_m, self.pose.y_m, self.pose.yaw_rad + math.pi / 2.0)
            self._speed_m_per_s = 0.0
        if act is not PersonAct.STAND:
            self.walked_m = 0.0
        self._act = act

    def _come(self, robot: Pose) -> None:
        away_m = self.settings.distance_m + self.settings.body_radius_m
        self.pose = Pose(
            x_m=robot.x_m + away_m * math.cos(robot.yaw_rad),
            y_m=robot.y_m + away_m * math.sin(robot.yaw_rad),
            yaw_rad=robot.yaw_rad,
        )
        self._act = PersonAct.STAND
        self._speed_m_per_s = 0.0
        self.is_present = True

    def step(self, duration_s: float) -> None:
        """Advance the time by at most 0.1 s."""
        settings = self.settings
        wanted = 0.0
        if self._act is PersonAct.WALK:
            to_go_m = settings.path_m - self.walked_m
            wanted = min(settings.speed_m_per_s, math.sqrt(max(0.0, 2.0 * settings.acceleration_m_per_s2 * to_go_m)))
            if to_go_m < 0.001:
                self._act = PersonAct.STAND
        elif self._act is PersonAct.LEAVE:
            wanted = settings.leaving_speed_m_per_s
            self.is_present = self.is_present and self.walked_m < settings.leaving_m
        self._speed_m_per_s = approach(
            self._speed_m_per_s, target=wanted, step=settings.acceleration_m_per_s2 * duration_s
        )
        way_m = self._speed_m_per_s * duration_s
        turn_rad = 0.0
        if self._act is PersonAct.WALK:
            turn_rad = math.copysign(way_m / settings.radius_m, settings.path_m / 2.0 - self.walked_m)
        heading_rad = self.pose.yaw_rad + turn_rad / 2.0
        self.walked_m += way_m
        self.pose = Pose(
            x_m=self.pose.x_m + way_m * math.cos(heading_rad),
            y_m=self.pose.y_m + way_m * math.sin(heading_rad),
            yaw_rad=self.pose.yaw_rad + turn_rad,
        )
