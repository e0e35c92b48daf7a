"""Parameters of the node."""

import math
from dataclasses import dataclass
from typing import Dict

from command_server.command_book import STAGES


@dataclass(frozen=True)
class Settings:
    """Private parameters, checked.

    Attributes:
        stage_timeout_s: how long a stage may be silent about a command before the command fails
        executor_timeout_s: the same for the executor, which speaks every second
        stop_timeout_s: how long the stop server may take to answer "Stop."
        cancel_timeout_s: how long what runs may take to end when it is forbidden or corrected
        pause_after_stop_s: from a stop to the command behind it ("Stop and come back."); the robot comes to rest
        max_text_length: characters of a command
        max_open_commands: commands without a reply

    Raises:
        ValueError: a value out of its range
    """

    stage_timeout_s: float = 15.0
    executor_timeout_s: float = 5.0
    stop_timeout_s: float = 2.0
    cancel_timeout_s: float = 10.0
    pause_after_stop_s: float = 1.0
    max_text_length: int = 1000
    max_open_commands: int = 1000

    def __post_init__(self) -> None:
        for name, least, most in (
            ("stage_timeout_s", 0.1, 600.0),
            ("executor_timeout_s", 1.5, 600.0),
            ("stop_timeout_s", 0.1, 60.0),
            ("cancel_timeout_s", 0.1, 600.0),
            ("pause_after_stop_s", 0.0, 60.0),
        ):
            value = getattr(self, name)
            if (
                isinstance(value, bool)
                or not isinstance(value, (int, float))
                or not (math.isfinite(value) and least <= value <= most)
            ):
                raise ValueError(f"~{name} must be {least:g} to {most:g} s, got {value!r}")
        for name, least, most in (("max_text_length", 1, 100_000), ("max_open_commands", 1, 100_000)):
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
                raise ValueError(f"~{name} must be an integer from {least} to {most}, got {value!r}")

    @property
    def stage_timeouts_s(self) -> Dict[str, float]:
        """How long each stage may be silent, seconds."""
        timeouts_s = {stage: float(self.stage_timeout_s) for stage in STAGES}
        timeouts_s["executor"] = float(self.executor_timeout_s)
        return timeouts_s
