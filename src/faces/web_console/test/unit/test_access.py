"""Where the page may be offered, and under which names."""

import re

import pytest

from web_console.access import AccessError, check_access, host_pattern, is_local, is_token


@pytest.mark.parametrize("address", ["127.0.0.1", "127.0.0.2", "::1"])
def test_addresses_of_this_machine_need_no_token(address):
    assert is_local(address)
    check_access(address, "")


@pytest.mark.parametrize("address", ["0.0.0.0", "192.168.1.5", "::", "robot.example", ""])
def test_other_addresses_need_a_token(address):
    with pytest.raises(AccessError, match="~token_file"):
        check_access(address, "")
    check_access(address, "0123456789abcdef")


def test_short_tokens_are_refused():
    with pytest.raises(AccessError, match="holds 5 characters; expected 16"):
        check_access("0.0.0.0", "12345")
    with pytest.raises(AccessError):
        check_access("127.0.0.1", "12345")


@pytest.mark.parametrize(
    ("address", "names", "host", "is_answered"),
    [
        ("127.0.0.1", (), "localhost", True),
        ("127.0.0.1", (), "127.0.0.1", True),
        ("127.0.0.1", (), "[::1]", True),
        ("127.0.0.1", (), "evil.example", False),
        ("127.0.0.1", (), "localhost.evil.example", False),
        ("127.0.0.1", (), "127x0.0.1", False),
        ("127.0.0.1", (), "192.168.1.5", False),
        ("192.168.1.5", (), "192.168.1.5", True),
        ("0.0.0.0", (), "0.0.0.0", False),
        ("0.0.0.0", ("robot.local",), "robot.local", True),
        ("0.0.0.0", ("Robot.Local",), "robot.local", True),
        ("fe80::1", (), "[fe80::1]", True),
    ],
)
def test_names_that_are_answered(address, names, host, is_answered):
    assert bool(re.match(host_pattern(address, names), host)) == is_answered


def test_token_is_compared_as_a_whole():
    assert is_token("0123456789abcdef", "0123456789abcdef")
    assert not is_token("0123456789abcde", "0123456789abcdef")
    assert not is_token("", "0123456789abcdef")
    assert not is_token("ü" * 16, "0123456789abcdef")
