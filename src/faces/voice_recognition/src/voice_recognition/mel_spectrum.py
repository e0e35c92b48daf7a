"""The sound as Whisper takes it: the logarithm of its power in 80 bands that are spaced as the ear hears them."""

from functools import lru_cache

import numpy as np
import numpy.typing as npt

from voice_recognition.recogniser import RATE
from voice_recognition.sound import to_unit_samples

Spectrum = npt.NDArray[np.float32]

#: Bands, samples of a frame, and samples between two frames: those of the model's training.
BANDS, FRAME, STEP = 80, 400, 160
#: Hz of a mel below the knee of the scale, the knee, and the logarithm of the factor of a mel above it.
_LINEAR_HZ, _KNEE_HZ, _LOG_STEP = 200.0 / 3.0, 1000.0, float(np.log(6.4)) / 27.0
#: What is so many powers of ten below the loudest part is silence.
_RANGE = 8.0


def mel_spectrum(pcm: bytes, seconds: float) -> Spectrum:
    """Return the bands of a sound, one row for each band.

    Args:
        pcm: 16 kHz, 16 bit, mono
        seconds: silence is put behind it up to this length; what is beyond it is cut off
    """
    count = int(seconds * RATE)
    samples = to_unit_samples(pcm)[:count]
    padded = np.pad(np.pad(samples, (0, count - len(samples))), FRAME // 2, mode="reflect")
    frames = np.lib.stride_tricks.sliding_window_view(padded, FRAME)[::STEP][: count // STEP]
    power = np.square(np.abs(np.fft.rfft(frames * _window(), axis=1)))
    bands = np.log10(np.maximum(_filters() @ power.T, 1e-10))
    bands = np.maximum(bands, bands.max() - _RANGE)
    found: Spectrum = np.ascontiguousarray((bands + 4.0) / 4.0, dtype=np.float32)
    return found


@lru_cache(maxsize=1)
def _window() -> Spectrum:
    window: Spectrum = np.hanning(FRAME + 1)[:-1].astype(np.float32)
    return window


@lru_cache(maxsize=1)
def _filters() -> npt.NDArray[np.float64]:
    """Return triangles over the frequencies, of equal area, one row for each band."""
    highest = _KNEE_HZ / _LINEAR_HZ + float(np.log(RATE / 2 / _KNEE_HZ)) / _LOG_STEP
    mels = np.linspace(0.0, highest, BANDS + 2)
    knee = _KNEE_HZ / _LINEAR_HZ
    centres = np.where(mels < knee, _LINEAR_HZ * mels, _KNEE_HZ * np.exp(_LOG_STEP * (mels - knee)))
    slopes = centres[:, None] - np.fft.rfftfreq(FRAME, 1.0 / RATE)[None, :]
    widths = np.diff(centres)[:, None]
    triangles = np.maximum(0.0, np.minimum(-slopes[:-2] / widths[:-1], slopes[2:] / widths[1:]))
    found: npt.NDArray[np.float64] = triangles * (2.0 / (centres[2:] - centres[:-2]))[:, None]
    return found
