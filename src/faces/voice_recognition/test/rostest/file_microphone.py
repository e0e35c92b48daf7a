#!/usr/bin/python3
"""A microphone for tests: a quiet room in real time, and each sound file that appears in a folder."""

import random
import struct
import sys
import time
from pathlib import Path

PART = 1600


def main() -> None:
    folder = Path(sys.argv[1])
    chance = random.Random(1)
    left = b""
    next_at = time.monotonic()
    while True:
        if not left:
            for path in sorted(folder.glob("*.raw")):
                left += path.read_bytes()
                path.unlink()
        if left:
            part, left = left[: 2 * PART].ljust(2 * PART, b"\0"), left[2 * PART :]
        else:
            part = struct.pack(f"<{PART}h", *(chance.randint(-4, 4) for _ in range(PART)))
        sys.stdout.buffer.write(part)
        sys.stdout.buffer.flush()
        next_at += PART / 16000.0
        time.sleep(max(0.0, next_at - time.monotonic()))


main()
