"""A thread that makes one search after the other."""

import queue
import threading
from typing import Callable

import rospy

#: Searches that wait at most; what comes then is dropped.
_MOST_WAITING = 20


class SearchThread:
    """Makes searches in the order in which they come, until ROS shuts down.

    A search of pocketsphinx leaves the interpreter to others, so that two of these threads use two cores.
    """

    def __init__(self, name: str) -> None:
        """
        Args:
            name: of the thread
        """
        self._waiting: queue.Queue[Callable[[], None]] = queue.Queue(_MOST_WAITING)
        threading.Thread(target=self._run, name=name, daemon=True).start()

    def later(self, search: Callable[[], None]) -> None:
        """Have a search made; returns at once."""
        try:
            self._waiting.put_nowait(search)
        except queue.Full:
            rospy.logwarn("too much to hear; dropping some")

    def _run(self) -> None:
        while not rospy.is_shutdown():
            try:
                search = self._waiting.get(timeout=0.5)
            except queue.Empty:
                continue
            try:
                search()
            except Exception:  # boundary: what goes wrong with one sound must not end the thread
                rospy.logerr("a sound could not be heard", exc_info=True)
