"""Ends a node on Ctrl-C, in a thread of its own."""

import queue
import signal
import threading
from typing import Any

import rospy

_SIGNALS = (signal.SIGINT, signal.SIGTERM)
#: Whoever interrupts a node, such as roslaunch, kills it after about this time, seconds.
_LONGEST_END_S = 15.0


class Interrupts:
    """Has a thread run the hooks of a shutdown when the process is interrupted.

    rospy runs them in the main thread, wherever that is: with a lock in its hand, it waits for itself, or for a thread
    that waits for it, and the node is killed after some time without having ended anything.
    """

    def __init__(self) -> None:
        """Take the signals over; call it in the main thread, after ``rospy.init_node``."""
        # A signal may come while the main thread puts something there.
        self._asked: queue.SimpleQueue[int] = queue.SimpleQueue()
        self._is_asked = False
        # A daemon: it must not keep a node alive that ends by itself.
        self._thread = threading.Thread(target=self._shut_down, name="shutdown", daemon=True)
        self._thread.start()
        for number in _SIGNALS:
            signal.signal(number, self._hear)

    def wait_for_hooks(self) -> None:
        """Return when all hooks have run, if the process was interrupted."""
        if self._is_asked:
            self._thread.join(_LONGEST_END_S)

    def _hear(self, number: int, _frame: Any) -> None:
        self._is_asked = True
        self._asked.put(number)

    def _shut_down(self) -> None:
        rospy.signal_shutdown(f"signal-{self._asked.get()}")
