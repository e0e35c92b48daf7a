"""The frame `stopping` for sentences that reach the stop server through language."""
import threading
from typing import Callable

import rospy

SERVER = "stopping"
FRAME = "stopping"


class StoppingFrame:
    """Offers an RFNServer for the frame, from a thread of its own.

    The import and the registration may take long or fail, and the short way must not wait for either.
    """

    def __init__(self, stop: Callable[[], None]) -> None:
        """Prepare the thread.

        Args:
            stop: stops the robot; called from a thread of the action server
        """
        self._stop = stop
        self._thread = threading.Thread(target=self._offer, name="stopping_frame", daemon=True)

    def start(self) -> None:
        """Begin to offer the frame; returns at once."""
        self._thread.start()

    def close(self, *, timeout_s: float) -> None:
        """Wait for the thread to end."""
        self._thread.join(timeout_s)

    def _offer(self) -> None:
        try:
            from rfnserver import RFNServer
            server = RFNServer(SERVER, lambda frame: self._stop())
            server.register_with_frame(FRAME)
            server.start()
        except Exception as error:  # boundary: whatever is wrong with the long way, the short way works on
            rospy.logwarn("the frame %s is not offered: %s: %s", FRAME, type(error).__name__, error)
            return
        self._server = server
