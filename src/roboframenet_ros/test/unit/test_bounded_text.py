"""A long trace ends at the end of a line."""

import pytest

from roboframenet_ros.bounded_text import MAX_LENGTH, bounded


@pytest.mark.parametrize(
    "text, expected",
    [
        ("", ""),
        ("one\ntwo", "one\ntwo"),
        ("one\ntwo\nthree", "one\ntwo\n... 1 more lines"),
        ("one\ntwo\nthree\nfour", "one\ntwo\n... 2 more lines"),
        ("a line that is too long", "... 1 more lines"),
    ],
)
def test_bounded(text: str, expected: str) -> None:
    assert bounded(text, 10) == expected


def test_no_trace_is_longer_than_its_bound_by_more_than_the_last_line() -> None:
    assert len(bounded("line\n" * MAX_LENGTH)) < MAX_LENGTH + 30
