"""Reads which topics and servers a stop applies to."""

from dataclasses import dataclass
from typing import Tuple

from command_server.open_commands import STOP_STAGE
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import read_parameters
from robot_stop.settings import BrakeSettings


@dataclass(frozen=True)
class StopTargets(Parameters):
    """Private parameters, checked.

    Attributes:
        velocity_topics: where zero velocity is published
        also_cancel: names of action servers that are cancelled although they take no frames

    Raises:
        ParameterError: not a list of names
    """

    velocity_topics: Tuple[str, ...] = parameter(BrakeSettings.velocity_topics)
    also_cancel: Tuple[str, ...] = parameter(BrakeSettings.also_cancel)


def read_brake_settings(private: str = "~") -> BrakeSettings:
    """Read the velocity topics and the servers to cancel; by default the parameters of the stop server.

    Args:
        private: prefix of the private names of the command server
    Raises:
        ParameterError: a parameter is not a list of names
    """
    targets = read_parameters(
        StopTargets, prefix=private, defaults=read_parameters(StopTargets, prefix=f"{STOP_STAGE}/")
    )
    return BrakeSettings(velocity_topics=targets.velocity_topics, also_cancel=targets.also_cancel)
