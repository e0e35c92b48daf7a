"""Synthetic voices are heard by pocketsphinx, with the grammar of a small robot."""

import importlib.util
import shutil
import sys
from pathlib import Path
from typing import Tuple

import pytest

from offline_pipeline.knowledge import load_knowledge, shipped_domains
from voice_recognition import voice_command
from voice_recognition.agreement import Verdict
from voice_recognition.ears import Ears, make_shipped_ears
from voice_recognition.sound import write_wav
from voice_recognition.spoken_language import grounded_frames, make_language

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from synthetic_speech import VOICES, silence, speech, with_silence

pytestmark = pytest.mark.skipif(
    not importlib.util.find_spec("pocketsphinx") or not shutil.which("espeak-ng"),
    reason="pocketsphinx or espeak-ng is not installed",
)
SERVED = frozenset("pinging stopping waiting following moving turning saying telling speaking".split())


@pytest.fixture(scope="module", name="ears")
def _ears() -> Ears:
    knowledge = load_knowledge([shipped_domains()])
    grounded = grounded_frames(knowledge.frames, SERVED)
    return make_shipped_ears(make_language(knowledge.frames, knowledge.lexicon.units, grounded, {}, knowledge.types))


def said(text: str, voice: Tuple[str, str] = VOICES[0]) -> bytes:
    return with_silence(speech(text, voice), before_s=0.2, after_s=0.3)


@pytest.mark.parametrize(
    "text, frame, elements",
    [
        ("turn left one hundred and twenty degrees", "turning", {"direction": "left", "angle": "120"}),
        ("move forward three feet", "moving", {"direction": "forward", "distance": "3"}),
        ("tell me the time", "telling", {"message": "the time"}),
    ],
)
def test_commands_are_heard(ears: Ears, text: str, frame: str, elements) -> None:
    heard = ears.hear(said(text))
    assert [offer.frame for offer in heard.offers] == [frame]
    assert elements.items() <= dict(heard.offers[0].elements).items()


@pytest.mark.parametrize("text", ["the weather is lovely today", "what did your family have for dinner yesterday"])
def test_talk_is_no_command(ears: Ears, text: str) -> None:
    heard = ears.hear(said(text))
    assert heard.verdict in (Verdict.NOTHING, Verdict.AGAIN)
    assert not heard.offers and not heard.is_stop


@pytest.mark.parametrize("text, answer", [("yes please", "yes"), ("no", "no"), ("the second one", "second")])
def test_answers_are_heard(ears: Ears, text: str, answer: str) -> None:
    assert ears.hear_answer(said(text)).answer == answer


def test_silence_is_nothing(ears: Ears) -> None:
    assert ears.hear(silence(2.0)).verdict in (Verdict.NOTHING, Verdict.AGAIN)
    assert voice_command.utterances_of(silence(5.0)) == ()


def test_rfn_voice_says_what_is_heard_and_why(tmp_path, capsys) -> None:
    from roboframenet_tools.cli import main

    path = str(tmp_path / "said.wav")
    write_wav(path, with_silence(speech("move forward three feet")))
    assert main(["voice", path, "--frames", "moving,turning", "--engine", "pocketsphinx"]) == 0
    printed = capsys.readouterr().out
    assert "verdict      sure" in printed
    assert "Shall I move forward 3 feet?" in printed
    write_wav(path, silence(2.0))
    assert main(["voice", path, "--frames", "moving", "--engine", "pocketsphinx"]) == 1
    assert "nobody speaks" in capsys.readouterr().out
    assert main(["voice", str(tmp_path / "missing.wav")]) == 2
    assert main(["voice", path, "--frames", "flying"]) == 2
