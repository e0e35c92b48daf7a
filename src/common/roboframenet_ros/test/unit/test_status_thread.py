"""Tests when the status of an action server is published."""

import threading
import time
from typing import List

from roboframenet_ros.status_thread import StatusThread

LONG_S = 60.0


class Published:
    """Counts the calls, and can be waited for."""

    def __init__(self) -> None:
        self.threads: List[int] = []
        self.must_repeat = False
        self._called = threading.Condition()

    def __call__(self) -> bool:
        with self._called:
            self.threads.append(threading.get_ident())
            self._called.notify_all()
            return self.must_repeat

    def wait_for(self, count: int) -> None:
        with self._called:
            assert self._called.wait_for(lambda: len(self.threads) >= count, LONG_S)


def test_nothing_is_published_unasked() -> None:
    published = Published()
    status = StatusThread(published, pause_s=0.0, period_s=0.001)
    time.sleep(0.05)
    status.close()
    assert not published.threads


def test_status_is_published_in_another_thread() -> None:
    published = Published()
    status = StatusThread(published, pause_s=LONG_S, period_s=None)
    status.ask()
    published.wait_for(1)
    status.close()
    assert threading.get_ident() not in published.threads


def test_changes_within_the_pause_are_told_by_one() -> None:
    published = Published()
    status = StatusThread(published, pause_s=0.2, period_s=None)
    status.ask()
    published.wait_for(1)
    for _ in range(10):
        status.ask()
    published.wait_for(2)
    time.sleep(0.3)
    status.close()
    assert len(published.threads) == 2
    assert len(set(published.threads)) == 1


def test_status_is_repeated_as_long_as_it_must_be() -> None:
    published = Published()
    published.must_repeat = True
    status = StatusThread(published, pause_s=0.0, period_s=0.01)
    status.ask()
    published.wait_for(5)
    published.must_repeat = False
    published.wait_for(len(published.threads) + 1)
    count = len(published.threads)
    time.sleep(0.1)
    assert len(published.threads) <= count + 1
    # A change begins it again.
    status.ask()
    published.wait_for(count + 1)
    status.close()


def test_status_is_not_repeated_without_a_period() -> None:
    published = Published()
    published.must_repeat = True
    status = StatusThread(published, pause_s=0.0, period_s=None)
    status.ask()
    published.wait_for(1)
    time.sleep(0.05)
    status.close()
    assert len(published.threads) == 1


def test_nothing_is_published_behind_the_end() -> None:
    published = Published()
    published.must_repeat = True
    status = StatusThread(published, pause_s=0.0, period_s=0.01)
    status.ask()
    published.wait_for(1)
    status.close()
    time.sleep(0.05)
    count = len(published.threads)
    status.ask()
    time.sleep(0.05)
    assert len(published.threads) == count
