"""Goes on with what was stopped: the plan begins at the executor, as a command of its own."""

from typing import Callable, Sequence

import rospy
from roboframenet_msgs.msg import CommandPlan, Plan, PlanNode, StoppedPlan

from command_server.going_on import DECLINED, GoingOn, Stopped
from command_server.open_commands import EXECUTOR_STAGE, OWN_STAGE, CommandText, Ending, OpenCommands, Outcome
from command_server.ros_messages import command_to_message
from roboframenet_ros.ros_hand_over import HandOver


class StoppedPlans:
    """What a person may let go on."""

    def __init__(
        self, commands: OpenCommands, command_plan: HandOver, *, on_declined: Callable[[Ending], None]
    ) -> None:
        """
        Args:
            commands: that are open
            command_plan: the topic of the plans
            on_declined: called with the ending of a no
        """
        self._commands = commands
        self._on_declined = on_declined
        self.going_on: GoingOn[Plan] = GoingOn()
        self._command_plan = command_plan

    def hear(self, message: StoppedPlan) -> None:
        """The executor has ended a plan."""
        command = message.command
        stamp_ns, now_ns = command.stamp.to_nsec(), rospy.Time.now().to_nsec()
        self.going_on.hear_stopped(Stopped(command.id, stamp_ns, message.plan, message.said, now_ns))

    def takes(self, command: CommandText) -> bool:
        """Open and carry out a command that answers the question whether to go on; returns whether it does."""
        plans = self.going_on.answered(command.text)
        if plans is None:
            return False
        self._commands.open(command, stage=EXECUTOR_STAGE)
        if plans:
            plan = one_after_the_other(plans)
            self._command_plan.publish(CommandPlan(command=command_to_message(command), plan=plan))
        else:
            sentence = "All right, I will not go on."
            self._on_declined(Ending(command, Outcome.REFUSED, OWN_STAGE, DECLINED, sentence))
        return True


def one_after_the_other(plans: Sequence[Plan]) -> Plan:
    """Return one plan for several."""
    if len(plans) == 1:
        return Plan(nodes=plans[0].nodes)
    root = PlanNode(kind=PlanNode.SEQUENCE, label=", then ".join(plan.nodes[0].label for plan in plans))
    nodes = [root]
    for plan in plans:
        first = len(nodes)
        root.children.append(first)
        for node in plan.nodes:
            node.children = [first + child for child in node.children]
            node.after = [first + before for before in node.after]
            nodes.append(node)
    return Plan(nodes=nodes)
