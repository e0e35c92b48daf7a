"""Whether the language service of a fleet runs, as the node ``fleet`` tells the robots."""

import time
from typing import Callable

import rospy
from roboframenet_msgs.msg import FleetService

from command_server.open_commands import CommandText, Outcome
from roboframenet_ros.ros_robots import own_robot

#: The fleet tells it each second; what is older says nothing. Seconds.
_FRESH_S = 2.5
_DOWN = "The language service is not running: parser, framer or registrar is gone. Please say it again later."


class LanguageService:
    """Follows it. Subscribes: ``fleet_service``, for a robot of a fleet."""

    def __init__(self) -> None:
        self._down_s = float("-inf")
        self._subscriber = (
            rospy.Subscriber("fleet_service", FleetService, self._hear, queue_size=1) if own_robot() else None
        )

    def declines(self, command: CommandText, answer: Callable[..., None]) -> bool:
        """Answer a command if the fleet has just told that the service does not run; a silent fleet tells nothing.

        Args:
            command: that nobody would understand
            answer: called with the command, its outcome, code and sentence
        Returns:
            whether it was answered
        """
        is_down = time.monotonic() - self._down_s <= _FRESH_S
        if is_down:
            answer(command, Outcome.FAILED, code="STAGE_SILENT", sentence=_DOWN)
        return is_down

    def _hear(self, service: FleetService) -> None:
        self._down_s = float("-inf") if service.is_up else time.monotonic()
