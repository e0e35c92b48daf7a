"""A value that outlives its node, as long as the master lives."""

import re
import time
import uuid
from pathlib import Path

import rospy

from roboframenet_ros.home_folder import file_in_ros_home
from roboframenet_ros.kept_file import KeptFile, remove_forgotten

_KEY = re.compile("[0-9a-f]{32}")


class KeptValue:
    """Keeps a value in a file of this machine: to ask the master at each change would cost each command a millisecond.

    The master holds only the name of the file, in a parameter, so that a node that is started again under the same
    master finds its value, and a node under a new master finds none.
    """

    def __init__(self, parameter: str) -> None:
        """Ask the master for the name of the file, or give it one.

        Args:
            parameter: holds the name of the file
        """
        self._parameter = parameter
        key = rospy.get_param(parameter, "")
        if not isinstance(key, str) or not _KEY.fullmatch(key):
            key = uuid.uuid4().hex
            rospy.set_param(parameter, key)
        folder = Path(file_in_ros_home("roboframenet"))
        remove_forgotten(folder, now_s=time.time())
        self._file = KeptFile(folder / f"{key}.json")
        self._is_empty = False

    def load(self) -> object:
        """Return the value that the previous run left; None for none.

        Raises:
            ValueError: it cannot be read, or is not JSON
        """
        try:
            return self._file.load()
        except OSError as error:
            raise ValueError(str(error)) from error

    def save(self, value: object) -> None:
        """Set the value. If that fails, a warning in the log says so."""
        self._is_empty = not value
        try:
            self._file.save(value)
        except OSError as error:
            rospy.logwarn_throttle(10.0, f"{self._parameter} cannot be kept: {error}")

    def close(self) -> None:
        """Close the file, and remove it when the value is empty."""
        if self._is_empty:
            self._file.remove()
        else:
            self._file.close()
