"""Whisper in its process: what it hears of synthetic voices, of nobody, and when it is not there."""

import importlib.util
import shutil
import subprocess
import sys
from pathlib import Path
from typing import FrozenSet, Iterator

import numpy as np
import pytest

from command_server.stop_words import is_stop
from offline_pipeline.knowledge import load_knowledge, shipped_domains
from voice_recognition import engines, whisper_model
from voice_recognition.agreement import Verdict
from voice_recognition.command_reading import Meaning, Sense
from voice_recognition.ears import Ears, make_shipped_ears
from voice_recognition.engines import Engine
from voice_recognition.mel_spectrum import mel_spectrum
from voice_recognition.offers import OfferFinder
from voice_recognition.recogniser import model_dictionary
from voice_recognition.sound_alike import SoundAlikes
from voice_recognition.spoken_language import grounded_frames, make_language, spoken_words
from voice_recognition.spotting import StopSpotter
from voice_recognition.stop_hearing import StopHearing
from voice_recognition.voice_words import voice_words
from voice_recognition.whisper_client import NotHeard, WhisperProcess
from voice_recognition.whisper_ears import WhisperEars, prompt_with

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from synthetic_speech import noise_like_a_room, silence, speech, with_noise, with_silence

from voice_recognition.sound import to_pcm, write_wav

IS_INSTALLED = engines.chosen(Engine.AUTO)[0] is Engine.WHISPER
pytestmark = pytest.mark.skipif(
    not importlib.util.find_spec("pocketsphinx") or not shutil.which("flite") or not shutil.which("espeak-ng"),
    reason="pocketsphinx, flite or espeak-ng is not installed",
)
needs_whisper = pytest.mark.skipif(not IS_INSTALLED, reason="Whisper is not installed: make voice")
SLT, RMS, ESPEAK = ("flite", "slt"), ("flite", "rms"), ("espeak-ng", "en-gb")
SERVED = frozenset("following moving turning telling".split())
PERSONS = frozenset({"Alice", "Bob"})


def said(text, voice=SLT) -> bytes:
    return with_silence(speech(text, voice), before_s=0.4, after_s=0.4)


class TemplateReader:
    """Reads by the examples of the units, where no parse of what Whisper writes is recorded."""

    def __init__(self, finder: OfferFinder, known: FrozenSet[str]) -> None:
        self._finder = finder
        self.known = known

    def read(self, text: str) -> Meaning:
        if is_stop(text):
            return Meaning(Sense.STOP)
        words = spoken_words(text)
        unknown = tuple(word for word in words if word not in self.known)
        offer = self._finder.find(words)
        return Meaning(Sense.COMMAND if offer is not None else Sense.NONE, offer, unknown)


@pytest.fixture(scope="module", name="whisper")
def _whisper() -> Iterator[WhisperProcess]:
    process = WhisperProcess()
    process.start()
    assert process.wait_until_ready(), process.problem
    yield process
    process.close()


@pytest.fixture(scope="module", name="by_pocketsphinx")
def _by_pocketsphinx() -> Ears:
    knowledge = load_knowledge([shipped_domains()])
    names = {**dict.fromkeys(PERSONS, ("Human",)), "kitchen": ("Room",), "lab": ("Room",)}
    grounded = grounded_frames(knowledge.frames, SERVED)
    return make_shipped_ears(make_language(knowledge.frames, knowledge.lexicon.units, grounded, names, knowledge.types))


def ears_with(whisper, by_pocketsphinx: Ears) -> WhisperEars:
    names = {name.lower() for name in PERSONS}
    known = frozenset({*by_pocketsphinx.language.vocabulary(), *voice_words().other_words, *names})
    reader = TemplateReader(by_pocketsphinx.finder, known)
    alikes = SoundAlikes(known, PERSONS, model_dictionary())
    return WhisperEars(by_pocketsphinx, whisper, reader, alikes, prompt_with(sorted(PERSONS)))


@pytest.fixture(scope="module", name="ears")
def _ears(whisper: WhisperProcess, by_pocketsphinx: Ears) -> WhisperEars:
    return ears_with(whisper, by_pocketsphinx)


@needs_whisper
@pytest.mark.parametrize("voice", [SLT, RMS])
def test_a_sentence_of_no_unit_is_written_down(whisper: WhisperProcess, voice) -> None:
    transcript = whisper.hear(said("the weather in the mountains was beautiful yesterday", voice))
    assert "the weather in the mountains was beautiful yesterday" in {
        " ".join(spoken_words(one.text)) for one in transcript.sentences
    }
    assert transcript.no_speech < 0.5 and len(transcript.sentences) > 1


@needs_whisper
def test_what_was_said_is_likelier_than_what_was_not(whisper: WhisperProcess) -> None:
    transcript = whisper.hear(said("go to the office"))
    right, wrong = whisper.score(transcript.sound, ["go to the office", "bring me the mug"])
    assert (right.text, wrong.text) == ("go to the office", "bring me the mug")
    assert right.log_probability > wrong.log_probability + 5.0
    assert whisper.score(transcript.sound - 100, ["go to the office"]) == ()


@needs_whisper
@pytest.mark.parametrize("seed", range(3))
def test_nothing_is_written_into_silence_and_noise(ears: WhisperEars, whisper: WhisperProcess, seed: int) -> None:
    noise = to_pcm(2000.0 * noise_like_a_room(3.0, seed))
    for pcm in (silence(3.0, seed=seed), noise, b""):
        assert whisper.hear(pcm).sentences == ()
        assert ears.hear(pcm).verdict is Verdict.NOTHING
        assert ears.hear_answer(pcm).answer == ""
        assert not ears.hear_stop(pcm)


@needs_whisper
@pytest.mark.parametrize(
    ("text", "voice", "frame"),
    [
        ("move forward two metres", SLT, "moving"),
        ("turn left ninety degrees", RMS, "turning"),
        ("follow Bob", RMS, "following"),
        ("follow Alice", ESPEAK, "following"),
    ],
)
def test_commands_are_offered(ears: WhisperEars, text: str, voice, frame: str) -> None:
    heard = ears.hear(said(text, voice))
    assert frame in [offer.frame for offer in heard.offers]
    wanted = ears.finder.find(spoken_words(text))
    assert any(offer.means_the_same(wanted) for offer in heard.offers)


@needs_whisper
def test_talk_is_no_command(ears: WhisperEars) -> None:
    heard = ears.hear(said("what did your family have for dinner yesterday"))
    assert not any(offer.frame for offer in heard.offers) and not heard.is_stop


@needs_whisper
@pytest.mark.parametrize(("text", "answer"), [("yes please", "yes"), ("no", "no"), ("the second one", "second")])
def test_answers_are_heard(ears: WhisperEars, text: str, answer: str) -> None:
    assert ears.hear_answer(said(text)).answer == answer


@needs_whisper
def test_a_command_that_sounds_like_a_stop_is_none(ears: WhisperEars) -> None:
    hearing = StopHearing(StopSpotter(model_dictionary()), ears.hear_stop)
    try:
        for text, voice in (("follow Bob", ESPEAK), ("step back", SLT), ("turn to the left", RMS)):
            assert hearing.stop_in(said(text, voice)) == "", text
        for voice in (SLT, RMS, ESPEAK):
            assert hearing.stop_in(said("stop", voice)) == "Stop."
            assert hearing.stop_in(with_noise(said("please stop", voice), 10.0, seed=1)) == "Stop."
        assert ears.hear_stop(said("stop now")) == "Stop."
        assert ears.hear_stop(said("emergency stop")) == "Emergency stop."
    finally:
        hearing.close()


@needs_whisper
def test_a_process_that_has_died_is_started_anew_and_pocketsphinx_hears_meanwhile(by_pocketsphinx: Ears) -> None:
    process = WhisperProcess()
    try:
        process.start()
        assert process.wait_until_ready()
        process.end_process("killed")
        assert not process.is_ready and process.problem == "killed"
        with pytest.raises(NotHeard):
            process.hear(silence(1.0))
        heard = ears_with(process, by_pocketsphinx).hear(said("turn left ninety degrees"))
        assert [offer.frame for offer in heard.offers] == ["turning"]
        assert process.wait_until_ready()
        assert process.hear(said("go to the office")).sentences
    finally:
        process.close()


@needs_whisper
def test_rfn_voice_shows_what_whisper_hears(tmp_path: Path) -> None:
    path = tmp_path / "said.wav"
    write_wav(str(path), said("go to the kitchen and say hello"))
    # In a process of its own, where the models of the parser answer.
    command = [
        sys.executable,
        "-c",
        "import sys; from roboframenet_tools.cli import main; sys.exit(main(sys.argv[1:]))",
    ]
    done = subprocess.run([*command, "voice", str(path)], stdout=subprocess.PIPE, text=True, timeout=120, check=True)
    assert "heard by Whisper" in done.stdout
    assert "heard        go to the kitchen and say hello" in done.stdout
    assert "asks: Shall I go to the kitchen and say hello?" in done.stdout


def test_a_program_that_is_no_whisper_says_so() -> None:
    process = WhisperProcess([sys.executable, "-c", "import sys; sys.stdin.read()"])
    try:
        process.start()
        with pytest.raises(NotHeard, match="loaded"):
            process.hear(b"")
    finally:
        process.close()
    process = WhisperProcess(["/no/such/program"])
    with pytest.raises(NotHeard, match="/no/such/program"):
        process.hear(b"")


@needs_whisper
def test_another_model_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(whisper_model, "SUMS", {"model.bin": "0" * 64})
    engine, reason = engines.chosen(Engine.WHISPER)
    assert engine is Engine.POCKETSPHINX and "not the file of the model tiny.en" in reason


def test_without_its_packages_pocketsphinx_hears(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(whisper_model, "LIBRARIES", ("no_such_library",))
    engine, reason = engines.chosen(Engine.AUTO)
    assert engine is Engine.POCKETSPHINX and "no_such_library" in reason and "make voice" in reason
    assert engines.chosen(Engine.POCKETSPHINX) == (Engine.POCKETSPHINX, "")


@needs_whisper
def test_the_spectrum_is_that_of_faster_whisper() -> None:
    spec = importlib.util.find_spec("faster_whisper")
    assert spec is not None and spec.submodule_search_locations
    path = Path(next(iter(spec.submodule_search_locations))) / "feature_extractor.py"
    file = importlib.util.spec_from_file_location("feature_extractor", path)
    module = importlib.util.module_from_spec(file)
    file.loader.exec_module(module)
    pcm = said("go to the office")
    samples = np.zeros(15 * 16000, np.float32)
    sound = np.frombuffer(pcm, "<i2").astype(np.float32) / 32768.0
    samples[: len(sound)] = sound
    wanted = module.FeatureExtractor()(samples, padding=0)[:, :1500]
    assert np.allclose(mel_spectrum(pcm, 15.0), wanted, atol=1e-3)
