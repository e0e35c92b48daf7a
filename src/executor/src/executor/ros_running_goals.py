"""Goals that must not outlive the executor."""

import threading
import time
from typing import Optional, Sequence, Tuple

import rospy
from actionlib_msgs.msg import GoalID

from roboframenet_ros.ros_kept_value import KeptValue

_CONNECT_TIMEOUT_S = 5.0


class RunningGoals:
    """Keeps the running goal in a file; an executor that was killed cancels it when it is restarted."""

    def __init__(self, parameter: str = "~running_goals") -> None:
        self._record = KeptValue(parameter)
        self._thread: Optional[threading.Thread] = None

    def start(self) -> None:
        """Cancel the goal of the previous run, in a thread of its own."""
        try:
            left_over = [(str(entry["server"]), str(entry["goal_id"])) for entry in self._record.load() or ()]
        except (ValueError, KeyError, TypeError) as error:
            rospy.logwarn("goals of the previous run are not cancelled: %s", error)
            return
        if left_over:
            self._thread = threading.Thread(
                target=self._cancel, args=(left_over,), name="cancel_left_over", daemon=True
            )
            self._thread.start()

    def note(self, server: str, goal_id: str) -> None:
        """A goal was sent."""
        self._record.save([{"server": server, "goal_id": goal_id}])

    def clear(self) -> None:
        """No goal runs any more."""
        self._record.save([])

    def close(self, *, timeout_s: float) -> None:
        """End the thread, and remove an empty record."""
        if self._thread is not None:
            self._thread.join(timeout_s)
        self._record.close()

    def _cancel(self, left_over: Sequence[Tuple[str, str]]) -> None:
        publishers = [
            (rospy.Publisher(f"{server}/cancel", GoalID, queue_size=10), server, goal_id)
            for server, goal_id in left_over
        ]
        end_s = time.monotonic() + _CONNECT_TIMEOUT_S
        for publisher, server, goal_id in publishers:
            while publisher.get_num_connections() == 0 and time.monotonic() < end_s:
                time.sleep(0.05)
            rospy.logwarn("cancelled the goal that the killed executor had left at %s", server)
            publisher.publish(GoalID(id=goal_id))
