"""Reads which topics and servers a stop applies to."""

import rospy

from command_server.open_commands import STOP_STAGE
from robot_stop.settings import BrakeSettings


def read_brake_settings() -> BrakeSettings:
    """Read the velocity topics and the servers to cancel; by default the parameters of the stop server.

    Raises:
        ParameterError: a parameter is out of its range
    """
    return BrakeSettings(
        velocity_topics=rospy.get_param(
            "~velocity_topics", rospy.get_param(f"{STOP_STAGE}/velocity_topics", BrakeSettings.velocity_topics)
        ),
        also_cancel=rospy.get_param(
            "~also_cancel", rospy.get_param(f"{STOP_STAGE}/also_cancel", BrakeSettings.also_cancel)
        ),
    )
