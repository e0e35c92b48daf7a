"""Goals that must not outlive the executor."""

import threading
import time
from typing import Callable, Dict, Optional, Sequence, Tuple

import rospy
from actionlib_msgs.msg import GoalID

from roboframenet_ros.ros_kept_value import KeptValue

_CONNECT_TIMEOUT_S = 5.0


class RunningGoals:
    """Keeps the running goals in a file; an executor that was killed cancels them when it is restarted.

    Any thread may call.
    """

    def __init__(self, parameter: str) -> None:
        self._record = KeptValue(parameter)
        self._thread: Optional[threading.Thread] = None
        self._lock = threading.Lock()
        self._servers: Dict[str, str] = {}

    def start(self) -> None:
        """Cancel the goal of the previous run, in a thread of its own."""
        try:
            left_over = [(str(entry["server"]), str(entry["goal_id"])) for entry in self._record.load() or ()]
        except (ValueError, KeyError, TypeError) as error:
            rospy.logwarn("could not cancel the goals of the previous run: %s", error)
            return
        if left_over:
            self._thread = threading.Thread(
                target=self._cancel, args=(left_over,), name="cancel_left_over", daemon=True
            )
            self._thread.start()

    def note(self, server: str, goal_id: str) -> None:
        """A goal was sent."""
        with self._lock:
            self._servers[goal_id] = server
            self._save()

    def forget(self, goal_id: str) -> None:
        """A goal has ended, or was given up."""
        with self._lock:
            if self._servers.pop(goal_id, None) is not None:
                self._save()

    def _save(self) -> None:
        running = [{"server": server, "goal_id": goal_id} for goal_id, server in self._servers.items()]
        self._record.save(running)

    def close(self, *, timeout_s: float) -> None:
        """End the thread, and remove an empty record."""
        if self._thread is not None:
            self._thread.join(timeout_s)
        self._record.close()

    def _cancel(self, left_over: Sequence[Tuple[str, str]]) -> None:
        connections = _Connections()
        publishers = [
            (rospy.Publisher(f"{server}/cancel", GoalID, subscriber_listener=connections, queue_size=10), goal_id)
            for server, goal_id in left_over
        ]
        for server, _ in left_over:
            rospy.logwarn("cancelling the goal left on %s by a killed executor", server)
        end_s = time.monotonic() + _CONNECT_TIMEOUT_S
        # Any of the subscribers may be the server, and not the first one: each new one gets all of them.
        while connections.wait_for_new(end_s - time.monotonic()):
            for publisher, goal_id in publishers:
                publisher.publish(GoalID(id=goal_id))


class _Connections(rospy.SubscribeListener):
    """Tells when a subscriber has connected."""

    def __init__(self) -> None:
        super().__init__()
        self._is_new = threading.Event()

    def peer_subscribe(
        self, topic_name: str, topic_publish: Callable[[GoalID], None], peer_publish: Callable[[GoalID], None]
    ) -> None:
        """Note it; called by rospy."""
        self._is_new.set()

    def wait_for_new(self, timeout_s: float) -> bool:
        """Wait until a subscriber has connected since the last call; return whether one has."""
        is_new = self._is_new.wait(max(0.0, timeout_s))
        self._is_new.clear()
        return is_new
