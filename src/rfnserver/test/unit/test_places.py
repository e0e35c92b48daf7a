"""From words to places."""

import pytest

from rfnserver.places import UnknownPlace, destination_name, location_name, nearest_names

KNOWN = ("office", "roger's office", "kitchen", "fridge")


@pytest.mark.parametrize(
    "words, name",
    [
        ("the office", "office"),
        ("Office", "office"),
        ("to the fridge", "fridge"),
        ("Roger's office", "roger's office"),
        ("in front of the fridge", "fridge"),
        ("into the kitchen", "kitchen"),
    ],
)
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


@pytest.mark.parametrize(
    "words, name",
    [("The Office", "office"), ("office.", "office"), ("Roger's  office", "roger's office"), ("", ""), ("the", "the")],
)
def test_location_name(words: str, name: str) -> None:
    assert location_name(words) == name


def test_nearest_names_finds_a_slip_of_the_tongue() -> None:
    assert nearest_names("the ofice", ["office", "kitchen", "fridge"])[0] == "office"


def test_nearest_names_offers_something_always() -> None:
    assert nearest_names("mars", ["office", "kitchen"]) == ("kitchen", "office")
