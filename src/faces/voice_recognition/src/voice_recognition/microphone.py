"""A microphone as a program that writes sound: arecord, or another one."""

import shutil
import subprocess
from typing import Iterator, Optional, Sequence

from voice_recognition.recogniser import RATE

#: Seconds of a part of the stream.
PART_S = 0.04
PART_BYTES = int(RATE * PART_S) * 2


def arecord_command(device: str) -> Optional[Sequence[str]]:
    """Return the command line that records from a sound card; None when arecord is not installed.

    Args:
        device: of ALSA, "hw:1"; empty for the default one
    """
    program = shutil.which("arecord")
    if program is None:
        return None
    chosen = ["-D", device] if device else []
    return [program, "-q", *chosen, "-t", "raw", "-f", "S16_LE", "-r", str(RATE), "-c", "1", "-"]


class Microphone:
    """Reads 16 kHz, 16 bit, mono from the output of a program."""

    def __init__(self, command: Sequence[str]) -> None:
        """
        Args:
            command: program and arguments; no shell is involved
        Raises:
            OSError: the program cannot be started
        """
        self._process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
        )

    def parts(self) -> Iterator[bytes]:
        """Yield the parts of the stream until it ends."""
        stream = self._process.stdout
        assert stream is not None
        while True:
            part = stream.read(PART_BYTES)
            if len(part) < PART_BYTES:
                return
            yield part

    def close(self) -> None:
        """End the program."""
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait()
        if self._process.stdout is not None:
            self._process.stdout.close()
