"""Parameters of the nodes that stop the robot."""

from dataclasses import dataclass
from typing import Tuple

from roboframenet_ros.parameters import Parameters, parameter


@dataclass(frozen=True)
class BrakeSettings(Parameters):
    """Private parameters, checked.

    Attributes:
        velocity_topics: topics on which zero velocity is published
        zero_velocity_duration_s: shortest time for which it is repeated after a stop
        zero_velocity_limit_s: longest time, when a node drives against the stop
        zero_velocity_rate_hz: how often it is published
        confirmation_timeout_s: how long goals may take to end, and drivers to be quiet, before they are named
        also_cancel: names of action servers that are cancelled although they take no frames
        refresh_period_s: time between two searches for new action servers
        master_timeout_s: how long the master may take to answer

    Raises:
        ParameterError: a value out of its range
    """

    velocity_topics: Tuple[str, ...] = parameter(("cmd_vel",))
    zero_velocity_duration_s: float = parameter(1.0, least=0.0, most=10.0)
    zero_velocity_limit_s: float = parameter(10.0, least=0.0, most=600.0)
    zero_velocity_rate_hz: float = parameter(20.0, least=1.0, most=100.0)
    confirmation_timeout_s: float = parameter(1.0, least=0.2, most=10.0)
    also_cancel: Tuple[str, ...] = parameter(("move_base",))
    refresh_period_s: float = parameter(1.0, least=0.1, most=60.0)
    master_timeout_s: float = parameter(2.0, least=0.1, most=60.0)
