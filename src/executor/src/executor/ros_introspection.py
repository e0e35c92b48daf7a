"""Publishes the running machine for smach_viewer, without ever holding it up."""

import queue
import threading
import time
from dataclasses import dataclass
from typing import Optional

import rospy
from smach_msgs.msg import SmachContainerInitialStatusCmd, SmachContainerStatus, SmachContainerStructure

import smach
import smach_ros
from smach_ros.introspection import INIT_TOPIC, STATUS_TOPIC, STRUCTURE_TOPIC

_SERVER_NAME = "executor"
# The first goal of a machine goes out before its introspection takes the interpreter.
_HEAD_START_S = 0.02


@dataclass(frozen=True)
class _View:
    """A machine that smach_viewer shows; None for none."""

    machine: Optional[smach.Container]
    label: str = ""


class Introspection:
    """Shows one machine after the other on the topics of smach_viewer.

    The topics stay open: a viewer keeps its connections and misses no message of the next machine, and a machine costs
    no call to the master, for which rospy has no deadline. A thread of its own does all of it: machines never wait.
    """

    def __init__(self, *, is_enabled: bool) -> None:
        """Start the thread, if introspection is enabled."""
        self._views: queue.SimpleQueue[_View] = queue.SimpleQueue()
        self._last = _View(None)
        self._is_enabled = is_enabled
        if is_enabled:
            # A daemon: a master that hangs must not keep the process alive.
            threading.Thread(target=self._work, name="introspection", daemon=True).start()

    def show(self, machine: smach.Container, *, label: str) -> None:
        """Show a machine under a label, unless it ends at once; returns at once."""
        self._request(_View(machine, label))

    def hide(self) -> None:
        """Hide the machine; returns at once."""
        self._request(_View(None))

    def _request(self, view: _View) -> None:
        self._last = view
        if self._is_enabled:
            self._views.put(view)

    def _work(self) -> None:
        # While these exist, those of the machines are copies that the master need not know.
        self._topics = (
            rospy.Publisher(_SERVER_NAME + STATUS_TOPIC, SmachContainerStatus, queue_size=10),
            rospy.Publisher(_SERVER_NAME + STRUCTURE_TOPIC, SmachContainerStructure, queue_size=10),
            rospy.Subscriber(_SERVER_NAME + INIT_TOPIC, SmachContainerInitialStatusCmd),
        )
        viewer: Optional[smach_ros.IntrospectionServer] = None
        while True:
            view = self._views.get()
            try:
                if viewer is not None:
                    viewer.stop()
                    viewer = None
                if view.machine is None:
                    continue
                time.sleep(_HEAD_START_S)
                # A machine that has ended by now is not shown.
                if view is self._last:
                    viewer = smach_ros.IntrospectionServer(_SERVER_NAME, view.machine, f"/{view.label}")
                    viewer.start()
            except Exception as fault:  # boundary: introspection must not keep a command from running
                rospy.logwarn("Introspection is disabled: %s: %s", type(fault).__name__, fault)
