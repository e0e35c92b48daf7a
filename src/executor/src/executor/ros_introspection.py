"""Shows the machine that runs to smach_viewer, and never keeps it from running."""

import queue
import threading
from dataclasses import dataclass, field
from typing import Optional

import rospy

import smach
import smach_ros

# A machine is shown from its beginning when the master answers as fast as it does.
_SHOW_TIMEOUT_S = 0.3


@dataclass(frozen=True)
class _View:
    """What is to be seen: a machine, or nothing."""

    machine: Optional[smach.StateMachine]
    label: str = ""
    is_done: threading.Event = field(default_factory=threading.Event)


class Introspection:
    """Owns the topics of smach_viewer, one set for each machine.

    To make and to close them asks the master, for which rospy has no deadline: a thread of its own does it. While that
    hangs, machines run unseen.
    """

    def __init__(self, *, is_enabled: bool) -> None:
        """Start the thread, if machines are to be seen at all."""
        self._views: queue.Queue[_View] = queue.Queue()
        self._last = _View(None)
        self._is_enabled = is_enabled
        if is_enabled:
            # A daemon: a master that hangs must not keep the process alive.
            threading.Thread(target=self._work, name="introspection", daemon=True).start()

    def show(self, machine: smach.StateMachine, *, label: str) -> None:
        """Show a machine under a label; returns when it is seen, or when that takes too long."""
        if not self._request(_View(machine, label)).is_done.wait(_SHOW_TIMEOUT_S):
            rospy.logwarn_throttle(30.0, "smach_viewer sees nothing: the master does not answer")

    def hide(self) -> None:
        """Show nothing any more; returns at once."""
        self._request(_View(None))

    def _request(self, view: _View) -> _View:
        self._last = view
        if self._is_enabled:
            self._views.put(view)
        else:
            view.is_done.set()
        return view

    def _work(self) -> None:
        viewer: Optional[smach_ros.IntrospectionServer] = None
        while True:
            view = self._views.get()
            try:
                if viewer is not None:
                    viewer.stop()
                    viewer = None
                # What was wanted before, while the master hung, has ended.
                if view.machine is not None and view is self._last:
                    viewer = smach_ros.IntrospectionServer("executor", view.machine, f"/{view.label}")
                    viewer.start()
            except Exception as fault:  # boundary: nothing that only looks on may keep a command from running
                rospy.logwarn("smach_viewer will see nothing: %s: %s", type(fault).__name__, fault)
            finally:
                view.is_done.set()
