"""A hundred sentences for three robots, half of them for robots that do not exist: who acts, and who stops."""

import re
from pathlib import Path
from typing import Dict, List, Set, Tuple

import pytest

from command_server.cries import COMMAND_VERBS, STRONG
from command_server.stop_words import find_cry
from robot_fleet.addressing import Addressed, Company, Dialogue, Robot, address
from robot_fleet.stops import stops

TABLE = Path(__file__).with_name("hundred_addressed.tsv")
ROWS: List[Tuple[str, ...]] = [
    tuple(line.split("\t")) for line in TABLE.read_text().splitlines() if line and not line.startswith("#")
]
FLEETS = {"names": ("alpha", "beta", "gamma"), "numbers": ("robot_one", "robot_two", "robot_three")}
#: Of a turn: the sign of its degrees.
SIGNS = {"left": 1, "right": -1}
_TURN = re.compile(r"turn (left|right) (\d+) degrees", re.IGNORECASE)
_WANTED = re.compile(r"(\w+) ([+-]\d+)")


def company_of(fleet: str) -> Company:
    return Company(tuple(map(Robot, FLEETS[fleet])), (), COMMAND_VERBS | STRONG)


def turns_of(decided: Addressed) -> Dict[str, int]:
    """Return by how many degrees each robot is told to turn."""
    turns: Dict[str, int] = {}
    # A robot that is to tell a person something does not turn.
    for order in (order for order in decided.orders if not order.text.startswith("Tell ")):
        for robot in order.robots[:1] if order.is_any else order.robots:
            for direction, degrees in _TURN.findall(order.text):
                turns[robot] = turns.get(robot, 0) + SIGNS[direction] * int(degrees)
    return turns


def test_table_is_what_it_says() -> None:
    assert len(ROWS) == 100
    assert len({row[2] for row in ROWS}) == len(ROWS)
    assert sum("absent" in kind for _, kind, *_ in ROWS) >= 50
    assert sum(kind.startswith("stop") for _, kind, *_ in ROWS) == 40


@pytest.mark.parametrize("row", [row for row in ROWS if row[1].startswith("do")], ids=lambda row: str(row[2]))
def test_who_acts(row: Tuple[str, ...]) -> None:
    fleet, kind, said, who, told = row
    decided = address(said, company_of(fleet), Dialogue(last=FLEETS[fleet][:1], said_s=0.0), now_s=1.0)
    if isinstance(decided, Addressed):
        assert turns_of(decided) == {robot: int(degrees) for robot, degrees in _WANTED.findall(who)}
        assert not decided.remark
        return
    assert who[0] in "?-", decided.sentence
    if "absent" in kind:
        assert decided.code == "UNKNOWN_ROBOT"
        assert told.lower() in decided.sentence.lower()


@pytest.mark.parametrize("row", [row for row in ROWS if row[1].startswith("stop")], ids=lambda row: str(row[2]))
def test_who_stops(row: Tuple[str, ...]) -> None:
    fleet, _, said, who, told = row
    company = company_of(fleet)
    stopped = {robot for robot in company.present if stops(said, robot, company.names)}
    must = {robot.strip() for robot in who.rstrip("+").split(",")}
    assert must <= stopped if who.endswith("+") else must == stopped
    decided = address(said, company, Dialogue(last=FLEETS[fleet][:1], said_s=0.0), now_s=1.0)
    assert isinstance(decided, Addressed)
    # The reply has the answer of each robot that stops, and names who is not here.
    answering: Set[str] = set()
    for order in decided.orders:
        answering.update(order.robots if find_cry(order.text) is not None else ())
    assert answering == stopped
    named = " ".join([decided.remark, *(robot.replace("_", " ") for robot in answering)]).lower()
    assert all(name.lower() in named for name in told.split("; "))
