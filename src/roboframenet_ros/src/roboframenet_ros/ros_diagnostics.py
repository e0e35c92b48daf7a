"""Publishes how a node is on ``/diagnostics``, once a second (REP 107)."""

import threading
from typing import Callable

import diagnostic_updater
import rospy

from roboframenet_ros.bounded_text import one_line
from roboframenet_ros.health import Health, Level
from roboframenet_ros.ros_publishing import is_shutting_down

_PERIOD_S = 1.0
_JOIN_TIMEOUT_S = 2.0
# REP 107 wants the serial number of a device here; diagnostic_updater warns of an empty one.
_NO_HARDWARE = "none"


class Diagnostics:
    """Asks a node once a second how it is, and publishes that.

    The period is one of the wall clock: a node says how it is also while a simulation is paused.
    """

    def __init__(self, health: Callable[[], Health]) -> None:
        """Start the thread.

        Args:
            health: returns the state of the node, at once
        """
        self._health = health
        self._updater = diagnostic_updater.Updater()
        self._updater.setHardwareID(_NO_HARDWARE)
        self._updater.add("state", self._fill)
        self._is_closing = threading.Event()
        self._thread = threading.Thread(target=self._publish_on, name="diagnostics", daemon=True)
        self._thread.start()
        rospy.on_shutdown(self._close)

    def _close(self) -> None:
        self._is_closing.set()
        self._thread.join(_JOIN_TIMEOUT_S)

    def _publish_on(self) -> None:
        while not self._is_closing.wait(_PERIOD_S):
            try:
                self._updater.force_update()
            except rospy.ROSException:
                if is_shutting_down():
                    return
                raise

    def _fill(self, status: diagnostic_updater.DiagnosticStatusWrapper) -> diagnostic_updater.DiagnosticStatusWrapper:
        try:
            health = self._health()
        except Exception as error:  # boundary: a node that cannot say how it is goes on with its work
            health = Health(Level.ERROR, f"Cannot say how it is: {type(error).__name__}: {error}")
        status.summary(int(health.level), one_line(health.message))
        for name, value in health.values.items():
            status.add(name, one_line(str(value)))
        return status
