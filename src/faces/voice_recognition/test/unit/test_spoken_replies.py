"""Answers to the questions of the pipeline are heard, and nothing else is heard as one."""

import importlib.util
import shutil
import sys
from pathlib import Path

import pytest

from offline_pipeline.knowledge import load_knowledge, shipped_domains
from voice_recognition.ears import Ears, make_shipped_ears
from voice_recognition.recogniser import model_dictionary
from voice_recognition.replies import ReplyEars, ways_of
from voice_recognition.spoken_language import grounded_frames, make_language

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from synthetic_speech import speech, with_silence

MUGS = ("the red mug", "the blue mug")


def test_ways_of_an_answer() -> None:
    assert ("yes",) in ways_of(("Yes", "No"))["Yes"]
    ways = ways_of(MUGS)
    assert ways["the red mug"] == (("the", "red", "mug"), ("red", "mug"), ("the", "first"), ("the", "first", "one"))
    assert ("second",) not in ways["the blue mug"] and ("the", "second") in ways["the blue mug"]
    assert ("no",) in ways["No"]
    # Nothing is two answers.
    phrases = [phrase for one in ways.values() for phrase in one]
    assert len(phrases) == len(set(phrases))


@pytest.fixture(scope="module", name="commands")
def _commands() -> Ears:
    if not importlib.util.find_spec("pocketsphinx") or not shutil.which("espeak-ng"):
        pytest.skip("pocketsphinx or espeak-ng is not installed")
    knowledge = load_knowledge([shipped_domains()])
    grounded = grounded_frames(knowledge.frames, frozenset(["moving", "turning"]))
    return make_shipped_ears(make_language(knowledge.frames, knowledge.lexicon.units, grounded, {}, knowledge.types))


@pytest.mark.parametrize(
    "answers, text, heard",
    [
        (("Yes", "No"), "yes please", "Yes"),
        (("Yes", "No"), "no thank you", "No"),
        (("Yes", "No"), "the weather is nice today", ""),
        (MUGS, "the blue mug", "the blue mug"),
        (MUGS, "the first one", "the red mug"),
        (MUGS, "no thank you", "No"),
    ],
)
def test_answers_are_heard(commands: Ears, answers, text: str, heard: str) -> None:
    ears = ReplyEars(answers, model_dictionary())
    assert ears.hear(with_silence(speech(text), after_s=0.4), commands).answer == heard


def test_a_command_is_heard_in_the_place_of_an_answer(commands: Ears) -> None:
    heard = ReplyEars(MUGS, model_dictionary()).hear(
        with_silence(speech("move forward three feet"), before_s=0.2, after_s=0.3), commands
    )
    assert not heard.answer and [offer.frame for offer in heard.offers] == ["moving"]
