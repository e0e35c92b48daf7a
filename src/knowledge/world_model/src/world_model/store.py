"""Keeps what was learned in a SQLite file: what was acknowledged survives a killed process and a power cut."""

import json
import sqlite3
import uuid
from dataclasses import asdict, replace
from typing import Any, Dict, List, Mapping, Tuple

from roboframenet_ros.home_folder import file_in_ros_home
from roboframenet_ros.sqlite_file import SqliteFile
from world_model.knowledge import Change, Learned
from world_model.world_object import Pose, Relation, Sort, WorldObject, mistakes

#: Written into the file; another number is a file of another program or version.
SCHEMA = 1
#: What a run knows of the runs before it; each finds that out anew.
_OF_A_RUN = ("place_of_before_s", "states_of_before_s")
#: A stamp that is greater is one of the clock of the day: seconds since 1970.
_CLOCK_OF_THE_DAY_S = 1e9


def default_memory_file() -> str:
    """Return where the robot keeps what it learned when nobody names another file."""
    return file_in_ros_home("world.sqlite")


def forgotten_in_words(count: int) -> str:
    """Return what was forgotten, as a sentence for a person."""
    about = "1 object" if count == 1 else f"{count} objects"
    return f"The robot has forgotten what it had learned of {about}."


def _create(connection: sqlite3.Connection) -> None:
    connection.execute("CREATE TABLE IF NOT EXISTS learned (id TEXT PRIMARY KEY, entry TEXT NOT NULL)")
    connection.execute("CREATE TABLE IF NOT EXISTS version (store TEXT NOT NULL, number INTEGER NOT NULL)")
    if connection.execute("SELECT count(*) FROM version").fetchone() != (1,):
        connection.execute("DELETE FROM version")
        connection.execute("INSERT INTO version VALUES (?, 0)", (uuid.uuid4().hex[:8],))


class Store:
    """The file. One thread at a time uses it.

    Attributes:
        problems: what was wrong with the file when it was opened; it was set aside, or an entry was left out
    """

    def __init__(self, path: str) -> None:
        """Open the file, or make a new one. A file that cannot be read is renamed, and a new one takes its place.

        Args:
            path: of the file; ":memory:" keeps nothing
        Raises:
            StoreError: no file can be made there
        """
        self._file = SqliteFile(path, schema=SCHEMA, create=_create, is_every_change_synced=True)
        self.problems = self._file.problems

    def load(self) -> Dict[str, Learned]:
        """Return what was learned, by id; an entry that cannot be read is left out and becomes a problem.

        Raises:
            StoreError: the file cannot be read
        """
        found: Dict[str, Learned] = {}
        with self._file.reading() as connection:
            rows = connection.execute("SELECT id, entry FROM learned ORDER BY id").fetchall()
        for name, entry in rows:
            try:
                found[name] = _from_text(name, entry)
            except (ValueError, TypeError, KeyError) as error:
                self.problems += (f"{self._file.path}: the entry of {name!r} is left out: {error}",)
        return found

    def next_version(self) -> str:
        """Return a version that was never used, and store that it is used now.

        Raises:
            StoreError: it cannot be stored
        """
        return self.write(Change())

    def write(self, change: Change) -> str:
        """Store a change, as a whole or not at all; when this returns, it is on the disk.

        Returns:
            the version of what is known with the change
        Raises:
            StoreError: it was not stored
        """
        entries: List[Tuple[str, str]] = [(name, _to_text(learned)) for name, learned in change.learned.items()]
        with self._file.change() as connection:
            connection.executemany("DELETE FROM learned WHERE id = ?", [(name,) for name in change.forgotten])
            connection.executemany("INSERT OR REPLACE INTO learned VALUES (?, ?)", entries)
            connection.execute("UPDATE version SET number = number + 1")
            store, number = connection.execute("SELECT store, number FROM version").fetchone()
        return f"{store}-{number}"

    def clear(self) -> int:
        """Forget everything that was learned; return of how many objects that was.

        Raises:
            StoreError: it is not forgotten
        """
        with self._file.reading() as connection:
            names = tuple(name for (name,) in connection.execute("SELECT id FROM learned").fetchall())
        self.write(Change(forgotten=names))
        return len(names)

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def _to_text(learned: Learned) -> str:
    about = {key: value for key, value in asdict(learned.about).items() if key not in _OF_A_RUN}
    others = {key: getattr(learned, key) for key in ("is_whole", "is_gone", "place_s", "states_s")}
    return json.dumps({**about, **others})


def _from_text(name: str, text: str) -> Learned:
    """Read an entry.

    Raises:
        ValueError, TypeError, KeyError: it is malformed
    """
    entry: Dict[str, Any] = json.loads(text)
    is_whole, is_gone = bool(entry.pop("is_whole")), bool(entry.pop("is_gone"))
    is_of_day = entry["stamp_s"] > _CLOCK_OF_THE_DAY_S
    # An entry of a version that did not keep the times has the stamp alone, which may be that of a simulated clock.
    is_undated = "place_s" not in entry and not is_of_day
    stamp_s = entry["stamp_s"] if is_of_day else 0.0
    place_s, states_s = float(entry.pop("place_s", stamp_s)), float(entry.pop("states_s", stamp_s))
    pose: Any = entry.pop("pose")
    relations: List[Mapping[str, str]] = entry.pop("relations")
    lists = {key: tuple(value) for key, value in entry.items() if isinstance(value, list)}
    about = WorldObject(
        **{**entry, **lists, "sort": Sort(entry["sort"])},
        pose=Pose(**{**pose, "orientation": tuple(pose["orientation"])}) if pose else None,
        relations=tuple(Relation(**one) for one in relations),
    )
    reasons = mistakes(about)
    if reasons or about.id != name:
        raise ValueError("; ".join(reasons) or f"it is about {about.id!r}")
    if is_undated and about.sort not in (Sort.PLACE, Sort.DOOR):
        # Nobody can say when that was.
        about = replace(about.without_place(), states=())
    return Learned(about, is_whole, is_gone, place_s, states_s)
