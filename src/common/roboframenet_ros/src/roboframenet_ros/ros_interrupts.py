"""Ends a node on Ctrl-C, in a thread of its own."""

import os
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

    The thread hears of the signal by a pipe, into which the interpreter writes in whichever thread the signal arrives.
    A handler in Python would run only when the main thread does, and that may be waiting for seconds.
    """

    def __init__(self) -> None:
        """Take the signals over; call it in the main thread, after ``rospy.init_node``."""
        self._numbers, written = os.pipe()
        # What is written from a signal handler must not wait.
        os.set_blocking(written, False)
        self._is_asked = False
        # A daemon: it must not keep a node alive that ends by itself.
        self._thread = threading.Thread(target=self._shut_down, name="shutdown", daemon=True)
        self._thread.start()
        signal.set_wakeup_fd(written, warn_on_full_buffer=False)
        for number in _SIGNALS:
            signal.signal(number, _do_nothing)

    def wait_for_hooks(self) -> None:
        """Return when all hooks have run, if the process was interrupted."""
        if self._is_asked:
            self._thread.join(_LONGEST_END_S)

    def _shut_down(self) -> None:
        number = 0
        while number not in _SIGNALS:
            (number,) = os.read(self._numbers, 1)
        self._is_asked = True
        rospy.signal_shutdown(f"signal-{number}")


def _do_nothing(_number: int, _frame: Any) -> None:
    """Take the place of the handler that ends a process; the pipe tells of the signal."""
