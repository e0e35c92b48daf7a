"""Parameters of the node."""

import enum
from dataclasses import dataclass

from executor.goal_tracking import GoalDeadlines
from roboframenet_ros.parameters import Parameters, parameter


class OnMasterLost(enum.Enum):
    """What becomes of a command when the master is gone; nothing else begins in any case."""

    FINISH = "finish"
    STOP = "stop"


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked; times in seconds.

    Attributes:
        acceptance_timeout_s: for a server to connect, and for it to accept a goal
        silence_timeout_s: between two messages of a server that has a goal
        preempt_timeout_s: for a goal to end after the first cancel
        cancel_period_s: between two cancels
        result_timeout_s: for the result after a terminal status
        suspicion_s: silence after which the process of a server is asked whether it lives
        longest_goal_s: from the acceptance to the end of a goal
        longest_command_s: for a command
        longest_wait_s: for a condition, if nothing else was said
        condition_silence_s: between two observations of a condition, unless its server states another time
        longest_search_s: that a command may lose with servers that do not work
        quarantine_s: for which a server that did not end a goal is not used; 0 for none
        settings_timeout_s: for a node to be reconfigured
        max_clients: connections to servers that are kept, and made beforehand
        on_master_lost: finish or stop: what becomes of what runs when the master is gone; nothing else begins
        master_timeout_s: a master that hangs is gone after this time
        introspection: publish the topics of smach_viewer

    Raises:
        ParameterError: a value out of its range
    """

    acceptance_timeout_s: float = parameter(5.0, least=0.05, most=600.0)
    silence_timeout_s: float = parameter(5.0, least=0.05, most=600.0)
    preempt_timeout_s: float = parameter(5.0, least=0.05, most=600.0)
    cancel_period_s: float = parameter(0.5, least=0.05, most=600.0)
    result_timeout_s: float = parameter(2.0, least=0.05, most=600.0)
    suspicion_s: float = parameter(1.0, least=0.05, most=600.0)
    longest_goal_s: float = parameter(3600.0, least=0.05, most=1e6)
    longest_command_s: float = parameter(7200.0, least=0.05, most=1e6)
    longest_wait_s: float = parameter(3600.0, least=0.05, most=1e6)
    condition_silence_s: float = parameter(3.0, least=0.05, most=600.0)
    longest_search_s: float = parameter(30.0, least=0.05, most=1e6)
    quarantine_s: float = parameter(60.0, least=0.0, most=1e6)
    settings_timeout_s: float = parameter(3.0, least=0.05, most=600.0)
    max_clients: int = parameter(64, least=1, most=1000)
    on_master_lost: OnMasterLost = parameter(OnMasterLost.FINISH)
    master_timeout_s: float = parameter(30.0, least=1.0, most=1e6)
    introspection: bool = parameter(True)

    @property
    def deadlines(self) -> GoalDeadlines:
        """The deadlines of each goal."""
        return GoalDeadlines(
            acceptance_s=self.acceptance_timeout_s,
            silence_s=self.silence_timeout_s,
            preempt_s=self.preempt_timeout_s,
            cancel_period_s=self.cancel_period_s,
            result_s=self.result_timeout_s,
            suspicion_s=self.suspicion_s,
            execution_s=self.longest_goal_s,
        )
