"""Persons who are described by what they do, unknown names, and persons who are told an indirect question."""

from typing import Any

import pytest

from semantic_framer.framer import Understood


@pytest.mark.parametrize(
    ("text", "frame"),
    [
        # The parser makes a compound of the person and the deed.
        (
            "Bring the jam to the person waving in the hall.",
            "bringing(theme=the jam, beneficiary=the person waving in the hall)",
        ),
        # The gesture stands before the person.
        # An unknown word with a capital is a name.
        ("take Peyton from the sofa to the hall", "guiding(cotheme=Peyton, goal=the hall, source=the sofa)"),
        # An indirect question begins with its question word, and ends before the addressee.
        ("say what day it is to Hayden at the sofa", "saying(message=what day it is, addressee=Hayden at the sofa)"),
        (
            "tell the person pointing to the left in the corridor what day tomorrow is",
            "telling(message=what day tomorrow is, addressee=the person pointing to the left in the corridor)",
        ),
        # WordNet's kitchen cabinet advises a president.
        ("carry the lid to the kitchen cabinet", "bringing(theme=the lid, goal=the kitchen cabinet)"),
    ],
)  # fmt: skip
def test_who_is_meant(understand: Any, text: str, frame: str) -> None:
    outcome = understand(text)[0]
    assert isinstance(outcome, Understood), outcome
    (readings,) = outcome.clauses
    said = {value.name: value.text for value in readings[0].arguments if value.positions}
    name, _, rest = frame[:-1].partition("(")
    assert readings[0].unit.frame_name == name
    assert said == dict(pair.split("=") for pair in rest.split(", "))
