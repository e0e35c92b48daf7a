"""From words to places."""
import pytest
from move_base_rfn.destination import UnknownPlace, destination_name

KNOWN = ("office", "roger's office", "kitchen", "fridge")


@pytest.mark.parametrize("words, name", [
    ("the office", "office"), ("Office", "office"), ("to the fridge", "fridge"), ("Roger's office", "roger's office"),
    ("in front of the fridge", "fridge"), ("into the kitchen", "kitchen"),
])
def test_destination_name(words: str, name: str) -> None:
    assert destination_name(words, KNOWN) == name


def test_another_office_is_not_the_office() -> None:
    with pytest.raises(UnknownPlace, match="alice's office"):
        destination_name("Alice's office", KNOWN)


def test_unknown_place_offers_the_nearest() -> None:
    with pytest.raises(UnknownPlace, match='"kitchen"'):
        destination_name("the kitchin", KNOWN)


@pytest.mark.parametrize("words, known", [("", KNOWN), ("the office", ())])
def test_nothing_to_choose_from_is_said(words: str, known: tuple) -> None:
    with pytest.raises(UnknownPlace):
        destination_name(words, known)
