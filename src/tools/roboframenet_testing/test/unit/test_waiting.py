"""Waiting for conditions."""

import threading

import pytest

from roboframenet_testing import comes_true, wait_until


def is_never() -> bool:
    return False


class Never:
    """A condition without code of its own."""

    def __call__(self) -> bool:
        return False

    def __repr__(self) -> str:
        return "never"


def test_condition_that_holds_ends_the_wait_at_once():
    checks = []
    wait_until(lambda: checks.append(None) or True)
    assert len(checks) == 1


def test_condition_that_becomes_true_ends_the_wait():
    event = threading.Event()
    timer = threading.Timer(0.05, event.set)
    timer.start()
    wait_until(event.is_set)
    timer.join()


def test_condition_is_checked_even_without_time():
    assert comes_true(lambda: True, 0.0)
    assert not comes_true(lambda: False, 0.0)


def test_condition_that_becomes_true_at_the_deadline_counts():
    results = iter([False, True])
    assert comes_true(lambda: next(results), 0.0)


def test_failure_quotes_the_condition_and_its_place():
    counts = [1]
    with pytest.raises(AssertionError) as caught:
        wait_until(
            lambda: (
                len(counts)
                == 2
            ),
            0.0,
        )  # fmt: skip
    assert "len(counts) == 2 (test_waiting.py:" in str(caught.value)
    assert str(caught.value).startswith("still not true after 0.0 s: ")


def test_failure_names_a_function():
    with pytest.raises(AssertionError, match=r"is_never \(test_waiting.py:\d+\)"):
        wait_until(is_never, 0.0)


def test_failure_shows_an_object_that_is_no_function():
    with pytest.raises(AssertionError, match=r"0\.0 s: never$"):
        wait_until(Never(), 0.0)


def test_failure_quotes_both_lambdas_of_a_line():
    conditions = [lambda: 1 > 2, lambda: 3 > 4]
    with pytest.raises(AssertionError, match="1 > 2 or 3 > 4"):
        wait_until(conditions[0], 0.0)


def test_failure_begins_with_the_message():
    with pytest.raises(AssertionError, match=r"^nobody listens: still not true"):
        wait_until(is_never, 0.0, "nobody listens")


def test_failure_ends_with_the_state_at_the_deadline():
    states = [1]
    with pytest.raises(AssertionError, match=r"; instead: \[1, 2\]$"):
        wait_until(lambda: states.append(2), 0.0, lambda: states[:2])


def test_error_of_the_condition_reaches_the_test():
    with pytest.raises(ZeroDivisionError):
        wait_until(lambda: 1 / 0)
