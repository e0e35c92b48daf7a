"""Rooms: the sub-packages of the two largest packages. Each answers one question, and imports only rooms below it."""

import ast
import re
from pathlib import Path
from typing import Dict, List, Tuple

import pytest

from roboframenet_testing.workspace import REPOSITORY, imports, modules, package

#: The rooms of each package, from the lowest up. What stands in no room may import all of them.
ROOMS = {
    "utterance_passes": "trees phrases engine wording slips repairs asides deeds sharing messages",
    "semantic_framer": "values units kinds filling judging clauses referring queries changing asking linking sentences",
}
MOST_ROOMS = 12
#: A room stands on the floor above the highest room that it imports.
FLOORS = {"utterance_passes": 3, "semantic_framer": 6}
#: An arrow from one room to another, with the modules.
Arrow = Tuple[str, str, str]


def folder_of(name: str) -> Path:
    return package(name) / "src" / name


def room_of(module: str) -> str:
    """Return the room of "package.room.module"; "" for a module that stands in none."""
    parts = module.split(".")
    return parts[1] if len(parts) > 2 else ""


def arrows(name: str) -> List[Arrow]:
    """Return what the modules in the rooms of a package import from its other rooms, and from beside the rooms."""
    found: List[Arrow] = []
    paths = {one: path for one, path in modules().items() if one.startswith(f"{name}.") and path.stem != "__init__"}
    for module in filter(room_of, paths):
        for imported in sorted(imports(paths[module]) & set(paths)):
            if room_of(imported) != room_of(module):
                found.append((room_of(module), room_of(imported), f"{module} imports {imported}"))
    return found


def upward(found: List[Arrow], order: List[str]) -> List[str]:
    """Return the arrows that do not go down."""
    floors: Dict[str, int] = {room: number for number, room in enumerate(order)}
    return [text for room, other, text in found if floors.get(other, len(order)) >= floors[room]]


@pytest.mark.parametrize("name", ROOMS)
def test_rooms_are_those_of_the_list(name: str) -> None:
    found = {path.parent.name for path in folder_of(name).glob("*/__init__.py")}
    assert found == set(ROOMS[name].split()) and len(found) <= MOST_ROOMS


@pytest.mark.parametrize("name", ROOMS)
def test_a_room_says_in_one_line_which_question_it_answers(name: str) -> None:
    said = {
        path: ast.get_docstring(ast.parse(path.read_text("utf-8"))) for path in folder_of(name).glob("*/__init__.py")
    }
    assert not [str(path) for path, text in said.items() if not text or "\n" in text or not text.endswith("?")]


@pytest.mark.parametrize("name", ROOMS)
def test_a_room_imports_only_rooms_below_it(name: str) -> None:
    found = arrows(name)
    assert len(found) > 20
    assert not upward(found, ROOMS[name].split())


def floors(found: List[Arrow], order: List[str]) -> Dict[str, int]:
    """Return the floor of each room, from 1; the rooms are given from the lowest up."""
    above: Dict[str, int] = {}
    for room in order:
        above[room] = 1 + max((above[other] for one, other, _ in found if one == room), default=0)
    return above


@pytest.mark.parametrize("name", ROOMS)
def test_rooms_stand_on_few_floors(name: str) -> None:
    found = floors(arrows(name), ROOMS[name].split())
    assert max(found.values()) == FLOORS[name], found


def test_floors_are_counted() -> None:
    found = [("mid", "low", ""), ("high", "low", ""), ("high", "mid", "")]
    assert floors(found, ["low", "beside", "mid", "high"]) == {"low": 1, "beside": 1, "mid": 2, "high": 3}


@pytest.mark.parametrize("name", ROOMS)
def test_architecture_names_the_modules_of_each_room(name: str) -> None:
    rows = re.findall(
        rf"^\| \[(\w+)\]\(\.\./src/(?:language/)?{name}/.*\| ([\w, ]+) \|$",
        (REPOSITORY / "docs" / "architecture.md").read_text("utf-8"),
        re.MULTILINE,
    )
    paths = [path for path in folder_of(name).glob("*/*.py") if path.stem != "__init__"]
    assert {room: text.split(", ") for room, text in rows} == {
        room: sorted(path.stem for path in paths if path.parent.name == room) for room in ROOMS[name].split()
    }


def test_an_import_upward_is_found() -> None:
    found = [("low", "high", "up"), ("high", "low", "down"), ("low", "", "out")]
    assert upward(found, ["low", "high"]) == ["up", "out"]
