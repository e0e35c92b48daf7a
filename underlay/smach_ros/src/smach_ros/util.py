"""Preemption of a machine when the program ends."""

import threading
import time
from typing import Any, Callable, Iterator

import rospy

import smach
from smach_ros.simple_action_state import SimpleActionState

# How long the end of the program waits for a machine to take the request.
REQUEST_GRACE_S = 2.0
# How long the end of the program waits for the machine to end, and how often it looks.
END_GRACE_S = 60.0
END_POLL_S = 0.05
# How long it waits until servers tell that they have the cancels of their goals.
CANCEL_GRACE_S = 1.0


def set_preempt_handler(sc: smach.State) -> None:
    """Ask a container to stop when the node shuts down, for example by Ctrl-C, and let it end first.

    The outermost container is enough: it hands the request on. While it ends, for at most 60 s, the node is up: the
    states behind "preempted" still reach topics, services and actions. Run the machine in a thread of its own for this:
    Ctrl-C interrupts the main thread, so a machine that the main thread runs cannot go on, and is only asked; not even
    that, if it was about to start a state. Its goals are cancelled then, and the node is up until their servers know
    it, for at most 1 s.
    """

    def stop() -> None:
        # In a thread of its own: Ctrl-C interrupts the main thread, which may hold the locks that the request needs.
        thread = threading.Thread(target=sc.request_preempt, name="smach_preempt_handler", daemon=True)
        thread.start()
        thread.join(REQUEST_GRACE_S)
        _wait_for_end(sc)
        _wait_for_cancels(sc)

    rospy.core.add_client_shutdown_hook(stop)


def _wait_for_end(sc: Any) -> None:
    """Wait until a container has ended, unless this thread is one that runs it."""
    if not isinstance(sc, smach.Container) or sc.is_run_by_this_thread():
        return
    if not _comes_true(lambda: not sc.is_running(), END_GRACE_S):
        rospy.logerr("The node shuts down while its state machine still runs: it was asked to stop and did not.")


def _wait_for_cancels(state: smach.State) -> None:
    """Wait until the servers have the cancels: these are in queues, and the connections are closed behind this."""
    states = tuple(_action_states(state))
    if not _comes_true(lambda: not any(one.is_cancel_on_its_way() for one in states), CANCEL_GRACE_S):
        rospy.logerr("The node shuts down, and a server has not told that it has the cancel of its goal.")


def _action_states(state: smach.State) -> Iterator[SimpleActionState]:
    if isinstance(state, SimpleActionState):
        yield state
    elif isinstance(state, smach.Container):
        for child in state.get_children().values():
            yield from _action_states(child)


def _comes_true(condition: Callable[[], bool], timeout_s: float) -> bool:
    """Wait until a condition holds; False when the time is over."""
    give_up_at = time.monotonic() + timeout_s
    while not condition():
        if time.monotonic() >= give_up_at:
            return False
        time.sleep(END_POLL_S)
    return True
