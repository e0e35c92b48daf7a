"""Sound as values: 16 bit, mono, at the rate of the recogniser."""

import io
import wave
from typing import Union

import numpy as np
import numpy.typing as npt

from voice_recognition.recogniser import RATE

Samples = npt.NDArray[np.float64]

#: Taps on each side of the low pass.
_TAPS = 24
#: Lowest frequency of a voice that counts for its level, Hz.
LOWEST_HZ = 150.0
#: Samples of this size may have been cut off.
_LOUDEST = 32700.0
#: Longest file, seconds.
LONGEST_S = 3600.0


class UnreadableSound(ValueError):
    """A file is no sound that can be read; the message says why."""


def read_wav(source: Union[str, bytes]) -> bytes:
    """Read a WAV file of any rate and number of channels.

    Args:
        source: its path, or its content
    Returns:
        16 kHz, 16 bit, mono
    Raises:
        UnreadableSound: it is none, it is longer than an hour, or its samples have not 8 or 16 bit
    """
    try:
        with wave.open(io.BytesIO(source) if isinstance(source, bytes) else source, "rb") as file:
            rate, width, channels = file.getframerate(), file.getsampwidth(), file.getnchannels()
            # A program that writes to a pipe does not know the length, and says the greatest one.
            content = file.readframes(int(min(file.getnframes(), rate * LONGEST_S)))
    except (OSError, EOFError, wave.Error) as error:
        raise UnreadableSound(f"no WAV file that can be read: {error}") from error
    if width not in (1, 2):
        raise UnreadableSound(f"samples of {8 * width} bit; 8 or 16 can be read")
    content = content[: len(content) // (width * channels) * width * channels]
    if width == 2:
        samples = np.frombuffer(content, dtype="<i2").astype(np.float64)
    else:
        samples = (np.frombuffer(content, dtype=np.uint8).astype(np.float64) - 128.0) * 256.0
    return to_pcm(resample(samples.reshape(-1, channels).mean(axis=1), rate, RATE))


def write_wav(path: str, pcm: bytes) -> None:
    """Write sound of the recogniser's rate into a file."""
    with wave.open(path, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(RATE)
        file.writeframes(pcm)


def to_pcm(samples: Samples) -> bytes:
    """Return samples as 16 bit; louder ones are cut off."""
    return np.clip(np.rint(samples), -32768, 32767).astype("<i2").tobytes()


def to_samples(pcm: bytes) -> Samples:
    """Return 16 bit samples as numbers from -32768 to 32767."""
    return np.frombuffer(pcm, dtype="<i2").astype(np.float64)


def to_unit_samples(pcm: bytes) -> npt.NDArray[np.float32]:
    """Return 16 bit samples as numbers from -1 to 1, as networks take them."""
    return (to_samples(pcm) / 32768.0).astype(np.float32)


def resample(samples: Samples, rate: int, new_rate: int) -> Samples:
    """Return samples at another rate, by a windowed sinc; what is above the new limit is filtered out."""
    if rate == new_rate or not len(samples):
        return samples
    scale = min(1.0, new_rate / rate)
    reach = int(np.ceil(_TAPS / scale))
    times = np.arange(int(len(samples) * new_rate / rate)) * (rate / new_rate)
    base = np.floor(times).astype(np.int64)
    padded = np.concatenate([np.zeros(reach), samples, np.zeros(reach + 1)])
    result: Samples = np.zeros(len(times))
    for offset in range(-reach + 1, reach + 1):
        distance = times - (base + offset)
        window = 0.5 + 0.5 * np.cos(np.pi * np.clip(distance / reach, -1.0, 1.0))
        result += padded[base + offset + reach] * scale * np.sinc(scale * distance) * window
    return result


def duration_s(pcm: bytes) -> float:
    """Return how long a sound is, in seconds."""
    return len(pcm) / 2 / RATE


def clipped_share(pcm: bytes) -> float:
    """Return which share of a sound is as loud as it can be: what was louder was cut off."""
    samples = to_samples(pcm)
    return float(np.mean(np.abs(samples) >= _LOUDEST)) if len(samples) else 0.0


def level_db(samples: Samples) -> float:
    """Return the level below full scale in decibels: 0 for the loudest square wave, -100 for silence."""
    return _decibels(float(np.mean(samples**2)) if len(samples) else 0.0)


def speech_level_db(samples: Samples) -> float:
    """Return the level of what may be speech, decibels below full scale: without hum and rumble.

    The noise of a room lies mostly below a voice. There its level also changes from one moment to the next as much as
    that of somebody who begins and ends to speak.
    """
    if not len(samples):
        return -100.0
    window = np.hanning(len(samples))
    spectrum = np.abs(np.fft.rfft(samples * window)) ** 2
    first = int(np.ceil(LOWEST_HZ * len(samples) / RATE))
    return _decibels(2.0 * float(np.sum(spectrum[first:])) / (len(samples) * float(np.sum(window**2))))


def _decibels(power: float) -> float:
    return max(-100.0, 10.0 * float(np.log10(power / 32768.0**2 + 1e-10)))
