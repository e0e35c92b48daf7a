"""Waits end by the monotonic clock: actionlib waits by the ROS time, which is 0 before a simulator's first message."""

import re
from pathlib import Path
from typing import List

import pytest

from roboframenet_testing.workspace import REPOSITORY, modules

#: Each with what takes its place.
BY_OTHER_CLOCKS = {
    r"\.wait_for_server\(": "roboframenet_ros.ros_waiting.wait_for_action_server",
    r"\.(wait_for_result|send_goal_and_wait)\(": "a queue, or a condition, with a timeout",
    r"rospy\.wait_for_message\(": "roboframenet_ros.ros_waiting.wait_for_message",
    r"rospy\.(sleep|Timer)\(": "time.sleep, or the wait of a threading.Event",
}


def sources() -> List[Path]:
    """Return the modules of our packages and the benchmarks, without their tests."""
    return sorted([*modules().values(), *REPOSITORY.glob("benchmarks/**/*.py")])


@pytest.mark.parametrize("pattern", BY_OTHER_CLOCKS)
def test_no_wait_ends_by_another_clock(pattern: str) -> None:
    found = [
        f"{path.relative_to(REPOSITORY)}:{number}: take {BY_OTHER_CLOCKS[pattern]}"
        for path in sources()
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if re.search(pattern, line)
    ]
    assert not found, "\n".join(found)
