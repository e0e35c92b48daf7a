"""Spoken sentences for tests: voices of espeak-ng, flite and Piper, noise, echo."""

import shutil
import subprocess
import tempfile
from functools import lru_cache
from pathlib import Path
from typing import Tuple

import numpy as np

from utter.piper import Piper, installed_voice, piper_command
from voice_recognition.recogniser import RATE
from voice_recognition.sound import Samples, read_wav, to_pcm, to_samples

#: Program and voice.
VOICES = (
    ("espeak-ng", "en-us"),
    ("espeak-ng", "en-us+f3"),
    ("espeak-ng", "en-gb"),
    ("flite", "slt"),
    ("flite", "rms"),
    ("flite", "awb"),
)


def voices() -> Tuple[Tuple[str, str], ...]:
    """Return the voices that are installed."""
    return tuple(voice for voice in VOICES if shutil.which(voice[0]))


def speech(text: str, voice: Tuple[str, str] = VOICES[0], *, speed: int = 150) -> bytes:
    """Return a sentence in a synthetic voice: 16 kHz, 16 bit, mono."""
    program, name = voice
    if program == "piper":
        path = _piper().wave_of(text)
        assert path, "Piper is not installed: make piper"
        try:
            return read_wav(path)
        finally:
            Path(path).unlink()
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "said.wav")
        if program == "flite":
            command = ["flite", "-voice", name, "-t", text, "-o", path]
        else:
            command = ["espeak-ng", "-v", name, "-s", str(speed), "-w", path, "--", text]
        subprocess.run(command, check=True, timeout=60, capture_output=True)
        return read_wav(path)


@lru_cache(maxsize=1)
def _piper() -> Piper:
    return Piper(*piper_command(installed_voice()))


def with_silence(pcm: bytes, *, before_s: float = 0.5, after_s: float = 1.0) -> bytes:
    """Return a sound with silence around it."""
    return silence(before_s) + pcm + silence(after_s)


def silence(seconds: float, *, level: float = 4.0, seed: int = 0) -> bytes:
    """Return a quiet room: noise of a few quantization steps."""
    return to_pcm(np.random.default_rng(seed).normal(0.0, level, int(seconds * RATE)))


def noise_like_a_room(seconds: float, seed: int) -> Samples:
    """Return noise of unit power whose power falls with its frequency."""
    count = max(2, int(seconds * RATE))
    generator = np.random.default_rng(seed)
    spectrum = np.fft.rfft(generator.normal(0.0, 1.0, count))
    spectrum /= np.sqrt(np.maximum(np.arange(len(spectrum)), 1.0))
    noise: Samples = np.fft.irfft(spectrum, count)
    return noise / np.sqrt(np.mean(noise**2))


def with_noise(pcm: bytes, snr_db: float, seed: int) -> bytes:
    """Return a sound with noise; the ratio counts where somebody speaks."""
    samples = to_samples(pcm)
    loud = samples[np.abs(samples) > 0.05 * np.max(np.abs(samples))]
    level = np.sqrt(np.mean(loud**2)) * 10.0 ** (-snr_db / 20.0)
    return to_pcm(samples + level * noise_like_a_room(len(samples) / RATE, seed)[: len(samples)])


def with_echo(pcm: bytes, seed: int, *, fades_s: float = 0.4, share: float = 0.3) -> bytes:
    """Return a sound as a microphone hears it some metres away in a room.

    Args:
        pcm: the sound
        seed: of the room
        fades_s: seconds in which the echo becomes 60 dB quieter
        share: power of the echo, divided by that of the sound that comes straight
    """
    count = int(fades_s * RATE)
    times = np.arange(count) / RATE
    room = np.random.default_rng(seed).normal(0.0, 1.0, count) * 10.0 ** (-3.0 * times / fades_s)
    room[: int(0.004 * RATE)] = 0.0
    room *= np.sqrt(share / np.sum(room**2))
    room[0] = 1.0
    samples = to_samples(pcm)
    size = len(samples) + count
    return to_pcm(np.fft.irfft(np.fft.rfft(samples, size) * np.fft.rfft(room, size), size)[: len(samples)])
