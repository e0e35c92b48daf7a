"""Steady noise is taken out."""

import numpy as np
import pytest

from voice_recognition.denoising import without_noise
from voice_recognition.recogniser import RATE
from voice_recognition.sound import level_db, to_pcm, to_samples


def test_noise_gets_quieter_and_the_voice_stays() -> None:
    generator = np.random.default_rng(1)
    noise = generator.normal(0.0, 300.0, 2 * RATE)
    voice = np.zeros(2 * RATE)
    voice[RATE // 2 : RATE] = 5000.0 * np.sin(2 * np.pi * 440.0 * np.arange(RATE // 2) / RATE)
    heard = to_samples(without_noise(to_pcm(voice + noise)))
    assert len(heard) == 2 * RATE
    assert level_db(heard[: RATE // 3]) < level_db(noise) - 6.0
    spoken = slice(RATE // 2 + 400, RATE - 400)
    assert level_db(heard[spoken]) == pytest.approx(level_db(voice[spoken]), abs=1.0)


@pytest.mark.parametrize("seconds", [0.0, 0.05])
def test_a_very_short_sound_stays_as_it_is(seconds: float) -> None:
    pcm = to_pcm(np.full(int(seconds * RATE), 1000.0))
    assert without_noise(pcm) == pcm
