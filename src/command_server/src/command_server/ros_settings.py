"""Reads the parameters of the node."""

import rospy

from command_server.command_book import STOP_STAGE
from command_server.settings import Settings
from robot_stop.settings import BrakeSettings


def read_settings() -> Settings:
    """Read the private parameters.

    Raises:
        ValueError: a parameter is out of its range
    """
    return Settings(
        stage_timeout_s=rospy.get_param("~stage_timeout_s", Settings.stage_timeout_s),
        executor_timeout_s=rospy.get_param("~executor_timeout_s", Settings.executor_timeout_s),
        stop_timeout_s=rospy.get_param("~stop_timeout_s", Settings.stop_timeout_s),
        cancel_timeout_s=rospy.get_param("~cancel_timeout_s", Settings.cancel_timeout_s),
        pause_after_stop_s=rospy.get_param("~pause_after_stop_s", Settings.pause_after_stop_s),
        max_text_length=rospy.get_param("~max_text_length", Settings.max_text_length),
        max_open_commands=rospy.get_param("~max_open_commands", Settings.max_open_commands),
    )


def read_brake_settings() -> BrakeSettings:
    """Read where velocities go and what is cancelled besides: what the stop server was told, unless told otherwise.

    Raises:
        ValueError: a parameter is out of its range
    """
    return BrakeSettings(
        velocity_topics=rospy.get_param(
            "~velocity_topics", rospy.get_param(f"{STOP_STAGE}/velocity_topics", BrakeSettings.velocity_topics)
        ),
        also_cancel=rospy.get_param(
            "~also_cancel", rospy.get_param(f"{STOP_STAGE}/also_cancel", BrakeSettings.also_cancel)
        ),
    )
