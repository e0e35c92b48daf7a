"""Keeps what was learned in a SQLite file: what was acknowledged survives a killed process and a power cut."""

import json
import os
import sqlite3
import uuid
from dataclasses import asdict
from typing import Any, Dict, List, Mapping, Tuple

from roboframenet_ros.unreadable_file import set_aside
from world_model.knowledge import Change, Learned
from world_model.world_object import Pose, Relation, Sort, WorldObject, mistakes

#: Written into the file; another number is a file of another program or version.
SCHEMA = 1
#: How long to wait for a lock of another process, seconds.
_LOCK_TIMEOUT_S = 5.0


class StoreError(RuntimeError):
    """What was learned cannot be written or read; the message names the file and the reason."""


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
        self.problems: Tuple[str, ...] = ()
        self._path = path
        try:
            if path != ":memory:":
                os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
            try:
                self._open()
            except sqlite3.OperationalError:
                # A locked or unreachable file is not corrupt.
                raise
            except sqlite3.DatabaseError as error:
                aside = set_aside(path, journals=("-wal", "-shm"))
                self.problems += (f"{path} cannot be read ({error}): it is kept as {aside}, and a new one begins",)
                self._open()
        except (OSError, sqlite3.Error) as error:
            raise StoreError(f"{path} cannot be opened: {error}") from error

    def _open(self) -> None:
        self._file = sqlite3.connect(self._path, timeout=_LOCK_TIMEOUT_S, isolation_level=None, check_same_thread=False)
        try:
            self._file.execute("PRAGMA journal_mode=WAL").fetchall()
            self._file.execute("PRAGMA synchronous=FULL")
            (verdict,) = self._file.execute("PRAGMA quick_check(1)").fetchone()
            (schema,) = self._file.execute("PRAGMA user_version").fetchone()
            if verdict != "ok":
                raise sqlite3.DatabaseError(verdict)
            if schema not in (0, SCHEMA):
                raise sqlite3.DatabaseError(f"its format is {schema}, and {SCHEMA} is known")
            self._file.execute("BEGIN IMMEDIATE")
            self._file.execute("CREATE TABLE IF NOT EXISTS learned (id TEXT PRIMARY KEY, entry TEXT NOT NULL)")
            self._file.execute("CREATE TABLE IF NOT EXISTS version (store TEXT NOT NULL, number INTEGER NOT NULL)")
            if self._file.execute("SELECT count(*) FROM version").fetchone() != (1,):
                self._file.execute("DELETE FROM version")
                self._file.execute("INSERT INTO version VALUES (?, 0)", (uuid.uuid4().hex[:8],))
            self._file.execute(f"PRAGMA user_version={SCHEMA}")
            self._file.execute("COMMIT")
        except sqlite3.Error:
            self._file.close()
            raise

    def load(self) -> Dict[str, Learned]:
        """Return what was learned, by id; an entry that cannot be read is left out and becomes a problem.

        Raises:
            StoreError: the file cannot be read
        """
        found: Dict[str, Learned] = {}
        try:
            rows = self._file.execute("SELECT id, entry FROM learned ORDER BY id").fetchall()
        except sqlite3.Error as error:
            raise StoreError(f"{self._path} cannot be read: {error}") from error
        for name, entry in rows:
            try:
                found[name] = _from_text(name, entry)
            except (ValueError, TypeError, KeyError) as error:
                self.problems += (f"{self._path}: the entry of {name!r} is left out: {error}",)
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
        try:
            self._file.execute("BEGIN IMMEDIATE")
            try:
                self._file.executemany("DELETE FROM learned WHERE id = ?", [(name,) for name in change.forgotten])
                self._file.executemany("INSERT OR REPLACE INTO learned VALUES (?, ?)", entries)
                self._file.execute("UPDATE version SET number = number + 1")
                store, number = self._file.execute("SELECT store, number FROM version").fetchone()
                self._file.execute("COMMIT")
            finally:
                if self._file.in_transaction:
                    self._file.execute("ROLLBACK")
        except sqlite3.Error as error:
            raise StoreError(f"{self._path} cannot be written: {error}") from error
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
