"""Whether the language service of a fleet runs, as the node ``fleet`` tells the robots."""

import time

import rospy
from roboframenet_msgs.msg import FleetService

from roboframenet_ros.ros_robots import own_robot

#: The fleet tells it each second; what is older says nothing. Seconds.
_FRESH_S = 2.5
DOWN = "The language service is not running: parser, framer or registrar is gone. Please say it again later."


class LanguageService:
    """Follows it. Subscribes: ``fleet_service``, for a robot of a fleet."""

    def __init__(self) -> None:
        self._down_s = float("-inf")
        self._subscriber = (
            rospy.Subscriber("fleet_service", FleetService, self._hear, queue_size=1) if own_robot() else None
        )

    @property
    def is_down(self) -> bool:
        """Whether the fleet has just told that it does not run; a fleet that is silent tells nothing."""
        return time.monotonic() - self._down_s <= _FRESH_S

    def _hear(self, service: FleetService) -> None:
        self._down_s = float("-inf") if service.is_up else time.monotonic()
