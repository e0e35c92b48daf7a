"""Open commands on the parameter server, for a command server that is restarted."""

from typing import Tuple

import rospy

from command_server.open_commands import CommandText
from roboframenet_ros.ros_persistent_parameter import PersistentParameter


class OpenCommandStore:
    """Keeps the open commands in a private parameter."""

    def __init__(self, parameter: str = "~open_commands") -> None:
        self._record = PersistentParameter(parameter)

    def load(self) -> Tuple[CommandText, ...]:
        """Return the commands that the previous run left open; empty, with a warning, if they cannot be read."""
        try:
            commands = [
                CommandText(command_id=str(entry["id"]), stamp_ns=int(entry["stamp_ns"]), text=str(entry["text"]))
                for entry in self._record.load() or ()
            ]
            return tuple({command.command_id: command for command in commands}.values())
        except (ValueError, KeyError, TypeError) as error:
            rospy.logwarn("the open commands of the previous run cannot be read: %s", error)
            return ()

    def save(self, commands: Tuple[CommandText, ...], *, timeout_s: float) -> bool:
        """Save the commands; returns whether they were written in time."""
        return self._record.save(
            [{"id": command.command_id, "stamp_ns": command.stamp_ns, "text": command.text} for command in commands],
            timeout_s=timeout_s,
        )

    def close(self, *, timeout_s: float) -> None:
        """End the thread that writes."""
        self._record.close(timeout_s=timeout_s)
