"""Tests the thread that is ready for the next command."""

import threading
from typing import List

from executor.ready_thread import ReadyThread

LONG_S = 60.0


def run_and_wait(threads: ReadyThread) -> int:
    """Return the thread in which a work ran."""
    found: List[int] = []
    is_done = threading.Event()

    def work() -> None:
        found.append(threading.get_ident())
        is_done.set()

    threads.run(work)
    assert is_done.wait(LONG_S)
    return found[0]


def test_work_runs_in_another_thread() -> None:
    assert run_and_wait(ReadyThread("work")) != threading.get_ident()


def run_three_that_meet(threads: ReadyThread) -> None:
    """Return when three works run at the same time.

    Raises:
        BrokenBarrierError: they do not
    """
    meeting = threading.Barrier(4)
    for _ in range(3):
        threads.run(lambda: meeting.wait(LONG_S) and None)
    meeting.wait(LONG_S)
    assert not meeting.broken


def test_works_run_at_the_same_time() -> None:
    run_three_that_meet(ReadyThread("work"))


def test_one_thread_waits_when_the_others_have_ended() -> None:
    threads = ReadyThread("ready")
    run_three_that_meet(threads)
    for _ in range(50):
        run_and_wait(threads)
    alive = [thread for thread in threading.enumerate() if thread.name == "ready"]
    for thread in alive[1:]:
        thread.join(LONG_S)
    assert len([thread for thread in threading.enumerate() if thread.name == "ready"]) == 1


def test_work_that_fails_holds_up_no_other() -> None:
    threads = ReadyThread("failing")
    hook, threading.excepthook = threading.excepthook, lambda _: None
    try:
        threads.run(lambda: 1 / 0 and None)
        run_and_wait(threads)
    finally:
        threading.excepthook = hook
