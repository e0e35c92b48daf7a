"""A stop is heard at once where it sounds like nothing else; otherwise Whisper decides, if it can tell."""

import importlib.util
import shutil
import sys
import threading
from pathlib import Path
from typing import Iterator, Optional

import pytest

from voice_recognition import stop_hearing
from voice_recognition.recogniser import model_dictionary
from voice_recognition.spotting import StopSpotter
from voice_recognition.stop_hearing import OtherOpinion, StopHearing

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from synthetic_speech import speech, with_silence

pytestmark = pytest.mark.skipif(
    not importlib.util.find_spec("pocketsphinx") or not shutil.which("espeak-ng") or not shutil.which("flite"),
    reason="pocketsphinx, espeak-ng or flite is not installed",
)
#: To pocketsphinx it sounds like a stop, but not so much that nothing else was meant. What a spotter heard before
#: counts, so each test has its own.
DOUBTFUL = ("stock up", ("flite", "slt"))


@pytest.fixture(name="spotter")
def _spotter() -> StopSpotter:
    return StopSpotter(model_dictionary())


def heard(spotter: StopSpotter, by_whisper: Optional[OtherOpinion], text: str, voice) -> str:
    hearing = StopHearing(spotter, by_whisper)
    try:
        return hearing.stop_in(with_silence(speech(text, voice), before_s=0.4, after_s=0.4))
    finally:
        hearing.close()


@pytest.fixture(name="nobody_answers")
def _nobody_answers(monkeypatch: pytest.MonkeyPatch) -> Iterator[OtherOpinion]:
    monkeypatch.setattr(stop_hearing, "DECIDES_WITHIN_S", 0.05)
    is_over = threading.Event()

    def wait(_: bytes) -> str:
        is_over.wait(30.0)
        return ""

    yield wait
    is_over.set()


def test_a_certain_stop_needs_no_other_opinion(spotter: StopSpotter) -> None:
    for voice in (("flite", "slt"), ("flite", "rms"), ("espeak-ng", "en-us")):
        assert heard(spotter, lambda _: "", "stop now", voice) == "Stop."


def test_whisper_decides_about_a_doubtful_one(spotter: StopSpotter) -> None:
    assert heard(spotter, None, *DOUBTFUL) == "Stop."
    assert heard(spotter, lambda _: "", *DOUBTFUL) == ""
    assert heard(spotter, lambda _: "Emergency stop.", *DOUBTFUL) == "Emergency stop."


def test_whisper_hears_stops_that_pocketsphinx_does_not(spotter: StopSpotter) -> None:
    assert heard(spotter, None, "the weather is nice", ("flite", "slt")) == ""
    assert heard(spotter, lambda _: "Stop.", "the weather is nice", ("flite", "slt")) == "Stop."


def test_who_cannot_tell_or_does_not_answer_decides_nothing(spotter: StopSpotter, nobody_answers: OtherOpinion) -> None:
    assert heard(spotter, lambda _: None, *DOUBTFUL) == "Stop."
    assert heard(spotter, nobody_answers, *DOUBTFUL) == "Stop."
    assert heard(spotter, lambda _: str(1 // 0), *DOUBTFUL) == "Stop."
    assert heard(spotter, nobody_answers, "the weather is nice", ("flite", "slt")) == ""
