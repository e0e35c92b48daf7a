"""Words behind a noun describe it; words behind a whole description belong to the verb."""

from typing import Any, Dict

import pytest

from semantic_framer.framer import Refusal, Understood


def meant(outcome: Any) -> Any:
    assert isinstance(outcome, Understood), outcome
    return [
        {value.name: value.text for value in readings[0].arguments if value.positions} for readings in outcome.clauses
    ]


@pytest.mark.parametrize(
    "text, arguments",
    [
        (
            "Tell me the colour of the bag in the hall.",
            {"addressee": "me", "message": "the colour of the bag in the hall"},
        ),
        ("bring the mug to Alice at the desk", {"theme": "the mug", "beneficiary": "Alice at the desk"}),
        ("Follow the guest wearing a hat.", {"cotheme": "the guest wearing a hat"}),
        (
            "take the towel to the woman pointing to the left in the garden",
            {"theme": "the towel", "beneficiary": "the woman pointing to the left in the garden"},
        ),
        (
            "guide the man sitting on the bench to the gate",
            {"cotheme": "the man sitting on the bench", "goal": "the gate"},
        ),
        ("offer something to drink to the nurse", {"theme": "something to drink", "recipient": "the nurse"}),
        (
            "say the time to the boy waving at the door",
            {"message": "the time", "addressee": "the boy waving at the door"},
        ),
        (
            "tell the boy raising his hand at the window a story",
            {"message": "a story", "addressee": "the boy raising his hand at the window"},
        ),
    ],
)
def test_what_describes_a_noun_is_part_of_it(understand: Any, text: str, arguments: Dict[str, str]) -> None:
    outcome, _ = understand(text)
    assert meant(outcome) == [arguments]


def test_a_place_in_a_promise_is_told(understand: Any) -> None:
    outcome, _ = understand("Guide Bob to the gate, you will find him at the fountain.")
    assert meant(outcome) == [{"cotheme": "Bob", "goal": "the gate"}, {"theme": "Bob", "location": "the fountain"}]


@pytest.mark.parametrize("text", ["could you find Bob at the fountain", "you could find Bob at the fountain"])
def test_a_request_to_find_somebody_stays_one(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    assert not isinstance(outcome, Refusal)
    assert meant(outcome)[0]["sought_entity"] == "Bob"


@pytest.mark.parametrize(
    "text, arguments",
    [
        ("ask my son to close the window", {"addressee": "my son", "message": "close the window"}),
        ("tell Bob not to come", {"addressee": "Bob", "message": "not to come"}),
    ],
)
def test_what_another_person_is_asked_to_do_is_no_command(
    understand: Any, text: str, arguments: Dict[str, str]
) -> None:
    outcome, _ = understand(text)
    assert meant(outcome) == [arguments]
