"""The main thread of a node waits for the shutdown, which a signal may bring at any time."""

import signal
from typing import Callable, List

import pytest
import rospy

from roboframenet_ros import ros_node


@pytest.mark.parametrize("delay_s", (1e-6, 1e-5, 1e-4, 0.05))
def test_signal_that_the_waiting_thread_handles_itself_ends_the_wait(
    monkeypatch: pytest.MonkeyPatch, delay_s: float
) -> None:
    hooks: List[Callable[[], None]] = []
    is_over: List[bool] = []

    def end(*_: object) -> None:
        is_over.append(True)
        for hook in hooks:
            hook()

    monkeypatch.setattr(rospy, "on_shutdown", hooks.append)
    monkeypatch.setattr(rospy, "is_shutdown", lambda: bool(is_over))
    before = signal.signal(signal.SIGALRM, end)
    try:
        signal.setitimer(signal.ITIMER_REAL, delay_s)
        ros_node._wait_for_shutdown()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    assert is_over
