"""Places with names."""

import math

import pytest

from location_memorizer.locations import (
    Location,
    LocationFileError,
    read_locations,
    write_locations,
)
from roboframenet_ros.unreadable_file import set_aside

OFFICE = Location(frame_id="map", x_m=1.0, y_m=-2.5, heading_rad=math.pi / 2)


def test_written_places_are_read_again(tmp_path) -> None:
    path = str(tmp_path / "new" / "places.yaml")
    write_locations({"office": OFFICE}, path)
    assert read_locations(path) == {"office": OFFICE}


@pytest.mark.parametrize(
    "name",
    [
        "front\noffice",
        "front\r\noffice",
        "front\n\n office",
        "\noffice\n",
        "the the office",
        "a\x85b\u2028c",
        "no",
        "1",
        "",
    ],
)
def test_name_comes_back_as_it_was(name: str, tmp_path) -> None:
    path = str(tmp_path / "places.yaml")
    write_locations({name: OFFICE}, path)
    assert read_locations(path) == {name: OFFICE}


def test_writing_leaves_no_other_file(tmp_path) -> None:
    write_locations({"office": OFFICE}, str(tmp_path / "places.yaml"))
    assert [path.name for path in tmp_path.iterdir()] == ["places.yaml"]


@pytest.mark.parametrize(
    "text",
    [
        "- office",
        "office: 3",
        "office: {x: 1}",
        "office: {x: a, y: 2}",
        "office: {x: .nan, y: 2}",
        "office: {x: 1, y: 2, z: 3}",
        "office: [",
        "office: {x: 1, y: 2, frame_id: ''}",
    ],
)
def test_bad_file_is_refused_by_name(text: str, tmp_path) -> None:
    path = tmp_path / "places.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(LocationFileError, match=r"places\.yaml"):
        read_locations(str(path))


def test_empty_file_has_no_places(tmp_path) -> None:
    (tmp_path / "places.yaml").write_text("", encoding="utf-8")
    assert read_locations(str(tmp_path / "places.yaml")) == {}


def test_memory_that_cannot_be_read_is_kept(tmp_path) -> None:
    memory = tmp_path / "locations.yaml"
    for number, text in enumerate((b"office: {x: 1", b"name: \xff"), start=1):
        memory.write_bytes(text)
        with pytest.raises(LocationFileError):
            read_locations(str(memory))
        aside = set_aside(str(memory))
        assert aside == f"{memory}.unreadable.{number}"
        assert not memory.exists()
        with open(aside, "rb") as file:
            assert file.read() == text
        write_locations({}, str(memory))


def test_link_to_a_memory_stays_a_link(tmp_path) -> None:
    memory, link = tmp_path / "real.yaml", tmp_path / "locations.yaml"
    memory.write_text("{}")
    link.symlink_to(memory)
    write_locations({"office": Location("map", 1.0, 2.0, 0.0)}, str(link))
    assert link.is_symlink()
    assert "office" in read_locations(str(memory))
