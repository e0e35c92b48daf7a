"""Where somebody speaks."""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from synthetic_speech import noise_like_a_room

from voice_recognition.endpointing import Endpointer, EndpointSettings
from voice_recognition.recogniser import RATE
from voice_recognition.sound import speech_level_db, to_pcm, to_samples

DEFAULT = EndpointSettings()


def noise(seconds: float, level: float, seed: int = 1) -> bytes:
    return to_pcm(np.random.default_rng(seed).normal(0.0, level, int(seconds * RATE)))


def voice(seconds: float, level: float, seed: int = 2) -> bytes:
    """Return a loud sound that goes up and down five times a second, as syllables do."""
    times = np.arange(int(seconds * RATE)) / RATE
    samples = np.random.default_rng(seed).normal(0.0, level, len(times))
    return to_pcm(samples * (0.6 + 0.4 * np.sin(2 * np.pi * 5 * times)))


def utterances(pcm: bytes, chunk: int = 1600, settings: EndpointSettings = DEFAULT):
    endpointer = Endpointer(settings)
    found = [one for at in range(0, len(pcm), chunk) for one in endpointer.feed(pcm[at : at + chunk])]
    return (*found, *endpointer.finish())


@pytest.mark.parametrize("level", [0.0, 10.0, 100.0, 500.0])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_one_utterance_is_found_in_any_room(level: float, seed: int) -> None:
    (found,) = utterances(noise(1.5, level, seed) + voice(1.0, 3000.0, seed) + noise(1.0, level, seed + 9))
    assert found.begin_s == pytest.approx(1.5, abs=0.1)
    assert found.end_s == pytest.approx(2.5, abs=0.15)
    assert not found.is_cut


@pytest.mark.parametrize("seed", range(6))
def test_an_utterance_ends_although_the_room_rumbles_on(seed: int) -> None:
    samples = 800.0 * noise_like_a_room(8.0, seed)
    said = to_samples(voice(0.5, 2500.0, seed))
    samples[3 * RATE : 3 * RATE + len(said)] += said
    (found,) = utterances(to_pcm(samples))
    assert found.begin_s == pytest.approx(3.0, abs=0.1)
    assert found.end_s == pytest.approx(3.5, abs=0.15)


def test_hum_is_no_speech() -> None:
    times = np.arange(RATE // 50) / RATE
    hum, tone = (3000.0 * np.sin(2 * np.pi * hz * times) for hz in (50.0, 500.0))
    assert speech_level_db(hum) < speech_level_db(tone) - 20.0
    assert speech_level_db(tone) == pytest.approx(20.0 * np.log10(3000.0 / 32768.0) - 3.0, abs=0.5)


def test_a_pause_is_told_before_the_end_with_the_same_times() -> None:
    endpointer = Endpointer(DEFAULT)
    pcm = noise(1.5, 10.0) + voice(0.5, 3000.0) + noise(0.26, 10.0) + voice(0.5, 3000.0, 5) + noise(1.0, 10.0)
    found, pauses = [], []
    for at in range(0, len(pcm), 640):
        found += endpointer.feed(pcm[at : at + 640])
        pause = endpointer.take_pause()
        pauses += [(pause, len(found))] if pause is not None else []
    (whole,) = found
    inside, last = pauses
    assert inside[0].end_s < last[0].end_s == whole.end_s and inside[0].begin_s == last[0].begin_s == whole.begin_s
    assert whole.pcm.startswith(last[0].pcm) and last[1] == 0
    assert endpointer.take_pause() is None


def test_a_pause_inside_does_not_end_it_and_a_longer_one_does() -> None:
    words = [voice(0.5, 3000.0), voice(0.5, 3000.0, 5)]
    assert len(utterances(noise(1, 20) + words[0] + noise(0.25, 20) + words[1] + noise(1, 20))) == 1
    assert len(utterances(noise(1, 20) + words[0] + noise(0.8, 20) + words[1] + noise(1, 20))) == 2


def test_a_click_is_no_utterance() -> None:
    assert utterances(noise(1, 20) + voice(0.04, 9000.0) + noise(1, 20)) == ()


@pytest.mark.parametrize("level", [0.0, 20.0, 300.0])
def test_nobody_speaks_in_a_minute_of_noise(level: float) -> None:
    assert utterances(noise(60, level)) == ()


def test_the_room_gets_louder_and_is_quiet_again_soon() -> None:
    found = utterances(noise(3, 10) + noise(30, 400, 3))
    assert len(found) <= 2
    assert all(one.end_s < 20 for one in found)


def test_the_parts_of_the_stream_do_not_matter() -> None:
    pcm = noise(1, 20) + voice(1, 3000.0) + noise(1, 20)
    assert utterances(pcm, 1600) == utterances(pcm, 334) == utterances(pcm, len(pcm))


def test_a_long_sound_is_cut_off() -> None:
    found = utterances(noise(1, 20) + voice(5, 3000.0) + noise(1, 20), settings=EndpointSettings(longest_s=2.0))
    assert found[0].is_cut and len(found[0].pcm) <= 2.1 * 2 * RATE


class Voice:
    """A detector that knows a voice in a part of the stream."""

    def __init__(self, begin_s: float, end_s: float) -> None:
        self._begin_s, self._end_s = begin_s, end_s
        self._passed_s = 0.0

    def __call__(self, pcm: bytes) -> float:
        self._passed_s += len(pcm) / 2 / RATE
        return 0.9 if self._begin_s < self._passed_s <= self._end_s else 0.1


def test_noise_that_goes_on_does_not_make_an_utterance_longer() -> None:
    pcm = noise(1.0, 50.0) + voice(1.0, 3000.0) + voice(2.0, 800.0, seed=5) + noise(1.0, 50.0)
    (by_energy,) = utterances(pcm)
    assert by_energy.end_s > 3.5
    endpointer = Endpointer(voice=Voice(1.0, 2.0))
    first, *_ = (*endpointer.feed(pcm), *endpointer.finish())
    assert first.begin_s == pytest.approx(1.0, abs=0.1) and first.end_s == pytest.approx(2.1, abs=0.15)


def test_a_voice_that_the_detector_does_not_know_is_heard() -> None:
    pcm = noise(1.0, 50.0) + voice(1.0, 3000.0) + noise(1.0, 50.0)
    endpointer = Endpointer(voice=Voice(9.0, 9.0))
    assert (*endpointer.feed(pcm), *endpointer.finish()) == utterances(pcm)
