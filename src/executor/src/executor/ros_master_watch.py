"""Notices when the ROS master is gone."""

import threading
import time
import xmlrpc.client
from typing import Callable, Optional

import rosgraph
import rospy

from roboframenet_ros.ros_master import NO_ANSWER
from roboframenet_ros.timed_transport import TimedTransport

#: The master is asked so often, seconds.
_PERIOD_S = 1.0
#: One refused connection may be a restart; it is asked again after this time.
_SECOND_LOOK_S = 0.3
_TIMEOUT_S = 2.0


class MasterWatch:
    """Asks the master whether it is there, in a thread of its own.

    It is gone when nothing listens at its address, or when it has not answered for long: connections that exist go on,
    but no node finds another any more, and what a plan begins then may not be reached by those who could stop it.
    """

    def __init__(self, on_lost: Callable[[], None], *, silence_s: float) -> None:
        """
        Args:
            on_lost: called from the thread when the master is gone
            silence_s: how long a master that hangs may be silent
        """
        self._on_lost = on_lost
        self._silence_s = silence_s
        self._is_lost = threading.Event()
        self._is_closed = threading.Event()
        self._proxy = xmlrpc.client.ServerProxy(rosgraph.get_master_uri(), transport=TimedTransport(_TIMEOUT_S))
        self._thread = threading.Thread(target=self._run, name="master_watch", daemon=True)

    @property
    def is_lost(self) -> bool:
        """Whether the master is gone."""
        return self._is_lost.is_set()

    def start(self) -> None:
        """Begin to ask."""
        self._thread.start()

    def close(self) -> None:
        """End; returns at once."""
        self._is_closed.set()

    def _run(self) -> None:
        heard_s = time.monotonic()
        refused_s: Optional[float] = None
        while not self._is_closed.wait(_PERIOD_S if refused_s is None else _SECOND_LOOK_S):
            try:
                self._proxy.getPid(rospy.get_name())
            except ConnectionRefusedError:
                if refused_s is None:
                    refused_s = time.monotonic()
                    continue
                self._lose()
                continue
            except NO_ANSWER:
                refused_s = None
                if time.monotonic() - heard_s > self._silence_s:
                    self._lose()
                continue
            refused_s, heard_s = None, time.monotonic()
            if self._is_lost.is_set():
                rospy.logwarn("the ROS master answers again")
                self._is_lost.clear()

    def _lose(self) -> None:
        if not self._is_lost.is_set():
            self._is_lost.set()
            rospy.logerr("the ROS master is gone")
            self._on_lost()
