"""Sends commands to the parser, in order."""

from collections import deque
from typing import Deque

import rospy
from roboframenet_msgs.msg import Command

from command_server.open_commands import CommandText
from command_server.ros_messages import command_to_message
from roboframenet_ros.ros_robots import own_robot


class TextsOut:
    """Commands on their way to the parser. Publishes: ``command_text``."""

    def __init__(self) -> None:
        self._robot = own_robot()
        self._unsent: Deque[CommandText] = deque()
        self._publisher = rospy.Publisher("command_text", Command, queue_size=1000)

    def add(self, command: CommandText) -> None:
        """Send a command soon."""
        self._unsent.append(command)

    def drop(self, command_id: str) -> None:
        """Do not send a command that is answered."""
        self._unsent = deque(command for command in self._unsent if command.command_id != command_id)

    def send(self) -> None:
        """Send what waits, if the parser is there: a message that is published before would be lost."""
        while self._unsent and self._publisher.get_num_connections() > 0:
            self._publisher.publish(command_to_message(self._unsent.popleft(), robot=self._robot))
