"""Which orders a person means by a phrase."""

import pytest

from standing_orders.matching import orders_meant
from standing_orders.order import StandingOrder


def order(text: str) -> StandingOrder:
    return StandingOrder(text, text, text, f"I will do this: {text}.", b"", 0.0)


BELL, TEN = order("whenever the bell rings, ping"), order("ping every day at ten")


@pytest.mark.parametrize(
    ("phrase", "meant"),
    [
        ("the bell", [BELL]),
        ("that", [TEN]),
        ("every order", [BELL, TEN]),
        ("all standing orders", [BELL, TEN]),
        ("all my reminders", [BELL, TEN]),
        ("the lamp", []),
        ("all bells", [BELL]),
    ],
)
def test_orders_of_a_phrase(phrase, meant):
    assert list(orders_meant(phrase, [BELL, TEN])) == meant
