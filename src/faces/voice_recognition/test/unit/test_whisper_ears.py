"""What is made of what Whisper hears, with a Whisper of which it is known what it says."""

from typing import Dict, FrozenSet, Sequence, Tuple

import numpy as np
import pytest

from command_server.stop_words import is_stop
from voice_recognition.agreement import Heard, Verdict
from voice_recognition.command_reading import Meaning, Sense
from voice_recognition.offers import Offer
from voice_recognition.recogniser import RATE
from voice_recognition.sound import to_pcm
from voice_recognition.sound_alike import SoundAlikes
from voice_recognition.spoken_language import spoken_words
from voice_recognition.spotting import CLEAR_DB, clearness_and_length
from voice_recognition.voice_words import voice_words
from voice_recognition.whisper_ears import CRY_BEHIND, WhisperEars
from voice_recognition.whisper_model import Sentence, Transcript

KNOWN = frozenset("go turn left back half a metre to the lab".split())
COMMANDS = {"go back half a metre": "moving", "turn left": "turning"}


class Whisper:
    def __init__(self, heard: Sequence[Tuple[str, float]], scores: Dict[str, float]) -> None:
        self._heard, self._scores = heard, scores

    def hear(self, pcm: bytes, prompt: str = "") -> Transcript:
        return Transcript(tuple(Sentence(text, score, len(text.split())) for text, score in self._heard), 0.1, 1)

    def score(self, sound: int, texts: Sequence[str]) -> Tuple[Sentence, ...]:
        return tuple(Sentence(text, self._scores.get(text, -90.0), len(text.split())) for text in texts)


class Reader:
    known: FrozenSet[str] = KNOWN

    def read(self, text: str) -> Meaning:
        if is_stop(text):
            return Meaning(Sense.STOP)
        words = spoken_words(text)
        frame = COMMANDS.get(" ".join(words))
        unknown = tuple(word for word in words if word not in KNOWN)
        return Meaning(Sense.COMMAND, Offer(frame, (), text), unknown) if frame else Meaning(Sense.NONE, None, unknown)


class Pocketsphinx:
    """Hears the same in every sound."""

    def hear(self, pcm: bytes) -> Heard:
        return Heard(Verdict.LIKELY, (), ("go", "back", "half", "a", "metre"))


def ears(heard: Sequence[Tuple[str, float]], **scores: float) -> WhisperEars:
    said = {text.replace("_", " "): score for text, score in scores.items()}
    return WhisperEars(Pocketsphinx(), Whisper(heard, said), Reader(), SoundAlikes(frozenset(), (), {}), "")


def sound(noise: float) -> bytes:
    """Return half a second of a loud sound with noise around it."""
    samples = np.random.default_rng(1).normal(0.0, noise, 2 * RATE)
    samples[RATE // 2 : RATE] += 8000.0 * np.sin(np.arange(RATE // 2) * 2 * np.pi * 500.0 / RATE)
    return to_pcm(samples)


CLEAR, NOISY = sound(2.0), sound(1000.0)


def test_the_sounds_are_what_they_are_called() -> None:
    assert clearness_and_length(CLEAR)[0] >= CLEAR_DB > clearness_and_length(NOISY)[0]


def test_in_noise_what_the_grammar_hears_is_offered_if_it_sounds_likely() -> None:
    misheard = [("Go back half another.", -6.0)]
    (offer,) = ears(misheard, go_back_half_a_metre=-8.0).hear(NOISY).offers
    assert offer.frame == "moving"
    assert ears(misheard, go_back_half_a_metre=-60.0).hear(NOISY).offers == ()
    # In a quiet room Whisper hears better than the grammar.
    assert ears(misheard, go_back_half_a_metre=-8.0).hear(CLEAR).offers == ()


def test_what_only_the_grammar_hears_is_never_sure() -> None:
    assert ears([("Go back half another.", -6.0)], go_back_half_a_metre=-0.1).hear(NOISY).verdict is Verdict.LIKELY


@pytest.mark.parametrize(("behind", "stop"), [(CRY_BEHIND - 0.5, "Stop."), (CRY_BEHIND + 0.5, None)])
def test_a_stop_that_is_nearly_as_likely_as_what_was_heard_counts(behind: float, stop) -> None:
    assert ears([("Breathe.", -2.0)], freeze=-2.0 - behind).hear_stop(CLEAR) == stop


def test_a_command_and_a_sentence_of_talk_are_no_stop_however_they_sound() -> None:
    assert ears([("Turn left.", -2.0)], freeze=-1.0).hear_stop(CLEAR) == ""
    assert ears([("It is a nice day.", -4.0)], freeze=-1.0).hear_stop(CLEAR) == ""


def test_all_cries_stop_the_robot() -> None:
    assert [words for words in voice_words().cries if not is_stop(" ".join(words))] == []
