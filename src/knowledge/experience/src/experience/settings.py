"""Parameters of the node."""

from dataclasses import dataclass

from roboframenet_ros.parameters import Parameters, parameter


@dataclass(frozen=True)
class Settings(Parameters):
    """The private parameters, after validation.

    Attributes:
        file: where it is kept; empty for ``experience.sqlite`` in the ROS home folder
        most_trials: that are kept; the oldest ones are deleted
        snapshot_period_s: what is known is published at most so often, seconds

    Raises:
        ParameterError: a value is not allowed
    """

    file: str = parameter("")
    most_trials: int = parameter(10_000, least=10, most=1_000_000)
    snapshot_period_s: float = parameter(0.2, least=0.01, most=60.0)
