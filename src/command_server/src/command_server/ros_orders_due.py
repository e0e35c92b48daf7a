"""Standing orders that are due: commands that begin at the executor."""

from typing import Optional

import rospy
from roboframenet_msgs.msg import CommandPlan, OrderDue

from command_server.open_commands import EXECUTOR_STAGE, Ending, OpenCommands, ending_of_cancelled, ending_of_missed
from command_server.ros_messages import command_to_message, due_from_message


class OrdersDue:
    """Opens the commands of standing orders. Publishes: ``command_plan``."""

    def __init__(self, commands: OpenCommands) -> None:
        """
        Args:
            commands: that are open
        """
        self._commands = commands
        self._command_plan = rospy.Publisher("command_plan", CommandPlan, queue_size=100)

    def begin(self, due: OrderDue, *, stop_stamp_ns: int) -> Optional[Ending]:
        """Open the command of a standing order, and send its plan.

        Args:
            due: the standing order
            stop_stamp_ns: stamp of the last stop, nanoseconds of ROS time; what was due before it does not begin
        Returns:
            how the command ends, if the order was missed or stopped; None otherwise
        """
        command = due_from_message(due)
        if self._commands.get(command.command_id) is not None:
            return None
        self._commands.open(command, stage=EXECUTOR_STAGE)
        if command.stamp_ns <= stop_stamp_ns:
            return ending_of_cancelled(command)
        if due.not_done:
            return ending_of_missed(command, due.not_done)
        self._command_plan.publish(CommandPlan(command=command_to_message(command), plan=due.plan))
        return None
