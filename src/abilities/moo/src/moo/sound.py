"""Computes the sound of a cow."""

import math
import struct
import wave
from typing import List

SAMPLE_RATE_HZ = 16000


def moo(duration_s: float = 1.6, *, loudness: float = 0.6) -> List[float]:
    """Return the samples of a moo.

    A voiced sound whose pitch rises and falls. Its overtones weaken as the mouth opens and closes.

    Args:
        duration_s: length of the sound, above 0
        loudness: peak of the samples, 0 to 1
    Returns:
        samples between -loudness and loudness, SAMPLE_RATE_HZ of them a second
    Raises:
        ValueError: duration or loudness out of range
    """
    if not 0.0 < duration_s <= 10.0 or not 0.0 <= loudness <= 1.0:
        raise ValueError(f"duration_s must be above 0 and at most 10, loudness 0 to 1: got {duration_s}, {loudness}")
    samples = []
    phase = 0.0
    count = int(duration_s * SAMPLE_RATE_HZ)
    for index in range(count):
        progress = index / count
        opening = math.sin(math.pi * progress)
        phase += 2.0 * math.pi * (95.0 + 45.0 * opening) / SAMPLE_RATE_HZ
        samples.append(opening * sum(math.sin(k * phase) * (0.35 + 0.4 * opening) ** (k - 1) / k for k in range(1, 9)))
    peak = max(abs(sample) for sample in samples)
    return [loudness * sample / peak for sample in samples]


def write_wave(samples: List[float], path: str) -> None:
    """Write samples as a 16-bit mono WAV file."""
    with wave.open(path, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(SAMPLE_RATE_HZ)
        file.writeframes(b"".join(struct.pack("<h", int(32767 * sample)) for sample in samples))
