"""The action ``command``: commands of programs, many goals at a time."""

from typing import Callable, Dict

import actionlib
import rospy
from roboframenet_msgs.msg import ExecuteCommandAction, ExecuteCommandFeedback, ExecuteCommandResult, Reply, StageEvent

from roboframenet_ros.ros_quiet_action_server import QuietActionServer


class CommandActionServer:
    """Goals of the action ``command``, by id.

    The callbacks run in threads of actionlib and under its lock, so they must only enqueue. All methods are for the one
    thread that owns the commands.
    """

    def __init__(
        self, *, on_goal: Callable[[actionlib.ServerGoalHandle], None], on_cancel: Callable[[str], None]
    ) -> None:
        """Create the server without starting it.

        Args:
            on_goal: called with the handle of each new goal
            on_cancel: called with the id of a goal that its client cancels
        """
        self._handles: Dict[str, actionlib.ServerGoalHandle] = {}
        self._heirs: Dict[str, str] = {}
        self._server = QuietActionServer(
            "command",
            ExecuteCommandAction,
            on_goal,
            lambda handle: on_cancel(handle.get_goal_id().id),
            auto_start=False,
        )

    def start(self) -> None:
        """Start to accept goals."""
        self._server.start()

    def accept(self, handle: actionlib.ServerGoalHandle) -> None:
        """Accept a goal."""
        self._handles[handle.get_goal_id().id] = handle
        handle.set_accepted()

    def hand_over(self, goal_id: str, *, command_id: str) -> None:
        """Let a goal end with another command: the one after the stop that it began with."""
        self._handles[command_id] = self._handles.pop(goal_id)
        self._heirs[goal_id] = command_id

    def command_of(self, goal_id: str) -> str:
        """Return the id of the command that a goal ends with: its own, unless it was handed over."""
        return self._heirs.get(goal_id, goal_id)

    def feed_back(self, event: StageEvent) -> None:
        """Send the event of a stage to the client; nothing for commands that came as text."""
        handle = self._handles.get(event.command.id)
        if handle is not None:
            handle.publish_feedback(ExecuteCommandFeedback(event=event))

    def finish(self, reply: Reply, *, command_id: str) -> None:
        """End the goal with this id; nothing for commands that came as text.

        Done is SUCCEEDED, superseded is PREEMPTED, all else is ABORTED.
        """
        handle = self._handles.pop(command_id, None)
        if handle is None:
            return
        self._heirs.pop(handle.get_goal_id().id, None)
        end = {Reply.DONE: handle.set_succeeded, Reply.SUPERSEDED: handle.set_canceled}.get(
            reply.outcome, handle.set_aborted
        )
        end(ExecuteCommandResult(reply=reply), reply.sentence)
        rospy.logdebug("goal %s ended", command_id)
