"""Where sound comes from: a program that writes it, arecord or another one. A ROS topic: `ros_audio`."""

import shutil
import struct
import subprocess
import tempfile
from types import MappingProxyType
from typing import Iterable, Iterator, Mapping, Optional, Protocol, Sequence

from voice_recognition.recogniser import RATE

#: Seconds of a part of the stream.
PART_S = 0.04
PART_BYTES = int(RATE * PART_S) * 2
#: What arecord says when the sound card records at another rate than it was asked for.
OTHER_RATE = "rate is not accurate"
#: What audio_capture publishes, and the page; and the bytes before their array.
AUDIO_TYPE, PAGE_TYPE = "audio_common_msgs/AudioData", "std_msgs/UInt8MultiArray"
BYTES_BEFORE: Mapping[str, int] = MappingProxyType({AUDIO_TYPE: 0, PAGE_TYPE: 8})
#: Characters of what a program says that are told.
_TOLD = 200


class NoSound(ValueError):
    """A message has no sound; the message says why."""


class SoundSource(Protocol):
    """A microphone."""

    @property
    def complaint(self) -> str:
        """What is wrong with it, in its own words; empty for nothing."""

    def parts(self) -> Iterator[bytes]:
        """Yield the parts of the stream until it ends."""

    def close(self) -> None:
        """End it."""


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
        # A file, and no pipe, which would hold up a program that says much.
        self._says = tempfile.TemporaryFile()  # noqa: SIM115 (close() closes it)
        try:
            self._process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=self._says
            )
        except OSError:
            self._says.close()
            raise

    @property
    def complaint(self) -> str:
        """What the program said last, or that it records at another rate; empty for nothing."""
        self._says.seek(0)
        lines = [line.strip() for line in self._says.read().decode(errors="replace").splitlines() if line.strip()]
        other_rate = [line for line in lines if OTHER_RATE in line]
        return (other_rate or lines[-1:] or [""])[0][:_TOLD]

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
        self._says.close()


def sound_of_message(kind: str, content: bytes) -> bytes:
    """Return the sound in a serialised message.

    Args:
        kind: its type
        content: ends with an array of bytes that has its length before it
    Raises:
        NoSound: it is of another type, or is cut off
    """
    if kind not in BYTES_BEFORE:
        raise NoSound(f"{kind or 'nothing'} is no {AUDIO_TYPE}")
    begin = BYTES_BEFORE[kind] + 4
    if len(content) < begin or len(content) != begin + struct.unpack_from("<I", content, begin - 4)[0]:
        raise NoSound(f"a message of {kind} that is no plain array")
    return content[begin:]


def in_parts(sounds: Iterable[bytes]) -> Iterator[bytes]:
    """Yield sounds of any length as parts of the stream."""
    rest = b""
    for sound in sounds:
        rest += sound
        whole = len(rest) // PART_BYTES * PART_BYTES
        yield from (rest[at : at + PART_BYTES] for at in range(0, whole, PART_BYTES))
        rest = rest[whole:]
