"""Sound files."""

import struct
import wave

import numpy as np
import pytest

from voice_recognition.recogniser import RATE
from voice_recognition.sound import (
    UnreadableSound,
    clipped_share,
    duration_s,
    level_db,
    read_wav,
    resample,
    to_samples,
    write_wav,
)


def tone(hertz: float, rate: int, seconds: float = 0.5) -> np.ndarray:
    return 8000.0 * np.sin(2 * np.pi * hertz * np.arange(int(rate * seconds)) / rate)


@pytest.mark.parametrize("rate", [8000, 11025, 16000, 22050, 44100, 48000])
def test_a_tone_keeps_its_pitch_and_level(rate: int) -> None:
    heard = resample(tone(1000.0, rate), rate, RATE)
    assert len(heard) == pytest.approx(0.5 * RATE, abs=2)
    middle = heard[1000:-1000]
    assert level_db(middle) == pytest.approx(level_db(tone(1000.0, rate)), abs=0.3)
    spectrum = np.abs(np.fft.rfft(middle))
    assert np.argmax(spectrum) * RATE / len(middle) == pytest.approx(1000.0, abs=20.0)


def test_what_is_too_high_is_filtered_out() -> None:
    assert level_db(resample(tone(12000.0, 48000), 48000, RATE)[500:-500]) < level_db(tone(12000.0, 48000)) - 30


def test_files_with_two_channels_and_eight_bits_are_read(tmp_path) -> None:
    path = str(tmp_path / "stereo.wav")
    with wave.open(path, "wb") as file:
        file.setnchannels(2)
        file.setsampwidth(1)
        file.setframerate(8000)
        file.writeframes(bytes([128, 192]) * 8000)
    heard = to_samples(read_wav(path))
    assert duration_s(read_wav(path)) == pytest.approx(1.0, abs=0.01)
    assert np.median(heard) == pytest.approx(32 * 256, rel=0.05)


@pytest.mark.parametrize("content", [b"", b"no sound at all", struct.pack("<4sI4s", b"RIFF", 4, b"WAVE")])
def test_what_is_no_sound_is_refused(content: bytes) -> None:
    with pytest.raises(UnreadableSound):
        read_wav(content)


def test_what_was_written_is_read(tmp_path) -> None:
    path = str(tmp_path / "tone.wav")
    pcm = tone(500.0, RATE).astype("<i2").tobytes()
    write_wav(path, pcm)
    assert read_wav(path) == pcm


def test_sound_that_is_cut_off_is_told_from_loud_sound() -> None:
    loud = tone(200.0, RATE) * 4.0
    assert clipped_share(np.clip(loud, -32768, 32767).astype("<i2").tobytes()) == 0.0
    assert clipped_share(np.clip(loud * 2.0, -32768, 32767).astype("<i2").tobytes()) > 0.3
    assert clipped_share(b"") == 0.0
