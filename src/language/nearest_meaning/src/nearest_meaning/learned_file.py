"""Keeps what persons taught in a SQLite file: what was acknowledged survives a killed process and a power cut."""

import contextlib
import sqlite3
from typing import Callable, FrozenSet, List, Sequence, Tuple, TypeVar

from nearest_meaning.learned import Declined, LearnedUnit
from roboframenet_ros.home_folder import file_in_ros_home
from roboframenet_ros.sqlite_file import SqliteFile, StoreError

#: Written into the file; another number is a file of another program or version.
SCHEMA = 1
#: So many units can be taught; and so many times a no is kept, of which the oldest are deleted.
MOST_UNITS = 10_000
MOST_DECLINED = 10_000
_UNIT = "name, said, verb, frame, text, who, when_s, sentence"
_DECLINED = "said, frame, who, when_s, sentence"
_Row = TypeVar("_Row", LearnedUnit, Declined)


def default_learned_file() -> str:
    """Return where it is kept when nobody names another file."""
    return file_in_ros_home("learned.sqlite")


def _create(connection: sqlite3.Connection) -> None:
    connection.execute(
        "CREATE TABLE IF NOT EXISTS units (name TEXT PRIMARY KEY, said TEXT NOT NULL, verb TEXT NOT NULL,"
        " frame TEXT NOT NULL, text TEXT NOT NULL, who TEXT NOT NULL, when_s REAL NOT NULL, sentence TEXT NOT NULL)"
    )
    connection.execute(
        "CREATE TABLE IF NOT EXISTS declined (said TEXT NOT NULL, frame TEXT NOT NULL, who TEXT NOT NULL,"
        " when_s REAL NOT NULL, sentence TEXT NOT NULL, PRIMARY KEY (said, frame))"
    )


class LearnedFile:
    """The file. One thread at a time uses it; other processes may change it.

    Attributes:
        path: of the file
        problems: what was wrong with it when it was opened: it was set aside; and entries that were left out
    """

    def __init__(self, path: str) -> None:
        """Open the file, or make a new one. A file that cannot be read is renamed, and a new one takes its place.

        Args:
            path: of the file; ":memory:" keeps nothing
        Raises:
            StoreError: no file can be made there
        """
        self._file = SqliteFile(path, schema=SCHEMA, create=_create, is_every_change_synced=True)
        self.path = path
        self.problems = self._file.problems
        self._keep_left_over()

    def _keep_left_over(self) -> None:
        """Take over what can be read of a file that was set aside."""
        if not self._file.aside:
            return
        with self._file.change() as connection:
            for table, columns, read in (("units", _UNIT, _unit_of), ("declined", _DECLINED, _declined_of)):
                places = ", ".join("?" * len(columns.split(",")))
                for row in self._file.left_over(f"SELECT {columns} FROM {table}"):
                    with contextlib.suppress(ValueError):
                        read(row)
                        connection.execute(f"INSERT OR REPLACE INTO {table} ({columns}) VALUES ({places})", row)

    def version(self) -> int:
        """Return a number that changes whenever another process has changed the file.

        Raises:
            StoreError: the file cannot be read
        """
        with self._file.reading() as connection:
            return int(connection.execute("PRAGMA data_version").fetchone()[0])

    def units(self) -> Tuple[LearnedUnit, ...]:
        """Return the units, those taught first at the front; one that cannot be read is left out, and is a problem.

        Raises:
            StoreError: the file cannot be read
        """
        return self._rows(f"SELECT {_UNIT} FROM units ORDER BY when_s, name", _unit_of)

    def declined(self) -> FrozenSet[Tuple[str, str]]:
        """Return words that do not mean a frame, each with its name.

        Raises:
            StoreError: the file cannot be read
        """
        rows = self._rows(f"SELECT {_DECLINED} FROM declined", _declined_of)
        return frozenset((one.said, one.frame_name) for one in rows)

    def _rows(self, query: str, read: Callable[[Sequence[object]], _Row]) -> Tuple[_Row, ...]:
        with self._file.reading() as connection:
            rows = connection.execute(query).fetchall()
        found: List[_Row] = []
        for row in rows:
            try:
                found.append(read(row))
            except ValueError as error:
                problem = f"{self.path}: the entry {row[0]!r} is left out: {error}"
                if problem not in self.problems:
                    self.problems += (problem,)
        return tuple(found)

    def add(self, unit: LearnedUnit) -> None:
        """Store a unit; one with its name is replaced, and a no to it is forgotten.

        Raises:
            StoreError: it was not stored
        """
        with self._file.change() as connection:
            (count,) = connection.execute("SELECT count(*) FROM units WHERE name != ?", (unit.name,)).fetchone()
            if count >= MOST_UNITS:
                raise StoreError(f"{self.path} holds {MOST_UNITS} learned units already: forget some")
            row = (unit.name, unit.said, unit.verb, unit.frame_name, unit.text, unit.who, unit.when_s, unit.sentence)
            connection.execute(f"INSERT OR REPLACE INTO units ({_UNIT}) VALUES (?, ?, ?, ?, ?, ?, ?, ?)", row)
            connection.execute("DELETE FROM declined WHERE said = ? AND frame = ?", (unit.said, unit.frame_name))

    def decline(self, declined: Declined) -> None:
        """Store a no.

        Raises:
            StoreError: it was not stored
        """
        with self._file.change() as connection:
            row = (declined.said, declined.frame_name, declined.who, declined.when_s, declined.sentence)
            connection.execute(f"INSERT OR REPLACE INTO declined ({_DECLINED}) VALUES (?, ?, ?, ?, ?)", row)
            connection.execute(
                "DELETE FROM declined WHERE rowid NOT IN (SELECT rowid FROM declined ORDER BY when_s DESC LIMIT ?)",
                (MOST_DECLINED,),
            )

    def forget(self, name: str) -> bool:
        """Delete a unit by its name; return whether there was one.

        Raises:
            StoreError: it was not deleted
        """
        with self._file.change() as connection:
            return connection.execute("DELETE FROM units WHERE name = ?", (name,)).rowcount > 0

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def _unit_of(row: Sequence[object]) -> LearnedUnit:
    name, said, verb, frame, text, who, when_s, sentence = _texts_and_time(row, 6)
    return LearnedUnit(str(name), str(said), str(verb), str(frame), str(text), str(who), _time(when_s), str(sentence))


def _declined_of(row: Sequence[object]) -> Declined:
    said, frame, who, when_s, sentence = _texts_and_time(row, 3)
    return Declined(str(said), str(frame), str(who), _time(when_s), str(sentence))


def _texts_and_time(row: Sequence[object], time: int) -> Sequence[object]:
    if not all(isinstance(value, str) for place, value in enumerate(row) if place != time) or not row[0]:
        raise ValueError("it lacks a text")
    return row


def _time(value: object) -> float:
    if not isinstance(value, (int, float)):
        raise ValueError("it has no time")
    return float(value)
