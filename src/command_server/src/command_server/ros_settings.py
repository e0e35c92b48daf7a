"""Reads where a stop publishes and what it cancels."""

import rospy

from command_server.open_commands import STOP_STAGE
from robot_stop.settings import BrakeSettings


def read_brake_settings() -> BrakeSettings:
    """Read where velocities go and what is cancelled besides: the parameters of the stop server, unless given here.

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
