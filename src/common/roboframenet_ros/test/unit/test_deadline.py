"""A call with a deadline gives its answer, its error, or none."""

import threading

import pytest

from roboframenet_ros.deadline import NoAnswer, within


def test_answer_comes_back_from_a_thread_of_its_own():
    assert within(60.0, lambda: threading.current_thread().name, name="asking") == "asking"


def test_none_is_an_answer():
    assert within(60.0, lambda: None, name="asking") is None


def test_error_comes_back_as_it_was_raised():
    def fail():
        raise KeyError("where")

    with pytest.raises(KeyError, match="where"):
        within(60.0, fail, name="asking")


def test_call_that_does_not_end_holds_nobody_up():
    may_end = threading.Event()
    has_ended = threading.Event()

    def hang():
        may_end.wait(60.0)
        has_ended.set()

    with pytest.raises(NoAnswer, match=r"no answer within 0\.05 s"):
        within(0.05, hang, name="asking")
    assert not has_ended.is_set()
    may_end.set()
    assert has_ended.wait(60.0)
