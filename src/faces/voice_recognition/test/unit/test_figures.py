"""The figures of the voice; ``test/figures.py`` prints the whole table."""

import importlib.util
import shutil
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import figures

from roboframenet_testing.workspace import REPOSITORY
from voice_recognition.ears import Ears
from voice_recognition.recogniser import model_dictionary
from voice_recognition.spotting import StopSpotter

pytestmark = [
    pytest.mark.acceptance,
    pytest.mark.skipif(
        not importlib.util.find_spec("pocketsphinx") or not shutil.which("espeak-ng") or not shutil.which("flite"),
        reason="pocketsphinx, espeak-ng or flite is not installed",
    ),
]


@pytest.fixture(scope="module", name="ears")
def _ears() -> Ears:
    return figures.turtlebot()


@pytest.fixture(scope="module", name="spotter")
def _spotter() -> StopSpotter:
    return StopSpotter(model_dictionary())


def test_clean_sentences_are_right_or_asked_again(ears: Ears, spotter: StopSpotter) -> None:
    count = figures.Count()
    figures.Person(ears, spotter, None, seed=7).talk(figures.drawn(ears, 400, seed=2026), count)
    assert count.share("right") >= 0.75
    assert count.share("asked again", "not heard") <= 0.2
    assert count.share("wrong") <= 0.05
    assert count.wrong_motions == 0


@pytest.mark.parametrize("snr_db", [20.0, 10.0, 5.0])
def test_no_wrong_motion_begins_in_noise(ears: Ears, spotter: StopSpotter, snr_db: float) -> None:
    count = figures.Count()
    figures.Person(ears, spotter, snr_db, seed=7).talk(figures.drawn(ears, 200, seed=2027), count)
    assert count.total == 200 and count.wrong_motions == 0


def test_a_stop_is_heard_in_noise(spotter: StopSpotter) -> None:
    heard, said = figures.stops_heard(spotter, 210, 10.0)
    assert heard >= 0.97 * said


def test_talk_and_silence_move_nothing(ears: Ears, spotter: StopSpotter) -> None:
    folder = REPOSITORY
    *_, talk = figures.false_alarms(ears, spotter, figures.talk(1200.0, folder))
    assert talk["utterances"] > 50 and talk["motions"] == 0 and talk["false stops"] <= 1
    # One of a hundred phrases that stand alone is taken for a stop: an hour of them has 13.
    *_, phrases = figures.false_alarms(ears, spotter, figures.talk(600.0, folder, are_short=True))
    assert phrases["short ones"] > 100 and phrases["motions"] == 0
    assert phrases["false stops"] <= 0.025 * phrases["short ones"]
    *_, quiet = figures.false_alarms(ears, spotter, figures.quiet(1200.0))
    assert quiet["motions"] == quiet["false stops"] == 0
