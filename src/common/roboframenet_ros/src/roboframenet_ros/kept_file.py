"""A value in a file that outlives its process."""

import contextlib
import json
import os
from pathlib import Path
from typing import Optional

_FORGOTTEN_AFTER_S = 30 * 24 * 3600.0
_LARGEST_LOG = 1 << 18


class KeptFile:
    """Holds one value. Its reader finds the last value that was saved, also when the writer was killed.

    Each value is a line of JSON at the end of the file, because a file system may take milliseconds to replace a file.
    A line without an end is one whose writer was killed. The file survives the process, not the power: nothing waits
    for the disk. It has one writer.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._log: Optional[int] = None
        self._size = 0

    def load(self) -> object:
        """Return the value; None when there is no file.

        Raises:
            ValueError: the file is not JSON
            OSError: it cannot be read
        """
        try:
            lines = self._path.read_bytes().split(b"\n")
        except FileNotFoundError:
            return None
        return json.loads(lines[-2]) if len(lines) > 1 else None

    def save(self, value: object) -> None:
        """Set the value.

        Raises:
            OSError: it cannot be written
        """
        line = json.dumps(value).encode() + b"\n"
        if self._log is None or self._size > max(_LARGEST_LOG, 4 * len(line)):
            self._begin(line)
            return
        written = os.write(self._log, line)
        self._size += written
        if written < len(line):
            self._begin(line)

    def close(self) -> None:
        """Close the file, which stays."""
        if self._log is not None:
            os.close(self._log)
            self._log = None

    def remove(self) -> None:
        """Close and remove the file; nothing when there is none, or when that fails."""
        self.close()
        with contextlib.suppress(OSError):
            self._path.unlink()

    def _begin(self, line: bytes) -> None:
        """Replace the file by one with this line."""
        self.close()
        self._path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        new = self._path.with_suffix(".new")
        log = os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_APPEND, 0o600)
        with contextlib.ExitStack() as failing:
            failing.callback(os.close, log)
            if os.write(log, line) < len(line):
                raise OSError(f"the disk is full: {new}")
            os.replace(new, self._path)
            failing.pop_all()
        self._log, self._size = log, len(line)


def remove_forgotten(folder: Path, *, now_s: float) -> None:
    """Remove the files that nobody has written for a month: their masters are gone.

    Args:
        folder: of kept files
        now_s: seconds since the epoch
    """
    with contextlib.suppress(OSError):
        for path in folder.iterdir():
            with contextlib.suppress(OSError):
                if now_s - path.stat().st_mtime > _FORGOTTEN_AFTER_S:
                    path.unlink()
