"""Whom a cry on the shared topic stops, by the words alone; and whom the fleet passes it on to."""

from typing import List

import pytest

from command_server.cries import COMMAND_VERBS, STRONG
from robot_fleet.addressing import Addressed, Company, Dialogue, Robot, address
from robot_fleet.stops import stops

ROBOTS = ("alpha", "beta", "gamma")
COMPANY = Company(tuple(map(Robot, ROBOTS)), ("delta",), COMMAND_VERBS | STRONG)

#: What is said, and who stops. What is not clear stops all.
TABLE = (
    ("Stop.", "alpha beta gamma"),
    ("Stop alpha", "alpha"),
    ("Stop Alpha.", "alpha"),
    ("STOP ALPHA!", "alpha"),
    ("Alpha stop", "alpha"),
    ("Please stop Alpha.", "alpha"),
    ("Stop Alpha, please.", "alpha"),
    ("Stop Alpha now!", "alpha"),
    ("Stop Alpha right now!", "alpha"),
    ("Stop Alpha immediately.", "alpha"),
    ("Stop robot Alpha.", "alpha"),
    ("Stop stop Alpha!", "alpha"),
    ("Halt Beta.", "beta"),
    ("Freeze Gamma.", "gamma"),
    ("Emergency stop Alpha!", "alpha"),
    ("Stop moving Alpha.", "alpha"),
    ("I said stop Alpha!", "alpha"),
    ("Stop Alpha and Beta.", "alpha beta"),
    ("Stop Beta and Gamma now.", "beta gamma"),
    ("Stop Alpha or Beta.", "alpha beta"),
    ("Stop both of you.", "alpha beta gamma"),
    ("Stop everybody.", "alpha beta gamma"),
    ("Stop all robots!", "alpha beta gamma"),
    ("Stop everyone but Alpha.", "beta gamma"),
    ("Stop Alpha. Beta, go to the kitchen.", "alpha"),
    ("Stop Alpha, and Beta, go to the kitchen.", "alpha"),
    ("Stop Alpha and go back.", "alpha"),
    ("Beta, turn left, and stop Alpha.", "alpha"),
    ("Alpha, stop Beta.", "alpha beta"),
    ("Stop the others.", "alpha beta gamma"),
    ("Stop Rosie!", "alpha beta gamma"),
    ("Stop Delta!", ""),
    ("Stop it.", "alpha beta gamma"),
    ("Stop following Alpha.", "alpha beta gamma"),
    ("Stop Alpha's motor.", "alpha beta gamma"),
    ("Stop behind Alpha.", ""),
    ("Stop in front of Alpha.", ""),
    ("Everyone has to stop.", "alpha beta gamma"),
    ("Nobody must move.", "alpha beta gamma"),
    ("None of you may move.", "alpha beta gamma"),
    ("The robots have to stop.", "alpha beta gamma"),
    ("Alpha must not move.", "alpha"),
    ("Tell Luna to stop.", "alpha beta gamma"),
    ("Could you tell luna to stop?", "alpha beta gamma"),
    ("Beta, tell Luna to stop.", "alpha beta gamma"),
    ("I want Luna to stand still.", "alpha beta gamma"),
    ("Tell Luna not to move.", "alpha beta gamma"),
    ("Tell robot four to stop.", "alpha beta gamma"),
    ("Tell Beta to stop.", "beta"),
    ("Tell Luna not to stop.", ""),
    ("Tell Luna to stop at the door.", ""),
    ("Tell Luna to turn left.", ""),
    ("Tell her to stop.", ""),
    ("Everybody must stop at the door.", ""),
    ("Don't stop Alpha.", ""),
    ("Follow Alpha.", ""),
    ("Show Alpha the stop sign.", ""),
)
#: What is passed on to whom.
PASSED_ON = (
    ("Stop Alpha.", "alpha: Stop."),
    ("Stop Alpha now!", "alpha: Stop now!"),
    ("Stop Beta and Gamma.", "beta, gamma: Stop."),
    ("Stop everyone but Alpha.", "beta, gamma: Stop."),
    ("Stop Alpha and go back.", "alpha: Stop and go back."),
    ("Beta, turn left, and stop Alpha.", "beta: turn left; alpha: stop."),
    ("Stop Alpha. Beta, go to the kitchen.", "alpha: Stop.; beta: go to the kitchen."),
)


@pytest.mark.parametrize(("text", "stopped"), TABLE)
def test_whom_a_cry_stops(text: str, stopped: str) -> None:
    assert " ".join(robot for robot in ROBOTS if stops(text, robot, COMPANY.names)) == stopped


@pytest.mark.parametrize(("text", "orders"), PASSED_ON)
def test_what_the_fleet_passes_on(text: str, orders: str) -> None:
    decided = address(text, COMPANY, Dialogue(), now_s=0.0)
    assert isinstance(decided, Addressed), decided
    assert "; ".join(f"{', '.join(one.robots)}: {one.text}" for one in decided.orders) == orders


@pytest.mark.parametrize(
    "said", ["Everybody, forget everything.", "Forget that, Alpha.", "Forget it.", "Alpha, forget it!"]
)
def test_cry_that_takes_back_an_order_stops_nobody(said: str) -> None:
    assert stops(said, "alpha", COMPANY.names)
    heard: List[str] = []

    def is_taken_back(part: str) -> bool:
        heard.append(part)
        return True

    assert not stops(said, "alpha", COMPANY.names, is_taken_back=is_taken_back)
    assert all("alpha" not in part.lower() for part in heard)
