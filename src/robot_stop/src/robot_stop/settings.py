"""Parameters of whoever stops the robot."""

import math
from dataclasses import dataclass
from typing import Tuple


def _check_number(name: str, value: object, least: float, most: float, unit: str) -> None:
    if (
        isinstance(value, bool)
        or not isinstance(value, (int, float))
        or not (math.isfinite(value) and least <= value <= most)
    ):
        raise ValueError(f"~{name} must be {least:g} to {most:g} {unit}, got {value!r}")


@dataclass(frozen=True)
class BrakeSettings:
    """Private parameters, checked.

    Attributes:
        velocity_topics: where zero velocity is published
        zero_velocity_duration_s: for how long after a stop, at least
        zero_velocity_limit_s: for how long at most, when somebody drives against the stop
        zero_velocity_rate_hz: how often
        confirmation_timeout_s: how long goals may take to end, and drivers to be quiet, before they are named
        also_cancel: names of action servers that are cancelled although they take no frames
        refresh_period_s: how often the graph is looked through for new action servers
        master_timeout_s: how long the master may take to answer

    Raises:
        ValueError: a value out of its range
    """

    velocity_topics: Tuple[str, ...] = ("cmd_vel",)
    zero_velocity_duration_s: float = 1.0
    zero_velocity_limit_s: float = 10.0
    zero_velocity_rate_hz: float = 20.0
    confirmation_timeout_s: float = 1.0
    also_cancel: Tuple[str, ...] = ("move_base",)
    refresh_period_s: float = 1.0
    master_timeout_s: float = 2.0

    def __post_init__(self) -> None:
        for name in ("velocity_topics", "also_cancel"):
            value = getattr(self, name)
            if not isinstance(value, (list, tuple)) or not all(isinstance(entry, str) and entry for entry in value):
                raise ValueError(f"~{name} must be a list of names, got {value!r}")
            object.__setattr__(self, name, tuple(value))
        _check_number("zero_velocity_duration_s", self.zero_velocity_duration_s, 0.0, 10.0, "s")
        _check_number("zero_velocity_limit_s", self.zero_velocity_limit_s, 0.0, 600.0, "s")
        _check_number("zero_velocity_rate_hz", self.zero_velocity_rate_hz, 1.0, 100.0, "Hz")
        _check_number("confirmation_timeout_s", self.confirmation_timeout_s, 0.2, 10.0, "s")
        _check_number("refresh_period_s", self.refresh_period_s, 0.1, 60.0, "s")
        _check_number("master_timeout_s", self.master_timeout_s, 0.1, 60.0, "s")
