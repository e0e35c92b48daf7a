"""Files that nobody names lie in the ROS home folder."""

from pathlib import Path

import pytest

from roboframenet_ros.home_folder import file_in_ros_home


def test_the_folder_is_that_of_ros_or_below_the_home(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_HOME", "/robot")
    assert file_in_ros_home("world.sqlite") == "/robot/world.sqlite"
    monkeypatch.delenv("ROS_HOME")
    assert file_in_ros_home("world.sqlite") == str(Path.home() / ".ros" / "world.sqlite")
