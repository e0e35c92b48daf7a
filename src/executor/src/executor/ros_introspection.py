"""Publishes the running machine for smach_viewer, without ever holding it up."""

import queue
import threading
from dataclasses import dataclass, field
from typing import Optional

import rospy

import smach
import smach_ros

# How long a run waits for its introspection, so that smach_viewer shows it from the start.
_SHOW_TIMEOUT_S = 0.3


@dataclass(frozen=True)
class _View:
    """A machine that smach_viewer shows; None for none."""

    machine: Optional[smach.StateMachine]
    label: str = ""
    is_done: threading.Event = field(default_factory=threading.Event)


class Introspection:
    """Owns the topics of smach_viewer, one set for each machine.

    Opening and closing them calls the master, for which rospy has no deadline, so a thread of its own does it. While it
    hangs, machines run without introspection.
    """

    def __init__(self, *, is_enabled: bool) -> None:
        """Start the thread, if introspection is enabled."""
        self._views: queue.Queue[_View] = queue.Queue()
        self._last = _View(None)
        self._is_enabled = is_enabled
        if is_enabled:
            # A daemon: a master that hangs must not keep the process alive.
            threading.Thread(target=self._work, name="introspection", daemon=True).start()

    def show(self, machine: smach.StateMachine, *, label: str) -> None:
        """Show a machine under a label; returns when it is published, or after a deadline."""
        if not self._request(_View(machine, label)).is_done.wait(_SHOW_TIMEOUT_S):
            rospy.logwarn_throttle(30.0, "Introspection is delayed: the master does not answer")

    def hide(self) -> None:
        """Hide the machine; returns at once."""
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
                # A machine that was requested while the master hung has ended by now.
                if view.machine is not None and view is self._last:
                    viewer = smach_ros.IntrospectionServer("executor", view.machine, f"/{view.label}")
                    viewer.start()
            except Exception as fault:  # boundary: introspection must not keep a command from running
                rospy.logwarn("Introspection is disabled: %s: %s", type(fault).__name__, fault)
            finally:
                view.is_done.set()
