"""Whose emergency stop is engaged by what was said to all robots, and whose is released."""

import pytest

from command_server.emergency_words import is_emergency_stop, is_release
from robot_fleet.addressing import Addressed, Company, Dialogue, Robot, Unaddressed, address
from robot_fleet.robot_names import Names
from robot_fleet.stops import stopped_by

ROBOTS = ("alpha", "beta", "gamma")
NAMES = Names(dict.fromkeys(ROBOTS, ()))
COMPANY = Company(tuple(map(Robot, ROBOTS)), (), frozenset("come go turn bring stop wait".split()))


@pytest.mark.parametrize(
    "text, stopped, held",
    [
        ("Emergency stop!", ROBOTS, ROBOTS),
        ("Everybody, emergency stop.", ROBOTS, ROBOTS),
        ("Alpha, emergency stop.", ("alpha",), ("alpha",)),
        ("Emergency stop Alpha", ("alpha",), ("alpha",)),
        ("Everybody but Beta, emergency stop!", ("alpha", "gamma"), ("alpha", "gamma")),
        ("Alpha, emergency stop. Beta, stop.", ("alpha", "beta"), ("alpha",)),
        ("Alpha, stop. Beta, emergency stop!", ("alpha", "beta"), ("beta",)),
        ("Stop.", ROBOTS, ()),
    ],
)
def test_whom_it_stops_and_whom_it_holds(text, stopped, held):
    assert stopped_by(text, ROBOTS, NAMES) == stopped
    assert stopped_by(text, ROBOTS, NAMES, is_cry=is_emergency_stop) == held


@pytest.mark.parametrize(
    "text, robots",
    [
        ("Alpha, release the emergency stop.", ("alpha",)),
        ("Alpha and Beta, please release the e-stop.", ("alpha", "beta")),
        ("Everybody, release the emergency stop.", ROBOTS),
    ],
)
def test_who_is_named_is_released(text, robots):
    addressed = address(text, COMPANY, Dialogue(), now_s=1.0, near=None)
    assert isinstance(addressed, Addressed)
    assert [order.robots for order in addressed.orders] == [robots]
    assert is_release(addressed.orders[0].text)


def test_who_is_to_be_released_is_asked():
    asked = address("Release the emergency stop.", COMPANY, Dialogue(), now_s=1.0, near=None)
    assert isinstance(asked, Unaddressed)
    assert asked.code == "WHO"
