"""Parameters of the node."""

from dataclasses import dataclass
from typing import Dict

from command_server.open_commands import STAGES
from roboframenet_ros.parameters import Parameters, parameter


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        stage_timeout_s: deadline of a stage for each command
        executor_timeout_s: the same for the executor, which reports every second
        stop_timeout_s: how long the stop server may take to answer "Stop."
        cancel_timeout_s: deadline for the end of a command that is forbidden or corrected
        pause_after_stop_s: from a stop to the command after it ("Stop and come back."); the robot comes to rest
        longest_delay_s: a robot of a fleet refuses a goal that took longer to reach it; its clock and that of the fleet
            must agree
        max_text_length: most characters of a command
        max_open_commands: most commands without a reply

    Raises:
        ParameterError: a value out of its range
    """

    stage_timeout_s: float = parameter(15.0, least=0.1, most=600.0)
    executor_timeout_s: float = parameter(5.0, least=1.5, most=600.0)
    stop_timeout_s: float = parameter(2.0, least=0.1, most=60.0)
    cancel_timeout_s: float = parameter(10.0, least=0.1, most=600.0)
    pause_after_stop_s: float = parameter(1.0, least=0.0, most=60.0)
    longest_delay_s: float = parameter(3.0, least=0.1, most=600.0)
    max_text_length: int = parameter(1000, least=1, most=100_000)
    max_open_commands: int = parameter(1000, least=1, most=100_000)

    @property
    def stage_timeouts_s(self) -> Dict[str, float]:
        """How long each stage may be silent, seconds."""
        timeouts_s = {stage: float(self.stage_timeout_s) for stage in STAGES}
        timeouts_s["executor"] = float(self.executor_timeout_s)
        return timeouts_s
