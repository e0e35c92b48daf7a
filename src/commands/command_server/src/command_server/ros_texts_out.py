"""Sends commands to the parser, in order."""

from dataclasses import dataclass, field
from typing import Any, Dict, List

import rospy
from roboframenet_msgs.msg import Command

from command_server.open_commands import CommandText
from command_server.ros_messages import command_to_message
from roboframenet_ros.ros_publishing import connections_of, publish_to
from roboframenet_ros.ros_robots import own_robot


@dataclass(frozen=True)
class _Waiting:
    """A command of which no stage has told yet, and the connections that it was sent to."""

    command: CommandText
    sent_to: List[Any] = field(default_factory=list)


class TextsOut:
    """Commands on their way to the parser. Publishes: ``command_text``.

    Others may read the topic, too (a recording, a test), so a connection does not mean that the parser is there. Until
    a stage tells of a command, it is sent to whoever connects.
    """

    def __init__(self) -> None:
        self._robot = own_robot()
        self._waiting: Dict[str, _Waiting] = {}
        self._publisher = rospy.Publisher("command_text", Command, queue_size=1000)

    def add(self, command: CommandText) -> None:
        """Send a command soon."""
        self._waiting[command.command_id] = _Waiting(command)

    def drop(self, command_id: str) -> None:
        """Send a command no more: a stage has told of it, or it is answered."""
        self._waiting.pop(command_id, None)

    def send(self) -> None:
        """Send what waits to whoever has connected."""
        if not self._waiting:
            return
        connections = connections_of(self._publisher)
        for waiting in self._waiting.values():
            new = [connection for connection in connections if connection not in waiting.sent_to]
            if new:
                message = command_to_message(waiting.command, robot=self._robot)
                for connection in new:
                    publish_to(self._publisher, connection, message)
                waiting.sent_to[:] = connections
