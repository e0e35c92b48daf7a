"""SQLite files that several programs open."""

import sqlite3
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from roboframenet_ros.sqlite_file import SqliteFile

PROGRAMS, ROUNDS = 8, 30


def create(connection: sqlite3.Connection) -> None:
    connection.execute("CREATE TABLE IF NOT EXISTS words (word TEXT)")


def test_several_open_a_new_file_at_the_same_time(tmp_path: Path) -> None:
    for number in range(ROUNDS):
        path, together = str(tmp_path / f"{number}.sqlite"), threading.Barrier(PROGRAMS)

        def open_and_write(name: int, path: str = path, together: threading.Barrier = together) -> None:
            together.wait(10.0)
            file = SqliteFile(path, schema=1, create=create, is_every_change_synced=False)
            with file.change() as connection:
                connection.execute("INSERT INTO words VALUES (?)", (str(name),))
            file.connection.close()

        with ThreadPoolExecutor(PROGRAMS) as programs:
            list(programs.map(open_and_write, range(PROGRAMS)))
        with sqlite3.connect(path) as connection:
            assert connection.execute("SELECT count(*) FROM words").fetchone() == (PROGRAMS,)
