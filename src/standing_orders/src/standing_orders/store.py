"""Keeps standing orders in a SQLite file: what was acknowledged survives a killed process and a power cut."""

import json
import os
import sqlite3
from base64 import b64decode, b64encode
from dataclasses import asdict, replace
from datetime import datetime, time
from typing import Any, Dict, Iterable, List, Tuple, Type

from roboframenet_ros.unreadable_file import set_aside
from standing_orders.order import StandingOrder
from standing_orders.schedule import After, Daily, Every, Once, Schedule

#: Written into the file; another number is a file of another program or version.
SCHEMA = 1
#: How long to wait for a lock of another process, seconds.
_LOCK_TIMEOUT_S = 5.0
_KINDS: Dict[str, Type[Any]] = {kind.__name__: kind for kind in (Once, After, Every, Daily)}


class StoreError(RuntimeError):
    """Orders cannot be written or read; the message names the file and the reason."""


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
            self._file.execute("CREATE TABLE IF NOT EXISTS orders (id TEXT PRIMARY KEY, entry TEXT NOT NULL)")
            self._file.execute(f"PRAGMA user_version={SCHEMA}")
            self._file.execute("COMMIT")
        except sqlite3.Error:
            self._file.close()
            raise

    def load(self) -> Tuple[StandingOrder, ...]:
        """Return the orders, oldest first; one that cannot be read is left out and becomes a problem.

        Raises:
            StoreError: the file cannot be read
        """
        found: List[StandingOrder] = []
        try:
            rows = self._file.execute("SELECT id, entry FROM orders").fetchall()
        except sqlite3.Error as error:
            raise StoreError(f"{self._path} cannot be read: {error}") from error
        for name, entry in rows:
            try:
                order = order_from_text(entry)
                if order.order_id != name:
                    raise ValueError(f"it is about {order.order_id!r}")
                found.append(order)
            except (ValueError, TypeError, KeyError, AttributeError) as error:
                self.problems += (f"{self._path}: the order {name!r} is left out: {error}",)
        return tuple(sorted(found, key=lambda order: order.given_s))

    def write(self, kept: Iterable[StandingOrder], dropped: Iterable[str]) -> None:
        """Store a change, as a whole or not at all; when this returns, it is on the disk.

        Raises:
            StoreError: it was not stored
        """
        rows = [(order.order_id, order_to_text(order)) for order in kept]
        try:
            self._file.execute("BEGIN IMMEDIATE")
            try:
                self._file.executemany("INSERT OR REPLACE INTO orders VALUES (?, ?)", rows)
                self._file.executemany("DELETE FROM orders WHERE id = ?", [(name,) for name in dropped])
                self._file.execute("COMMIT")
            finally:
                if self._file.in_transaction:
                    self._file.execute("ROLLBACK")
        except sqlite3.Error as error:
            raise StoreError(f"{self._path} cannot be written: {error}") from error

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def order_to_text(order: StandingOrder) -> str:
    """Return an order as JSON."""
    entry = asdict(replace(order, schedule=None))
    entry["plan"] = b64encode(order.plan).decode("ascii")
    if order.schedule is not None:
        values: Dict[str, Any] = asdict(order.schedule)
        if "at" in values:
            values["at"] = values["at"].isoformat()
        entry["schedule"] = {"kind": type(order.schedule).__name__, **values}
    return json.dumps(entry)


def order_from_text(text: str) -> StandingOrder:
    """Read an order.

    Raises:
        ValueError, TypeError, KeyError, AttributeError: it is malformed
    """
    entry: Dict[str, Any] = json.loads(text)
    schedule = entry.pop("schedule")
    return StandingOrder(
        **{**entry, "plan": b64decode(entry["plan"], validate=True)},
        schedule=_schedule(**schedule) if schedule else None,
    )


def _schedule(kind: str, **values: Any) -> Schedule:
    if kind == "Once":
        values["at"] = datetime.fromisoformat(values["at"])
    elif kind == "Daily":
        values.update(at=time.fromisoformat(values["at"]), weekdays=tuple(values["weekdays"]))
    made: Schedule = _KINDS[kind](**values)
    return made
