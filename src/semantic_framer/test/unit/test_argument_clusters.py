"""A verb that is said once for two groups of phrases does one thing with each group, or nothing."""

from typing import Any, Dict, Tuple

import pytest

from semantic_framer.framer import Understood

Arguments = Dict[str, str]


def placing(theme: str, goal: str) -> Arguments:
    """The arguments of putting something somewhere."""
    return {"theme": theme, "goal": goal}


def giving(theme: str, recipient: str) -> Arguments:
    """The arguments of giving something to somebody."""
    return {"theme": theme, "recipient": recipient}


MUG_AND_PLATE = (placing("the mug", "the table"), placing("the plate", "the sink"))
PEN_AND_CUP = (giving("the pen", "Anna"), giving("the cup", "Ben"))
SPLIT: Dict[str, Tuple[Arguments, ...]] = {
    "give Anna the pen and Ben the cup": PEN_AND_CUP,
    "give the pen to Anna and the cup to Ben": PEN_AND_CUP,
    "put the mug on the table and the plate in the sink": MUG_AND_PLATE,
    "put the mug on the table and then the plate in the sink": MUG_AND_PLATE,
    "put the mug on the table, the plate in the sink and the fork in the drawer": (
        *MUG_AND_PLATE,
        placing("the fork", "the drawer"),
    ),
    "take the mug to the kitchen and the plate to the office": (
        placing("the mug", "the kitchen"),
        placing("the plate", "the office"),
    ),
    "turn the lamp on and the radio off": (
        {"device": "the lamp", "operational_state": "on"},
        {"device": "the radio", "operational_state": "off"},
    ),
    "turn left 90 degrees and right 45 degrees": (
        {"direction": "left", "angle": "90", "angle_unit": "degrees"},
        {"direction": "right", "angle": "45", "angle_unit": "degrees"},
    ),
    "bring me the pen from the hall and the cup from the office": (
        {"theme": "the pen", "beneficiary": "me", "source": "the hall"},
        {"theme": "the cup", "beneficiary": "me", "source": "the office"},
    ),
    "put the mug on the table and the plate in the sink and go to the hall": (*MUG_AND_PLATE, {"goal": "the hall"}),
}


@pytest.mark.parametrize("text, clauses", SPLIT.items())
def test_each_group_is_a_clause(understand: Any, text: str, clauses: Tuple[Arguments, ...]) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood)
    found = tuple({value.name: value.text for value in readings[0].arguments} for readings in outcome.clauses)
    assert found == clauses


@pytest.mark.parametrize(
    "text, items",
    [
        ("bring the mug and the plate to the kitchen", {"theme": ("the mug", "the plate")}),
        ("put the mug and the plate on the table", {"theme": ("the mug", "the plate")}),
        ("give Anna the pen and the cup", {"theme": ("the pen", "the cup")}),
        ("give Anna and Ben the pen", {"recipient": ("Anna", "Ben")}),
        ("bring the mug to Anna and Ben", {"beneficiary": ("Anna", "Ben")}),
        ("go to the kitchen and the office", {"goal": ("the kitchen", "the office")}),
    ],
)
def test_a_list_is_one_argument(understand: Any, text: str, items: Dict[str, Tuple[str, ...]]) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood) and len(outcome.clauses) == 1
    lists = [value for value in outcome.clauses[0][0].arguments if value.members]
    assert {value.name: tuple(member.text for member in value.members) for value in lists} == items


@pytest.mark.parametrize(
    "text",
    [
        "go to the kitchen with the cup and the bathroom with the plate",
        "put the cup on the table and the bowl",
        "put the book on the table and in the drawer",
    ],
)
def test_what_may_be_either_is_refused(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    assert not isinstance(outcome, Understood)
