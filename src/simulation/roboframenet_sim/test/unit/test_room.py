"""The room file and its grid."""

import os

import pytest
import yaml

from roboframenet_sim.occupancy_grid import grid_of_room
from roboframenet_sim.planner import plan
from roboframenet_sim.room import RoomError, load_room, load_room_file

CONFIG = os.path.join(os.path.dirname(__file__), "..", "..", "config")
SMALL = """resolution_m: 0.1
wall_thickness_m: 0.1
bounds: {x_m: [0, 4], y_m: [0, 3]}
walls:
  - [2, 0, 2, 2]
boxes:
  - {name: chest, x_m: [3, 3.5], y_m: [1, 1.5]}
"""


def test_room_is_read():
    room = load_room(SMALL, path="small.yaml")
    assert room.x_m == (0.0, 4.0)
    assert room.boxes[0].name == "chest"
    assert len(room.all_walls()) == 1 + 4 + 4


@pytest.mark.parametrize(
    "change,line,key,words",
    [
        (("[2, 0, 2, 2]", "[2, 0, 2]"), 5, "walls", "list of 4"),
        (("[2, 0, 2, 2]", "[2, 0, 2, far]"), 5, "walls", "'far'"),
        (("resolution_m: 0.1", "resolution_m: .nan"), 1, "resolution_m", "finite"),
        (("resolution_m: 0.1", "resolution_m: 0.0001"), 1, "resolution_m", "cells"),
        (("wall_thickness_m: 0.1", "wall_thickness_m: -1"), 2, "wall_thickness_m", "positive"),
        (("[0, 4]", "[4, 0]"), 3, "bounds/x_m", "smaller"),
        (("boxes:", "boxen:"), 6, "boxen", "expected one of"),
        (("name: chest", "nome: chest"), 7, "nome", "unknown"),
        (("walls:", "bounds:"), 4, "bounds", "twice"),
        (("walls:\n", "walls: {\n"), 5, "-", "no YAML"),
    ],
)
def test_wrong_file_names_line_and_key(change, line, key, words):
    with pytest.raises(RoomError) as caught:
        load_room(SMALL.replace(*change), path="small.yaml")
    assert str(caught.value).startswith("small.yaml:")
    assert caught.value.key == key
    assert words in str(caught.value)
    if key != "-":
        assert caught.value.line == line


@pytest.mark.parametrize("text", ["", "3", "[]", "{}"])
def test_file_without_a_room_is_refused(text):
    with pytest.raises(RoomError):
        load_room(text, path="x.yaml")


def test_grid_has_walls_where_the_room_has():
    grid = grid_of_room(load_room(SMALL, path="small.yaml"))
    assert grid.is_taken.shape == (30, 40)
    assert not grid.is_free(2.0, 1.0) and grid.is_free(2.0, 2.5) and grid.is_free(1.0, 1.0)
    assert not grid.is_free(3.2, 1.2)
    assert not grid.is_free(0.0, 1.5) and not grid.is_free(4.5, 1.0)


def test_inflation_keeps_the_distance():
    grid = grid_of_room(load_room(SMALL, path="small.yaml")).inflated(0.3)
    assert not grid.is_free(1.7, 1.0) and grid.is_free(1.5, 1.0)
    assert not grid.is_free(0.2, 1.0)


def test_every_place_of_the_shipped_room_can_be_reached():
    room = load_room_file(os.path.join(CONFIG, "room.yaml"))
    grid = grid_of_room(room).inflated(0.4)
    with open(os.path.join(CONFIG, "places.yaml"), encoding="utf-8") as file:
        places = yaml.safe_load(file)
    assert {"office", "kitchen", "fridge", "room"} <= set(places)
    for place in places.values():
        assert plan(grid, start=(0.0, 0.0), goal=(place["x"], place["y"]))[-1] == (place["x"], place["y"])
