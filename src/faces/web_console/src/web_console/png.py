"""Writes pixels as PNG, eight bits a channel: maps and camera images."""

import struct
import zlib
from typing import Tuple

import numpy as np

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
#: Types of colour.
_GREY, _RGB, _PALETTE = 0, 2, 3


def as_png(
    pixels: "np.ndarray[Tuple[int, int, int], np.dtype[np.uint8]]",
    *,
    level: int,
    palette: bytes = b"",
    transparency: bytes = b"",
) -> bytes:
    """Return a picture as a file.

    Args:
        pixels: rows from the top, of pixels with one channel or three: red, green and blue
        level: how hard it is compressed, 1 to 9
        palette: red, green and blue of each value of pixels with one channel; empty for grey
        transparency: of each value of the palette
    """
    height, width, depth = pixels.shape
    lines = np.zeros((height, 1 + width * depth), dtype=np.uint8)
    lines[:, 1:] = pixels.reshape(height, width * depth)
    colour = _PALETTE if palette else _RGB if depth == 3 else _GREY
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, colour, 0, 0, 0))]
    if palette:
        chunks += [(b"PLTE", palette), (b"tRNS", transparency)]
    chunks += [(b"IDAT", zlib.compress(lines.tobytes(), level)), (b"IEND", b"")]
    return _SIGNATURE + b"".join(
        struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body)) for name, body in chunks
    )
