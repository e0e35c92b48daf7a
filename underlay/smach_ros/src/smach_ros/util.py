"""Preemption of a machine when the program ends."""

import threading

import rospy

import smach

# How long the end of the program waits for a machine to take the request.
REQUEST_GRACE_S = 2.0


def set_preempt_handler(sc: smach.State) -> None:
    """Ask a state or container to stop when the node shuts down, for example by Ctrl-C.

    The outermost container is enough: it hands the request on.
    """

    def request() -> None:
        # In a thread of its own: Ctrl-C interrupts the main thread, which may hold the locks that the request needs.
        thread = threading.Thread(target=sc.request_preempt, name="smach_preempt_handler", daemon=True)
        thread.start()
        thread.join(REQUEST_GRACE_S)

    rospy.core.add_client_shutdown_hook(request)
