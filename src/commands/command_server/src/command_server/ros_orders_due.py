"""Standing orders that are due: commands that begin at the executor."""

from typing import Callable, Optional

from roboframenet_msgs.msg import CommandPlan, OrderDue

from command_server.open_commands import (
    EXECUTOR_STAGE,
    CommandText,
    Ending,
    OpenCommands,
    ending_if_stopped,
    ending_of_missed,
)
from command_server.ros_messages import command_to_message, due_from_message
from roboframenet_ros.ros_hand_over import HandOver


class OrdersDue:
    """Opens the commands of standing orders."""

    def __init__(
        self,
        commands: OpenCommands,
        command_plan: HandOver,
        refusal: Callable[[CommandText], Optional[Ending]],
        *,
        on_not_begun: Callable[[Ending], None],
    ) -> None:
        """
        Args:
            commands: that are open
            command_plan: the topic of the plans
            refusal: returns how a command is refused now; None if it is not
            on_not_begun: called with the ending of an order that was missed, stopped or refused
        """
        self._refusal = refusal
        self._commands = commands
        self._command_plan = command_plan
        self._on_not_begun = on_not_begun

    def begin(self, due: OrderDue, *, stop_stamp_ns: int) -> None:
        """Open the command of a standing order, and send its plan.

        Args:
            due: the standing order
            stop_stamp_ns: stamp of the last stop, nanoseconds of ROS time; what was due before it does not begin
        """
        command = due_from_message(due)
        if self._commands.get(command.command_id) is not None:
            return
        self._commands.open(command, stage=EXECUTOR_STAGE)
        ending = self._refusal(command) or ending_if_stopped(command, stop_stamp_ns=stop_stamp_ns)
        if ending is None and due.not_done:
            ending = ending_of_missed(command, due.not_done)
        if ending is not None:
            self._on_not_begun(ending)
        else:
            self._command_plan.publish(CommandPlan(command=command_to_message(command), plan=due.plan))
