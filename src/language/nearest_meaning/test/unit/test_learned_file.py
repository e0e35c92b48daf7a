"""The file of what persons taught: it survives damage and other versions, and other processes may change it."""

import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest

from nearest_meaning import learned_file
from nearest_meaning.learned import Declined, LearnedUnit, name_of
from nearest_meaning.learned_file import LearnedFile
from roboframenet_ros.sqlite_file import StoreError


def unit(name: str, when_s: float = 1.0) -> LearnedUnit:
    return LearnedUnit(name, "make your way", "go", "navigating", "frame_name: x\n", "anna", when_s, "Make your way.")


def test_what_is_learned_is_there_when_the_file_is_opened_again(tmp_path: Path) -> None:
    path = str(tmp_path / "deep" / "learned.sqlite")
    file = LearnedFile(path)
    file.add(unit("b", 2.0))
    file.add(unit("a", 3.0))
    file.decline(Declined("zoom", "moving", "bob", 4.0, "Zoom!"))
    file.close()
    again = LearnedFile(path)
    assert again.units() == (unit("b", 2.0), unit("a", 3.0)) and again.problems == ()
    assert again.declined() == {("zoom", "moving")}
    assert again.forget("b") and not again.forget("b")
    assert again.units() == (unit("a", 3.0),)


def test_a_yes_after_a_no_counts() -> None:
    file = LearnedFile(":memory:")
    file.decline(Declined("make your way", "navigating", "", 1.0, "Make your way."))
    file.add(unit("a"))
    assert file.declined() == frozenset()


def test_the_version_tells_what_another_process_changed(tmp_path: Path) -> None:
    path = str(tmp_path / "learned.sqlite")
    file, other = LearnedFile(path), LearnedFile(path)
    before = file.version()
    assert file.version() == before
    other.add(unit("a"))
    assert file.version() != before and file.units() == (unit("a"),)


@pytest.mark.parametrize("damage", ["cut", "text", "version"])
def test_a_file_that_cannot_be_read_is_set_aside_and_told(tmp_path: Path, damage: str) -> None:
    path = tmp_path / "learned.sqlite"
    file = LearnedFile(str(path))
    file.add(unit("a"))
    file.close()
    if damage == "cut":
        path.write_bytes(path.read_bytes()[:5000])
    elif damage == "text":
        path.write_text("not a database, " * 100)
    else:
        connection = sqlite3.connect(str(path))
        connection.execute("PRAGMA user_version=99")
        connection.commit()
        connection.close()
    again = LearnedFile(str(path))
    assert again.units() == () and str(path) in again.problems[0]
    assert any("learned.sqlite" in one.name and one != path for one in tmp_path.iterdir())
    again.add(unit("b"))
    assert again.units() == (unit("b"),)


@pytest.mark.parametrize("share", [0.5, 0.7, 0.9])
def test_what_can_be_read_of_a_file_that_was_cut_is_not_lost(tmp_path: Path, share: float) -> None:
    path = tmp_path / "learned.sqlite"
    file = LearnedFile(str(path))
    file.decline(Declined("zoom", "moving", "", 1.0, "Zoom."))
    for number in range(300):
        file.add(unit(f"unit{number:03d}"))
    file.close()
    path.write_bytes(path.read_bytes()[: int(share * path.stat().st_size)])
    again = LearnedFile(str(path))
    names = [one.name for one in again.units()]
    assert len(names) > 100 * share and set(names) <= {f"unit{number:03d}" for number in range(300)}
    assert str(path) in again.problems[0] and again.declined() == {("zoom", "moving")}


def test_two_processes_write_and_nothing_is_lost(tmp_path: Path) -> None:
    path = str(tmp_path / "learned.sqlite")
    code = (
        "import sys\n"
        "from nearest_meaning.learned import LearnedUnit\n"
        "from nearest_meaning.learned_file import LearnedFile\n"
        "file = LearnedFile(sys.argv[1])\n"
        "for n in range(30):\n    file.add(LearnedUnit(sys.argv[2] + str(n), 'a', 'go', 'going', 'x', '', 1.0, 'A.'))\n"
    )
    writers = [subprocess.Popen([sys.executable, "-c", code, path, name]) for name in ("first", "second")]
    assert [writer.wait(60) for writer in writers] == [0, 0]
    file = LearnedFile(path)
    assert len(file.units()) == 60 and file.problems == ()


def test_an_entry_that_cannot_be_read_is_left_out_and_the_others_stay(tmp_path: Path) -> None:
    path = str(tmp_path / "learned.sqlite")
    file = LearnedFile(path)
    file.add(unit("a"))
    file.add(unit("b"))
    connection = sqlite3.connect(path)
    connection.execute("UPDATE units SET when_s = 'noon' WHERE name = 'a'")
    connection.commit()
    connection.close()
    assert file.units() == (unit("b"),) and "'a'" in file.problems[0]
    file.units()
    assert len(file.problems) == 1


def test_a_full_file_refuses_more_and_replaces_what_it_has(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(learned_file, "MOST_UNITS", 2)
    monkeypatch.setattr(learned_file, "MOST_DECLINED", 2)
    file = LearnedFile(":memory:")
    file.add(unit("a"))
    file.add(unit("b"))
    with pytest.raises(StoreError):
        file.add(unit("c"))
    file.add(unit("a", 9.0))
    assert [one.name for one in file.units()] == ["b", "a"]
    for number in range(3):
        file.decline(Declined(f"verb{number}", "moving", "", float(number), "Do."))
    assert file.declined() == {("verb1", "moving"), ("verb2", "moving")}


def test_a_name_is_made_of_the_words_and_the_frame() -> None:
    assert name_of("Make your way", "navigating") == "make_your_way.navigating"
    assert name_of("...", "moving") == "unit.moving"
