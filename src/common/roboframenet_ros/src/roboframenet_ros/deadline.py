"""Deadlines for calls that have none of their own, such as those to the master and to services."""

import queue
import threading
from typing import Callable, NoReturn, TypeVar

Answer = TypeVar("Answer")


class NoAnswer(RuntimeError):
    """A call has not returned in time."""


def within(timeout_s: float, ask: Callable[[], Answer], *, name: str) -> Answer:
    """Call a function in a thread of its own, and wait for its return value until a deadline.

    Args:
        timeout_s: how long to wait
        ask: the function; after the deadline it goes on, and its return value is lost
        name: of the thread

    Raises:
        NoAnswer: the function has not returned in time
        Exception: what the function raised
    """
    answers: queue.Queue[Callable[[], Answer]] = queue.Queue()

    def run() -> None:
        try:
            answer = ask()
        except Exception as error:  # boundary: raised again in the caller
            fault = error
            answers.put(lambda: _raise(fault))
        else:
            answers.put(lambda: answer)

    # A daemon: a call that never comes back must not keep the process alive.
    threading.Thread(target=run, name=name, daemon=True).start()
    try:
        unpack = answers.get(timeout=timeout_s)
    except queue.Empty:
        raise NoAnswer(f"no answer within {timeout_s:g} s") from None
    return unpack()


def _raise(error: Exception) -> NoReturn:
    raise error
