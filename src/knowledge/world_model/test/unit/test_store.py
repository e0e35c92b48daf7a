"""The memory file: what was acknowledged is there again, and a file that cannot be read is set aside."""

import os
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from roboframenet_ros.sqlite_file import StoreError
from world_model import Pose, Relation, WorldObject
from world_model.knowledge import Change, Knowledge, Learned
from world_model.store import Store

MUG = WorldObject("mug_1", attributes=("red",), pose=Pose("map", 1.0, 2.0), relations=(Relation("on", "table_1"),))
WRITER = Path(__file__).resolve().parent.parent / "memory_writer.py"


def test_what_was_written_is_read_again(tmp_path) -> None:
    path = str(tmp_path / "new" / "world.sqlite")
    learned = {"mug_1": Learned(MUG), "cup": Learned(WorldObject("cup"), is_gone=True)}
    store = Store(path)
    first = store.write(Change(learned))
    store.close()
    again = Store(path)
    assert again.load() == learned
    assert again.next_version() not in ("", first)
    again.write(Change(forgotten=("cup",)))
    assert set(again.load()) == {"mug_1"}


@pytest.mark.parametrize("stamp_s, is_kept", [(1.7e9, True), (300.0, False)])
def test_entry_without_times_has_that_of_its_stamp_or_none(stamp_s: float, is_kept: bool, tmp_path) -> None:
    store = Store(str(tmp_path / "world.sqlite"))
    store.write(Change({"mug_1": Learned(replace(MUG, stamp_s=stamp_s))}))
    without = "json_remove(entry, '$.place_s', '$.states_s')"
    store._file.connection.execute(f"UPDATE learned SET entry = {without}")
    mug = Knowledge((), store.load()).objects["mug_1"]
    assert (mug.is_placed, mug.place_of_before_s) == (is_kept, stamp_s if is_kept else 0.0)
    assert store.clear() == 1
    assert store.load() == {}


@pytest.mark.parametrize("content", [b"no database, " * 500, b"SQLite format 3\0" + b"\xff" * 5000])
def test_file_that_cannot_be_read_is_set_aside(content: bytes, tmp_path) -> None:
    path = tmp_path / "world.sqlite"
    path.write_bytes(content)
    store = Store(str(path))
    assert store.load() == {}
    assert "unreadable.1" in store.problems[0]
    assert (tmp_path / "world.sqlite.unreadable.1").read_bytes() == content
    store.write(Change({"mug_1": Learned(MUG)}))
    store.close()
    assert set(Store(str(path)).load()) == {"mug_1"}


def test_damaged_page_is_noticed(tmp_path) -> None:
    path = tmp_path / "world.sqlite"
    store = Store(str(path))
    store.write(Change({f"mug_{number}": Learned(WorldObject(f"mug_{number}")) for number in range(500)}))
    store.close()
    content = bytearray(path.read_bytes())
    content[4096:] = b"\x5a" * (len(content) - 4096)
    path.write_bytes(content)
    assert Store(str(path)).problems


def test_wrong_entry_is_left_out_by_name(tmp_path) -> None:
    path = str(tmp_path / "world.sqlite")
    store = Store(path)
    store.write(Change({"mug_1": Learned(MUG)}))
    store._file.connection.execute("INSERT INTO learned VALUES ('cup', '{}')")
    assert set(store.load()) == {"mug_1"}
    assert "'cup'" in store.problems[0]


def test_folder_in_place_of_the_file_is_an_error(tmp_path) -> None:
    with pytest.raises(StoreError, match=str(tmp_path)):
        Store(str(tmp_path))


def killed_while_writing(path: Path, acknowledged_before_kill: int) -> int:
    """Kill a writer after it has acknowledged some updates; returns how many it acknowledged."""
    writer = subprocess.Popen([sys.executable, str(WRITER), str(path)], stdout=subprocess.PIPE)
    assert writer.stdout is not None
    for _ in range(acknowledged_before_kill):
        assert writer.stdout.readline()
    os.kill(writer.pid, signal.SIGKILL)
    rest = writer.stdout.read().decode().split("\n")
    writer.wait()
    # The last line may have been cut by the kill.
    return acknowledged_before_kill + len(rest) - 1


def check_kills(path: Path, moments: range) -> None:
    known = 0
    for moment in moments:
        acknowledged = killed_while_writing(path, 1 + (moment * 7919) % 23)
        store = Store(str(path))
        assert not store.problems
        known += acknowledged
        numbers = [int(name.rpartition("_")[2]) for name in store.load()]
        assert len(numbers) >= known, "something that was acknowledged is lost"
        known = len(numbers)
        store.close()


def test_killed_writer_loses_nothing_that_it_acknowledged(tmp_path) -> None:
    check_kills(tmp_path / "world.sqlite", range(5))


@pytest.mark.reliability
def test_writer_killed_at_50_moments_loses_nothing_that_it_acknowledged(tmp_path) -> None:
    check_kills(tmp_path / "world.sqlite", range(50))
