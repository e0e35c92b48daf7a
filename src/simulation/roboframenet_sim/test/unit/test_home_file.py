"""The home file."""

import pytest
from home_for_tests import HOME_FILE, make_home

from roboframenet_sim.home_file import HomeError, load_home
from roboframenet_sim.home_state import ROBOT
from roboframenet_sim.planner import NoPath

SMALL = """robot: {x: 1, y: 1, heading: 0}
rooms:
  hall: {names: [hall], x_m: [0, 4], y_m: [0, 3]}
  den: {names: [den], x_m: [4, 8], y_m: [0, 3]}
doors:
  den_door: {names: [den door], rooms: [hall, den], from: [4, 1], to: [4, 2.1]}
furniture:
  table: {names: [table], category: table, room: den, x_m: [6, 7], y_m: [1, 2], height_m: 0.7, traits: [surface]}
things:
  mug: {names: [mug], category: cup, on: table}
persons:
  eve: {names: [Eve], x: 2, y: 2, heading: 0}
"""


def test_home_has_what_it_should():
    home = make_home()
    kinds = {kind: list(home.plan.of_kind(kind)) for kind in ("room", "door", "furniture", "thing", "person")}
    assert len(kinds["room"]) >= 6
    assert len(kinds["thing"]) >= 40
    assert len({thing.category for thing in kinds["thing"]}) >= 10
    assert len(kinds["person"]) == 3
    assert all(home.plan.room_at(home.plan.position(home.state, thing.id)) for thing in kinds["thing"])


def test_everything_can_be_come_near_to():
    home = make_home()
    for door in home.plan.of_kind("door"):
        home.change(reason="test", **{door.id: {"is_open": True}})
    for entity in home.plan.entities.values():
        point = home.floor.place_to_stand(home.state, entity.id, reach_m=home.plan.robot.reach_m - 0.15)
        assert home.floor.way(home.state, home.plan.position(home.state, ROBOT), point)


def test_no_place_to_stand_in_a_wall():
    home = make_home()
    with pytest.raises(NoPath):
        home.floor.way(home.state, (7.0, 5.0), (-3.0, -3.0))


def test_small_home_is_read():
    plan, state = load_home(SMALL, path="small.yaml")
    assert (state.places["mug"].relation, state.places["mug"].holder) == ("on", "table")
    assert plan.room_at(plan.position(state, "mug")) == "den"
    assert plan.room_at(plan.position(state, "eve")) == "hall"


@pytest.mark.parametrize(
    "change,line,key,words",
    [
        (("y_m: [0, 3]}\n  den:", "y_m: [3, 0]}\n  den:"), 3, "hall/y_m", "smaller"),
        (("names: [hall]", "names: []"), 3, "hall/names", "one name"),
        (("names: [hall]", "nomes: [hall]"), 3, "hall/nomes", "unknown key"),
        (("rooms: [hall, den]", "rooms: [hall, attic]"), 6, "rooms", "'attic'"),
        (("to: [4, 2.1]", "to: [5, 2.1]"), 6, "den_door", "along"),
        (("x_m: [6, 7]", "x_m: [6, 9]"), 8, "table", "inside den"),
        (("traits: [surface]", "traits: [surfaces]"), 8, "table/traits", "surfaces"),
        (("on: table", "in: table"), 10, "mug/in", "no container"),
        (("on: table", "on: shelf"), 10, "mug/on", "'shelf'"),
        (("category: cup, on: table", "category: cup"), 10, "mug", "exactly one"),
        (("  mug: {", "  table: {"), 10, "table", "used already"),
        (("on: table}", "on: table, mass_kg: -1}"), 10, "mug/mass_kg", "positive"),
        (("x: 2, y: 2", "x: 2, y: 9"), 12, "eve", "no room"),
        (("x: 1, y: 1", "x: 1, z: 1"), 1, "z", "unknown key"),
        (("persons:", "people:"), 11, "people", "unknown key"),
    ],
)
def test_mistakes_are_named(change, line, key, words):
    before, after = change
    assert before in SMALL
    with pytest.raises(HomeError) as caught:
        load_home(SMALL.replace(before, after, 1), path="small.yaml")
    assert (caught.value.line, caught.value.key) == (line, key)
    assert words in str(caught.value)
    assert str(caught.value).startswith(f"small.yaml:{line}: ")


@pytest.mark.parametrize("text", ["", "[", "robot: 1", "- a"])
def test_what_is_no_home_is_refused(text):
    with pytest.raises(HomeError):
        load_home(text, path="small.yaml")


def test_every_wrong_line_of_the_home_is_a_home_error():
    with open(HOME_FILE, encoding="utf-8") as file:
        lines = file.read().splitlines()
    refused = 0
    for index in range(0, len(lines), 3):
        text = "\n".join(lines[:index] + [lines[index].replace(":", "", 1)] + lines[index + 1 :])
        try:
            load_home(text, path="home.yaml")
        except HomeError as error:
            assert error.line >= 1
            refused += 1
    assert refused > 30
