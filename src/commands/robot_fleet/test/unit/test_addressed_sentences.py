"""Who must act: the table of addressed sentences."""

from pathlib import Path
from typing import List, Tuple

import pytest

from robot_fleet.addressing import Addressed, Company, Dialogue, Order, Robot, address

TABLE = Path(__file__).with_name("addressed_sentences.tsv")
ROWS = [
    tuple((line + "\t").split("\t")[:4])
    for line in TABLE.read_text().splitlines()
    if line.strip() and not line.startswith("#")
]
VERBS = frozenset("go come follow turn bring wait open give show say take stop tell put move drive be have do".split())
NAMES = ("alpha", "beta", "gamma")


def situation(name: str) -> Tuple[Company, Dialogue]:
    """Return the robots that are there, and what was said before."""
    busy = {"busy": ("alpha",), "all-busy": NAMES}.get(name, ())
    present = {"two": NAMES[:2], "one": NAMES[:1]}.get(name, NAMES)
    last = {"fresh": (), "busy": (), "all-busy": (), "one": (), "beta+gamma": NAMES[1:], "gone": ("delta",)}
    company = Company(tuple(Robot(one, is_free=one not in busy) for one in present), ("delta",), VERBS)
    asking = ("beta",) if name == "asked" else ()
    return company, Dialogue(last=last.get(name, ("alpha",)), asking=asking, said_s=0.0)


def shown(orders: Tuple[Order, ...]) -> Tuple[str, str]:
    """Return orders as in the table."""
    who: List[str] = []
    for order in orders:
        names = ("|" if order.is_any else ", ").join(order.robots)
        who.append(f"> {names}" if order.is_after else names)
    return "; ".join(who), "; ".join(order.text for order in orders)


def test_table_has_a_hundred_sentences() -> None:
    assert len(ROWS) >= 100
    assert len({row[:2] for row in ROWS}) == len(ROWS)


@pytest.mark.parametrize("row", ROWS, ids=[f"{row[0]}: {row[1]}" for row in ROWS])
def test_who_acts(row: Tuple[str, str, str, str]) -> None:
    name, sentence, who, words = row
    company, dialogue = situation(name)
    decided = address(sentence, company, dialogue, now_s=1.0)
    if isinstance(decided, Addressed):
        assert shown(decided.orders) == (who, words)
    else:
        assert decided.code == who, decided.sentence
