"""Parameters of the node."""

from dataclasses import dataclass

from roboframenet_ros.parameters import Parameters, parameter
from standing_orders.book import Rules


@dataclass(frozen=True)
class Settings(Parameters):
    """The private parameters, after validation; times in seconds.

    Attributes:
        file: where the orders are kept; empty for ``standing_orders.sqlite`` in the ROS home folder
        time_zone: of the clock of the robot, a name of IANA; empty for that of the machine
        most_orders: how many are kept
        longest_delay_s: how long an order that is due waits until nothing else runs
        fresh_s: for how long an event counts that is over
        pause_s: from one beginning of an order that waits for a condition to the next
        retry_s: from the death of the source of a condition to the next try
        silence_s: between two observations of a condition, unless its server states another time

    Raises:
        ParameterError: a value is not allowed
    """

    file: str = parameter("")
    time_zone: str = parameter("")
    most_orders: int = parameter(100, least=1, most=1000)
    longest_delay_s: float = parameter(60.0, least=1.0, most=3600.0)
    fresh_s: float = parameter(2.0, least=0.1, most=60.0)
    pause_s: float = parameter(1.0, least=0.0, most=3600.0)
    retry_s: float = parameter(5.0, least=0.1, most=3600.0)
    silence_s: float = parameter(3.0, least=0.05, most=600.0)

    @property
    def rules(self) -> Rules:
        """How orders are carried out."""
        return Rules(self.most_orders, self.longest_delay_s, self.fresh_s, self.pause_s)
