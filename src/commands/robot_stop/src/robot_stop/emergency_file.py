"""Keeps whether the emergency stop holds in a file, for nodes and masters that are started again."""

import contextlib
import fcntl
import json
import os
import time
from pathlib import Path
from typing import Callable, Iterator

from robot_stop.emergency import Emergency, engaged, from_json, newer, to_json

#: How long another writer may take; it writes some bytes. Seconds.
_LOCK_TIMEOUT_S = 1.0
_LOCK_POLL_S = 0.01
_LONGEST_FILE = 4096


class EmergencyFile:
    """One file, which several processes write. It is replaced as a whole, and is on the disk when a call returns.

    A file that cannot be read holds the robot: nobody knows what was in it.
    """

    def __init__(self, path: Path) -> None:
        """
        Args:
            path: of the file, which need not exist
        """
        self.path = path

    def load(self) -> Emergency:
        """Return the state; one that holds the robot if there is a file and it cannot be read."""
        try:
            with open(self.path, "rb") as file:
                return from_json(json.loads(file.read(_LONGEST_FILE)))
        except FileNotFoundError:
            return Emergency()
        except (OSError, ValueError, RecursionError) as error:
            by = f"{self.path} cannot be read: {error}"
            return engaged(Emergency(), by=by, now_s=time.time())

    def update(self, state: Emergency, change: Callable[[Emergency], Emergency]) -> Emergency:
        """Change the state, and write it down.

        Args:
            state: what this process knows; what the file knows counts if it is newer
            change: returns the new state; called with the newest one
        Returns:
            the new state
        Raises:
            OSError: it could not be written
        """
        self.path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        with self._locked():
            new = change(newer(state, self.load()))
            self._write(new)
        return new

    def _write(self, state: Emergency) -> None:
        part = self.path.with_suffix(".new")
        with open(part, "wb") as file:
            file.write(json.dumps(to_json(state)).encode())
            file.flush()
            os.fsync(file.fileno())
        os.replace(part, self.path)
        folder = os.open(self.path.parent, os.O_RDONLY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)

    @contextlib.contextmanager
    def _locked(self) -> Iterator[None]:
        """Raises OSError when another writer holds the lock for too long: it hangs."""
        end_s = time.monotonic() + _LOCK_TIMEOUT_S
        lock = os.open(self.path.with_suffix(".lock"), os.O_RDWR | os.O_CREAT, 0o600)
        try:
            while True:
                try:
                    fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                    break
                except BlockingIOError:
                    if time.monotonic() >= end_s:
                        raise
                    time.sleep(_LOCK_POLL_S)
            yield
        finally:
            os.close(lock)
