"""The emergency stop as other nodes see it: the latched topic, and the file behind it."""

import threading
import time
from pathlib import Path
from typing import Callable

import rospy
from roboframenet_msgs.msg import EmergencyStop

from roboframenet_ros.home_folder import file_in_ros_home
from robot_stop.emergency import Emergency, newer
from robot_stop.emergency_file import EmergencyFile

TOPIC = "emergency_stop"
RELEASE = f"{TOPIC}/release"
#: A number that is so far ahead of the clock, in seconds, is none: nothing could count above it later.
_FARTHEST_NUMBER_S = 86_400
#: The node that keeps the emergency stop, and alone releases it.
OWNER = "stop_server"


def emergency_file() -> EmergencyFile:
    """Return the file of this robot, below ROS_HOME; each namespace is another robot."""
    robot = rospy.get_namespace().strip("/").replace("/", ".")
    return EmergencyFile(Path(file_in_ros_home(f"emergency_stop.{robot}.json" if robot else "emergency_stop.json")))


def emergency_to_message(state: Emergency) -> EmergencyStop:
    """Turn a state into a message."""
    return EmergencyStop(
        number=state.number,
        is_engaged=state.is_engaged,
        by=state.by,
        since_s=state.since_s,
        sentence=state.sentence,
    )


class EmergencyWatch:
    """Knows whether the emergency stop holds, also while the node that keeps it is dead. Any thread may ask.

    Subscribes: ``emergency_stop``. Anybody may say that it holds. That it was released counts only from the node that
    keeps it: a bag that is played, or another program, must not let the robot go.
    """

    def __init__(self, on_change: Callable[[Emergency], None] = lambda state: None) -> None:
        """Read the file, and listen.

        Args:
            on_change: called with each new state, from a thread of rospy; must not block
        """
        self._on_change = on_change
        self._lock = threading.Lock()
        self._owner = rospy.resolve_name(OWNER)
        self._state = emergency_file().load()
        self._subscriber = rospy.Subscriber(TOPIC, EmergencyStop, self._hear, queue_size=10)

    @property
    def state(self) -> Emergency:
        """The newest state."""
        return self._state

    def know(self, state: Emergency, *, is_certain: bool = False) -> None:
        """Take a state if it is newer.

        Args:
            state: that this process has made, or has heard of
            is_certain: whether it also counts against a state with an equal number
        """
        with self._lock:
            before = self._state
            self._state = state if is_certain and state.number == before.number else newer(before, state)
            is_new = self._state != before
        if is_new:
            self._on_change(self._state)

    def _hear(self, message: EmergencyStop) -> None:
        caller = (message._connection_header or {}).get("callerid", "")
        if message.number > time.time() + _FARTHEST_NUMBER_S:
            rospy.logerr("%s tells an emergency stop with the impossible number %d", caller, message.number)
        elif message.is_engaged or caller == self._owner:
            told = Emergency(message.number, message.is_engaged, message.by, message.since_s)
            self.know(told, is_certain=caller == self._owner)
        elif message.number > self._state.number:
            rospy.logwarn("%s says that the emergency stop was released; only %s can say so", caller, self._owner)
