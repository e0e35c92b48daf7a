"""Preemption of a machine when the program ends."""

import threading
import time
from typing import Any

import rospy

import smach

# How long the end of the program waits for a machine to take the request.
REQUEST_GRACE_S = 2.0
# How long the end of the program waits for the machine to end, and how often it looks.
END_GRACE_S = 60.0
END_POLL_S = 0.05


def set_preempt_handler(sc: smach.State) -> None:
    """Ask a container to stop when the node shuts down, for example by Ctrl-C, and let it end first.

    The outermost container is enough: it hands the request on. While it ends, for at most 60 s, the node is up: the
    states behind "preempted" still reach topics, services and actions. Run the machine in a thread of its own for this:
    Ctrl-C interrupts the main thread, so a machine that the main thread runs cannot go on, and is only asked; not even
    that, if it was about to start a state.
    """

    def stop() -> None:
        # In a thread of its own: Ctrl-C interrupts the main thread, which may hold the locks that the request needs.
        thread = threading.Thread(target=sc.request_preempt, name="smach_preempt_handler", daemon=True)
        thread.start()
        thread.join(REQUEST_GRACE_S)
        _wait_for_end(sc)

    rospy.core.add_client_shutdown_hook(stop)


def _wait_for_end(sc: Any) -> None:
    """Wait until a container has ended, unless this thread is one that runs it."""
    if not isinstance(sc, smach.Container) or sc.is_run_by_this_thread():
        return
    give_up_at = time.monotonic() + END_GRACE_S
    while sc.is_running():
        if time.monotonic() >= give_up_at:
            rospy.logerr("The node shuts down while its state machine still runs: it was asked to stop and did not.")
            return
        time.sleep(END_POLL_S)
