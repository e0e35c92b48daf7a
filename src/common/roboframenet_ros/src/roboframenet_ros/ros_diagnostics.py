"""Publishes how a node is on ``/diagnostics``, once a second (REP 107)."""

import threading
from functools import partial
from typing import Any, Callable, List, Mapping

import diagnostic_updater
import rospy
from diagnostic_msgs.msg import DiagnosticArray

from roboframenet_ros.bounded_text import one_line
from roboframenet_ros.health import Health, Level
from roboframenet_ros.ros_publishing import is_shutting_down

_PERIOD_S = 1.0
_JOIN_TIMEOUT_S = 2.0
# REP 107 wants the serial number of a device here; diagnostic_updater warns of an empty one.
_NO_HARDWARE = "none"


class Diagnostics:
    """Asks a node once a second how it is, and publishes that while somebody listens.

    The period is one of the wall clock: a node says how it is also while a simulation is paused.
    """

    def __init__(self, states: Mapping[str, Callable[[], Health]]) -> None:
        """Start the thread.

        Args:
            states: by the name of the node, or of each stage in it, what returns its state, at once
        """
        self._updater = _Updater()
        self._updater.setHardwareID(_NO_HARDWARE)
        for name, health in states.items():
            self._updater.add(f"{name}: state", partial(_fill, health))
        self._is_closing = threading.Event()
        self._thread = threading.Thread(target=self._publish_on, name="diagnostics", daemon=True)
        self._thread.start()
        rospy.on_shutdown(self._close)

    def _close(self) -> None:
        self._is_closing.set()
        self._thread.join(_JOIN_TIMEOUT_S)

    def _publish_on(self) -> None:
        while not self._is_closing.wait(_PERIOD_S):
            if not self._updater.publisher.get_num_connections():
                continue
            try:
                self._updater.force_update()
            except rospy.ROSException:
                if is_shutting_down():
                    return
                raise


class _Updater(diagnostic_updater.Updater):
    """An updater that puts no name before those of its tasks: they begin with the name of the node already."""

    def publish(self, msg: Any) -> None:
        """Publish one status, or several."""
        statuses: List[Any] = msg if isinstance(msg, list) else [msg]
        array = DiagnosticArray(status=statuses)
        array.header.stamp = rospy.Time.now()
        self.publisher.publish(array)


def _fill(
    state: Callable[[], Health], status: diagnostic_updater.DiagnosticStatusWrapper
) -> diagnostic_updater.DiagnosticStatusWrapper:
    try:
        health = state()
    except Exception as error:  # boundary: a node that cannot say how it is goes on with its work
        health = Health(Level.ERROR, f"Cannot say how it is: {type(error).__name__}: {error}")
    status.summary(int(health.level), one_line(health.message))
    for name, value in health.values.items():
        status.add(name, one_line(str(value)))
    return status
