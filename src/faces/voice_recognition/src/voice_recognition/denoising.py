"""Takes steady noise out of an utterance by spectral subtraction; the acoustic model was trained without noise."""

import numpy as np

from voice_recognition.sound import Samples, to_pcm, to_samples

#: Samples of a frame, and between two frames: 25 and 10 ms.
FRAME, STEP = 400, 160
_SPECTRUM = 512
#: Share of the frames that are taken for noise alone: the quietest ones.
NOISE_SHARE = 6
FEWEST_NOISE_FRAMES = 8
#: The noise is subtracted so many times, but this share of the power stays.
SUBTRACTED = 2.0
KEPT = 0.08
#: Power of a frame in the mean with those before it.
_NEW = 0.4


def without_noise(pcm: bytes) -> bytes:
    """Return an utterance without its steady noise.

    Args:
        pcm: 16 kHz, 16 bit, mono, with some quiet before or after the speech
    """
    samples = to_samples(pcm)
    if len(samples) < 4 * FRAME:
        return pcm
    window = np.hanning(FRAME + 1)[:-1]
    padded = np.concatenate([np.zeros(FRAME), samples, np.zeros(FRAME)])
    count = (len(padded) - FRAME) // STEP
    places = np.arange(FRAME)[None, :] + STEP * np.arange(count)[:, None]
    spectra = np.fft.rfft(padded[places] * window, _SPECTRUM)
    power: Samples = np.square(np.abs(spectra))
    gain = np.maximum(1.0 - SUBTRACTED * _noise(power)[None, :] / np.maximum(_smooth(power), 1e-9), KEPT)
    frames = np.fft.irfft(spectra * np.sqrt(gain), _SPECTRUM)[:, :FRAME] * window
    result: Samples = np.zeros(len(padded))
    weight: Samples = np.zeros(len(padded))
    for at in range(count):
        part = slice(at * STEP, at * STEP + FRAME)
        result[part] += frames[at]
        weight[part] += window * window
    result /= np.maximum(weight, 1e-3)
    return to_pcm(result[FRAME : FRAME + len(samples)])


def _noise(power: Samples) -> Samples:
    """Return the mean power of the quietest frames; those at both ends are half empty."""
    inner = power[3:-3]
    quietest = np.argsort(inner.sum(axis=1))[: max(FEWEST_NOISE_FRAMES, len(inner) // NOISE_SHARE)]
    noise: Samples = inner[quietest].mean(axis=0)
    return noise


def _smooth(power: Samples) -> Samples:
    """Return the power with that of the frames before; a sudden sound counts at once."""
    smooth = power.copy()
    for at in range(1, len(power)):
        smooth[at] = (1.0 - _NEW) * smooth[at - 1] + _NEW * power[at]
    return np.maximum(smooth, 0.5 * power)
