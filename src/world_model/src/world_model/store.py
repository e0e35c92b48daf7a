"""Keeps what was learned in a SQLite file: what was acknowledged survives a killed process and a power cut."""

import json
import sqlite3
import uuid
from dataclasses import asdict
from typing import Any, Dict, List, Mapping, Tuple

from roboframenet_ros.sqlite_file import SqliteFile
from world_model.knowledge import Change, Learned
from world_model.world_object import Pose, Relation, Sort, WorldObject, mistakes

#: Written into the file; another number is a file of another program or version.
SCHEMA = 1


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

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def _to_text(learned: Learned) -> str:
    return json.dumps({**asdict(learned.about), "is_whole": learned.is_whole, "is_gone": learned.is_gone})


def _from_text(name: str, text: str) -> Learned:
    """Read an entry.

    Raises:
        ValueError, TypeError, KeyError: it is malformed
    """
    entry: Dict[str, Any] = json.loads(text)
    is_whole, is_gone = bool(entry.pop("is_whole")), bool(entry.pop("is_gone"))
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
    return Learned(about, is_whole, is_gone)
