"""A SQLite file that survives kill -9: a journal, a check when it is opened, and whole changes."""

import contextlib
import os
import sqlite3
import time
from pathlib import Path
from typing import Callable, Iterator, Sequence, Tuple

from roboframenet_ros.unreadable_file import set_aside

#: How long to wait for a lock of another process, seconds.
_LOCK_TIMEOUT_S = 5.0
#: Between two tries where SQLite does not wait itself, seconds.
_RETRY_S = 0.02


class StoreError(RuntimeError):
    """The file cannot be written or read; the message names it and the reason."""


class SqliteFile:
    """The file. One thread at a time uses it.

    Attributes:
        path: of the file
        problems: what was wrong with it when it was opened; it was set aside
        aside: where it is kept then; empty when nothing was wrong
        connection: to the file, in a state where each statement is a change of its own
    """

    def __init__(
        self, path: str, *, schema: int, create: Callable[[sqlite3.Connection], None], is_every_change_synced: bool
    ) -> None:
        """Open the file, or make a new one. A file that cannot be read is renamed, and a new one takes its place.

        Args:
            path: of the file; ":memory:" keeps nothing
            schema: is written into the file, 1 or more; another number is a file of another program or version
            create: makes the tables that are not there, inside a change
            is_every_change_synced: whether a change also survives a power cut as soon as it is made. Without it, a
                power cut may lose the last changes, but damages nothing; a killed process loses nothing in either case
        Raises:
            StoreError: no file can be made there
        """
        self.problems: Tuple[str, ...] = ()
        self.aside = ""
        self.path = path
        self._schema = schema
        self._create = create
        self._level = "FULL" if is_every_change_synced else "NORMAL"
        try:
            if path != ":memory:":
                os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
            try:
                self._open()
            except sqlite3.OperationalError:
                # A locked or unreachable file is not corrupt.
                raise
            except sqlite3.DatabaseError as error:
                self.aside = set_aside(path, journals=("-wal", "-shm"))
                self.problems += (f"{path} cannot be read ({error}): it is kept as {self.aside}, and a new one begins",)
                self._open()
        except (OSError, sqlite3.Error) as error:
            raise StoreError(f"{path} cannot be opened: {error}") from error

    def _open(self) -> None:
        self.connection = sqlite3.connect(
            self.path, timeout=_LOCK_TIMEOUT_S, isolation_level=None, check_same_thread=False
        )
        try:
            self._write_ahead()
            self.connection.execute(f"PRAGMA synchronous={self._level}")
            (verdict,) = self.connection.execute("PRAGMA quick_check(1)").fetchone()
            (schema,) = self.connection.execute("PRAGMA user_version").fetchone()
            if verdict != "ok":
                raise sqlite3.DatabaseError(verdict)
            if schema not in (0, self._schema):
                raise sqlite3.DatabaseError(f"its format is {schema}, and {self._schema} is known")
            self.connection.execute("BEGIN IMMEDIATE")
            self._create(self.connection)
            self.connection.execute(f"PRAGMA user_version={self._schema}")
            self.connection.execute("COMMIT")
        except sqlite3.Error:
            self.connection.close()
            raise

    def _write_ahead(self) -> None:
        """Keep changes in a journal of their own. SQLite does not wait for others that ask for it at the same time."""
        end_s = time.monotonic() + _LOCK_TIMEOUT_S
        while True:
            try:
                self.connection.execute("PRAGMA journal_mode=WAL").fetchall()
                return
            except sqlite3.OperationalError as error:
                if "locked" not in str(error) or time.monotonic() >= end_s:
                    raise
            time.sleep(_RETRY_S)

    def left_over(self, query: str) -> Iterator[Sequence[object]]:
        """Yield the rows of the file that was set aside, as far as they can be read; none of another format.

        Args:
            query: which rows; in the order of the table, so that as many as possible are found
        """
        if not self.aside:
            return
        left = sqlite3.connect(f"{Path(self.aside).absolute().as_uri()}?mode=ro", uri=True)
        with contextlib.closing(left), contextlib.suppress(sqlite3.Error):
            # Otherwise nothing is read of a file that is shorter than it says.
            left.execute("PRAGMA writable_schema=ON")
            (schema,) = left.execute("PRAGMA user_version").fetchone()
            if schema == self._schema:
                yield from left.execute(query)

    @contextlib.contextmanager
    def reading(self) -> Iterator[sqlite3.Connection]:
        """Read.

        Raises:
            StoreError: the file cannot be read
        """
        try:
            yield self.connection
        except sqlite3.Error as error:
            raise StoreError(f"{self.path} cannot be read: {error}") from error

    @contextlib.contextmanager
    def change(self) -> Iterator[sqlite3.Connection]:
        """Make a change, as a whole or not at all.

        Raises:
            StoreError: it was not made
        """
        try:
            self.connection.execute("BEGIN IMMEDIATE")
            try:
                yield self.connection
                self.connection.execute("COMMIT")
            finally:
                if self.connection.in_transaction:
                    self.connection.execute("ROLLBACK")
        except sqlite3.Error as error:
            raise StoreError(f"{self.path} cannot be written: {error}") from error

    def close(self) -> None:
        """Close the file."""
        self.connection.close()
