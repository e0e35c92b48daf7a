"""Words of a second clause that refer to the same element of the first."""

import pytest

from semantic_framer.framer import Understood


@pytest.mark.parametrize(
    "text, themes, goals",
    [
        ("Put the cup on the table and the bowl on it.", ["the cup", "the bowl"], ["the table", "the table"]),
        (
            "Put the red cup on the table and the blue one on the shelf.",
            ["the red cup", "the blue cup"],
            ["the table", "the shelf"],
        ),
    ],
)
def test_the_second_of_two_clauses(understand, text, themes, goals) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood)
    readings = [clause[0] for clause in outcome.clauses]
    assert [reading.argument("theme").text for reading in readings] == themes
    assert [reading.argument("goal").text for reading in readings] == goals


def test_an_adjective_is_no_thing(understand) -> None:
    outcome, _ = understand("the floor is dirty clean it")
    assert isinstance(outcome, Understood)
    assert outcome.clauses[-1][0].argument("object").text == "the floor"
