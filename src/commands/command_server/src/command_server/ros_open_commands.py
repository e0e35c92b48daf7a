"""Open commands, kept for a command server that is restarted."""

from typing import Tuple

import rospy

from command_server.open_commands import CommandText
from roboframenet_ros.ros_kept_value import KeptValue


class OpenCommandStore:
    """Keeps the open commands in a file."""

    def __init__(self, parameter: str) -> None:
        self._record = KeptValue(parameter)

    def load(self) -> Tuple[CommandText, ...]:
        """Return the commands that the previous run left open; empty, with a warning, if they cannot be read."""
        try:
            commands = [
                CommandText(str(entry["id"]), int(entry["stamp_ns"]), str(entry["text"]), str(entry.get("order", "")))
                for entry in self._record.load() or ()
            ]
            return tuple({command.command_id: command for command in commands}.values())
        except (ValueError, KeyError, TypeError) as error:
            rospy.logwarn("the open commands of the previous run cannot be read: %s", error)
            return ()

    def save(self, commands: Tuple[CommandText, ...]) -> None:
        """Save the commands."""
        self._record.save(
            [{"id": one.command_id, "stamp_ns": one.stamp_ns, "text": one.text, "order": one.order} for one in commands]
        )

    def close(self) -> None:
        """Remove the file when no command is open."""
        self._record.close()
