"""Keeps standing orders in a SQLite file: what was acknowledged survives a killed process and a power cut."""

import json
import sqlite3
from base64 import b64decode, b64encode
from dataclasses import asdict, replace
from datetime import datetime, time
from typing import Any, Dict, Iterable, List, Tuple, Type

from roboframenet_ros.sqlite_file import SqliteFile
from standing_orders.order import StandingOrder
from standing_orders.schedule import After, Daily, Every, Once, Schedule

#: Written into the file; another number is a file of another program or version.
SCHEMA = 1
_KINDS: Dict[str, Type[Any]] = {kind.__name__: kind for kind in (Once, After, Every, Daily)}


def _create(connection: sqlite3.Connection) -> None:
    connection.execute("CREATE TABLE IF NOT EXISTS orders (id TEXT PRIMARY KEY, entry TEXT NOT NULL)")


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

    def load(self) -> Tuple[StandingOrder, ...]:
        """Return the orders, oldest first; one that cannot be read is left out and becomes a problem.

        Raises:
            StoreError: the file cannot be read
        """
        found: List[StandingOrder] = []
        with self._file.reading() as connection:
            rows = connection.execute("SELECT id, entry FROM orders").fetchall()
        for name, entry in rows:
            try:
                order = order_from_text(entry)
                if order.order_id != name:
                    raise ValueError(f"it is about {order.order_id!r}")
                found.append(order)
            except (ValueError, TypeError, KeyError, AttributeError) as error:
                self.problems += (f"{self._file.path}: the order {name!r} is left out: {error}",)
        return tuple(sorted(found, key=lambda order: order.given_s))

    def write(self, kept: Iterable[StandingOrder], dropped: Iterable[str]) -> None:
        """Store a change, as a whole or not at all; when this returns, it is on the disk.

        Raises:
            StoreError: it was not stored
        """
        rows = [(order.order_id, order_to_text(order)) for order in kept]
        with self._file.change() as connection:
            connection.executemany("INSERT OR REPLACE INTO orders VALUES (?, ?)", rows)
            connection.executemany("DELETE FROM orders WHERE id = ?", [(name,) for name in dropped])

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
