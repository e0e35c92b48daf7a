"""Where files of a robot are kept that nobody names: the ROS home folder."""

import os


def file_in_ros_home(name: str) -> str:
    """Return the path of a file in the folder ``ROS_HOME``, as rospy does: ``~/.ros`` when it is not set."""
    return os.path.join(os.path.expanduser(os.environ.get("ROS_HOME", "~/.ros")), name)
