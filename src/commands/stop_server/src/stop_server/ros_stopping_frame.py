"""The frames `stopping` and `waiting`, for sentences that reach the stop server through the pipeline."""

import threading
import time
from typing import Any, Callable

import rospy

SERVER = "stopping"
STOPPING = "stopping"
FRAMES = (STOPPING, "waiting")
#: How often a robot that waits checks for another command, seconds.
POLL_S = 0.05


class StoppingFrame:
    """Offers an RFNServer for the frames, from a thread of its own.

    The import and the registration may take long or fail, and a stop must not wait for either.
    """

    def __init__(self, stop: Callable[[], str]) -> None:
        """Prepare the thread.

        Args:
            stop: stops the robot and returns why it may still move, empty when it stands still; called from a thread of
                the action server
        """
        self._stop = stop
        self._thread = threading.Thread(target=self._offer, name="stopping_frame", daemon=True)

    def start(self) -> None:
        """Start to offer the frames; returns at once."""
        self._thread.start()

    def close(self, *, timeout_s: float) -> None:
        """Wait for the thread to end."""
        self._thread.join(timeout_s)

    def _offer(self) -> None:
        try:
            from rfnserver import RFNServer

            server = RFNServer(SERVER, lambda frame: self._carry_out(server, frame))
            for frame_name in FRAMES:
                # "Stop when you see a wall" is said while something runs, and waits beside it.
                statement = {"occupies": ["nothing"]} if frame_name == STOPPING else {}
                server.register_with_frame(frame_name, **statement)
            server.start()
        except Exception as error:  # boundary: a fault of the pipeline must not keep stops from working
            rospy.logwarn("the frames %s are not offered: %s: %s", ", ".join(FRAMES), type(error).__name__, error)
            return
        self._server = server

    def _carry_out(self, server: Any, frame: Any) -> None:
        """Stop; "wait for two minutes" also stands still for that time, unless another command comes."""
        from rfnserver.arguments import ArgumentError, argument, duration_s

        reason = self._stop()
        if reason:
            server.set_aborted(None, reason)
            return
        if not argument(frame, "duration"):
            return
        try:
            end = time.monotonic() + duration_s(frame, "duration")
        except ArgumentError as reason:
            server.set_aborted(None, str(reason))
            return
        while time.monotonic() < end and not server.is_preempt_requested() and not rospy.is_shutdown():
            time.sleep(POLL_S)
