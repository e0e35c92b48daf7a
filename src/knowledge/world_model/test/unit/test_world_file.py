"""The file of the world: what it says, and what is wrong with it."""

import pytest

from checked_files import FileRefused
from world_model import Relation, Sort
from world_model.world_file import load_world_file


def test_defaults_follow_from_the_id() -> None:
    found = {
        one.id: one
        for one in load_world_file(
            "places: {living_room: }\nthings: {coffee_cup_2: {in: living_room}}\npersons: {anna: {}}", "w"
        )
    }
    assert (found["living_room"].name, found["living_room"].sort) == ("living room", Sort.PLACE)
    assert (found["coffee_cup_2"].name, found["coffee_cup_2"].category) == ("", "coffee cup")
    assert found["coffee_cup_2"].relations == (Relation("in", "living_room"),)
    assert found["anna"].name == "Anna"


@pytest.mark.parametrize(
    "text, code, line, key",
    [
        ("rooms: {}", "UNKNOWN_KEY", 1, "rooms"),
        ("things:\n  mug: {colour: red}", "UNKNOWN_KEY", 2, "things.mug.colour"),
        ("things:\n  mug: {on: tabel}\n  table:", "UNKNOWN_OBJECT", 2, "things.mug.on"),
        ("things:\n  mug: {x: 1}", "MISSING_KEY", 2, "things.mug.y"),
        ("things:\n  mug: {x: a, y: 1}", "NOT_A_NUMBER", 2, "things.mug.x"),
        ("places:\n  hall: {size: [1]}", "NOT_A_SIZE", 2, "places.hall.size"),
        ("places:\n  hall:\nthings:\n  hall:", "DUPLICATE_ID", 4, "things.hall"),
        ("things:\n  the mug: {}", "NOT_AN_OBJECT", 2, "things.the mug"),
        ("things:\n  mug: {on: mug}", "NOT_AN_OBJECT", 2, "things.mug"),
        ("things: [mug]", "WRONG_TYPE", 1, "things"),
    ],
)
def test_mistake_is_told_with_line_and_key(text: str, code: str, line: int, key: str) -> None:
    with pytest.raises(FileRefused) as refused:
        load_world_file(text, "world.yaml")
    assert (code, line, key) in [(one.code, one.line, one.key) for one in refused.value.problems]


def test_hint_names_the_nearest_object() -> None:
    with pytest.raises(FileRefused, match="did you mean 'table'"):
        load_world_file("things:\n  mug: {on: tabel}\n  table:", "world.yaml")
