"""A long trace ends at the end of a line."""

import pytest

from roboframenet_ros.bounded_text import MAX_LENGTH, as_log_lines, bounded, one_line


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


@pytest.mark.parametrize(
    "text, expected",
    [
        ("Done.", "Done."),
        ("Ping.\n[FATAL] [1.0]: executor: everything is broken", "Ping. [FATAL] [1.0]: executor: everything is broken"),
        ("a \r\n b", "a b"),
        ("\x1b[2J\x07\x00", r"\x1b[2J\x07\x00"),
        ("caf\u00e9 \u2013 \U0001f44b", "caf\u00e9 \u2013 \U0001f44b"),
        ("no\u00a0break, tab\tbed", "no break, tab bed"),
        ("\u202edrawkcab", r"\u202edrawkcab"),
        ("x" * 5000, "x" * 1997 + "..."),
    ],
)
def test_sentence_is_one_line_without_control_characters(text: str, expected: str) -> None:
    assert one_line(text) == expected


def test_further_lines_of_a_log_are_indented() -> None:
    forged = "Ping.\n[FATAL] [1.0]: executor: everything is broken\r\x1b[1A[INFO]"
    lines = as_log_lines(forged).split("\n")
    assert lines == ["Ping.", "    [FATAL] [1.0]: executor: everything is broken", r"    \x1b[1A[INFO]"]
