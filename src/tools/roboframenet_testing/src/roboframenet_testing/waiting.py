"""Waits for conditions on the monotonic clock."""

import ast
import linecache
import time
from pathlib import Path
from typing import Callable, List, Union

POLL_PERIOD_S = 0.02
#: A condition that takes long, such as one that asks all nodes, is looked at a third of the time, but this often.
LONGEST_POLL_PERIOD_S = 0.2


def wait_until(
    condition: Callable[[], object], timeout_s: float = 60.0, message: Union[str, Callable[[], object]] = ""
) -> None:
    """Wait until a condition holds.

    Args:
        condition: returns something true when the wait is over
        timeout_s: how long to wait at most, in seconds of the monotonic clock
        message: what the failure means, or a function that returns what is there instead; it is called at the deadline.
            The condition itself is quoted in any case

    Raises:
        AssertionError: the condition still does not hold at the deadline
    """
    if not comes_true(condition, timeout_s):
        failure = f"still not true after {timeout_s} s: {_quoted(condition)}"
        if callable(message):
            raise AssertionError(f"{failure}; instead: {message()!r}")
        raise AssertionError(f"{message}: {failure}" if message else failure)


def comes_true(condition: Callable[[], object], timeout_s: float) -> bool:
    """Return whether a condition holds within a time; the condition is checked at least once."""
    end_s = time.monotonic() + timeout_s
    while True:
        begin_s = time.monotonic()
        if condition():
            return True
        now_s = time.monotonic()
        if now_s >= end_s:
            return bool(condition())
        rest_s = max(POLL_PERIOD_S, 2.0 * (now_s - begin_s))
        time.sleep(min(rest_s, LONGEST_POLL_PERIOD_S, end_s - now_s))


def _quoted(condition: Callable[[], object]) -> str:
    """The source of a condition and its place; the name of a function, the body of a lambda."""
    code = getattr(condition, "__code__", None)
    if code is None:
        return repr(condition)
    text = condition.__name__
    if text == "<lambda>":
        bodies = _lambda_bodies(code.co_filename, code.co_firstlineno)
        # Two lambdas in one line cannot be told apart by their position.
        text = " or ".join(bodies) or text
    return f"{text} ({Path(code.co_filename).name}:{code.co_firstlineno})"


def _lambda_bodies(path: str, line: int) -> List[str]:
    """Sources of the lambdas that begin in a line of a file; none when the file cannot be read."""
    source = "".join(linecache.getlines(path))
    lambdas = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Lambda) and node.lineno == line]
    return [" ".join((ast.get_source_segment(source, node.body) or "").split()) for node in lambdas]
