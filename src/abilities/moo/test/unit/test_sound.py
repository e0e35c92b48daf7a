"""The sound of a cow."""

import wave

import pytest

from moo.sound import SAMPLE_RATE_HZ, moo, write_wave


def test_moo_is_as_loud_as_asked_and_ends_softly() -> None:
    samples = moo(0.5, loudness=0.4)
    assert max(abs(sample) for sample in samples) == pytest.approx(0.4)
    assert abs(samples[0]) < 0.01 and abs(samples[-1]) < 0.01


@pytest.mark.parametrize(
    "duration_s, loudness", [(0.0, 0.5), (-1.0, 0.5), (11.0, 0.5), (1.0, 1.1), (float("nan"), 0.5)]
)
def test_moo_refuses_what_is_out_of_range(duration_s: float, loudness: float) -> None:
    with pytest.raises(ValueError):
        moo(duration_s, loudness=loudness)


def test_written_file_is_as_long_as_the_sound(tmp_path) -> None:
    write_wave(moo(0.5), str(tmp_path / "moo.wav"))
    with wave.open(str(tmp_path / "moo.wav")) as file:
        assert file.getnframes() == SAMPLE_RATE_HZ // 2
