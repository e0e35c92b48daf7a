"""Words that stop the robot are heard in noise, and not in talk."""

import importlib.util
import itertools
import shutil
import sys
from pathlib import Path
from typing import Any, List, Optional, Sequence, Tuple

import pytest

from voice_recognition.endpointing import Endpointer
from voice_recognition.recogniser import model_dictionary
from voice_recognition.spotting import (
    CLEAR_DB,
    EMERGENCY_TEXT,
    LONGEST_S,
    STOP_TEXT,
    StopSpotter,
    clearness_and_length,
    is_clear_stop,
    is_heard_stop,
    is_repeated_stop,
    says_stop,
    short_words,
)

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from synthetic_speech import VOICES, silence, speech, with_noise, with_silence

pytestmark = pytest.mark.skipif(
    not importlib.util.find_spec("pocketsphinx") or not shutil.which("espeak-ng"),
    reason="pocketsphinx or espeak-ng is not installed",
)


def each_once(*choices: Sequence[object]) -> List[Any]:
    """Return all combinations: some that have each choice are of the tier "test", the others of "acceptance"."""
    longest = max(map(len, choices))
    chosen = {tuple(choice[place % len(choice)] for choice in choices) for place in range(longest)}
    return [
        pytest.param(*one, marks=() if one in chosen else pytest.mark.acceptance) for one in itertools.product(*choices)
    ]


@pytest.fixture(scope="module", name="spotter")
def _spotter() -> StopSpotter:
    return StopSpotter(model_dictionary())


@pytest.mark.parametrize("text, voice", each_once(["stop", "stop now", "please stop", "halt"], VOICES[:3]))
def test_a_stop_is_heard_in_noise(spotter: StopSpotter, text: str, voice: Tuple[str, str]) -> None:
    pcm = with_noise(with_silence(speech(text, voice), before_s=0.8), 10.0, seed=1)
    endpointer = Endpointer()
    found = endpointer.feed(pcm) + endpointer.finish()
    assert any(spotter.stop_in(one.pcm) for one in found)


@pytest.mark.parametrize(
    "said, snr_db, voice",
    each_once(
        [("emergency stop", EMERGENCY_TEXT), ("emergency stop, emergency stop", EMERGENCY_TEXT), ("stop", STOP_TEXT)],
        [None, 10.0],
        VOICES[:3],
    ),
)
def test_an_emergency_stop_is_told_from_a_stop(
    spotter: StopSpotter, said: Tuple[str, str], snr_db: Optional[float], voice: Tuple[str, str]
) -> None:
    text, told = said
    pcm = with_silence(speech(text, voice), before_s=0.8, after_s=0.6)
    endpointer = Endpointer()
    found = endpointer.feed(pcm if snr_db is None else with_noise(pcm, snr_db, seed=1)) + endpointer.finish()
    assert {spotter.stop_in(one.pcm) for one in found} - {""} == {told}


@pytest.mark.parametrize("text", ["stop", "robot stop"])
def test_speech_is_clear_in_a_quiet_room_and_its_length_is_that_of_the_words(text: str) -> None:
    said = with_silence(speech(text), before_s=0.5, after_s=0.4)
    clear_db, length_s = clearness_and_length(said)
    noisy_db, noisy_length_s = clearness_and_length(with_noise(said, 10.0, seed=1))
    assert clear_db > CLEAR_DB > noisy_db > 5.0
    assert 0.2 < noisy_length_s <= length_s < 1.2
    assert clearness_and_length(b"") == (0.0, 0.0)


def test_what_lasts_longer_than_its_words_is_no_stop(spotter: StopSpotter) -> None:
    said = speech("stop")
    assert spotter.stop_in(with_silence(said, before_s=0.5, after_s=0.4))
    assert not spotter.stop_in(silence(0.5) + said + silence(0.9) + said + silence(0.9) + said + silence(0.4))


@pytest.mark.parametrize("voice, snr_db", each_once(VOICES[:3], [None, 10.0]))
def test_a_cry_is_a_stop_though_it_is_long(
    spotter: StopSpotter, voice: Tuple[str, str], snr_db: Optional[float]
) -> None:
    pcm = with_silence(speech("Stop! Stop! Stop! Stop!", voice), before_s=0.8)
    found = []
    endpointer = Endpointer()
    for one in endpointer.feed(pcm if snr_db is None else with_noise(pcm, snr_db, seed=1)) + endpointer.finish():
        found.append(one.end_s - one.begin_s <= LONGEST_S and spotter.stop_in(one.pcm))
    assert any(found)


@pytest.mark.parametrize(
    "words, spoken_s, is_one",
    [
        ("stop stop stop", 2.4, True),
        ("halt stop stop", 2.4, True),
        ("stop stop stop", 3.0, False),  # too long for its words
        ("stop stop", 1.7, False),
        ("stop the stop", 2.0, False),
        ("emergency stop emergency stop", 2.6, True),
        ("emergency emergency emergency", 2.6, False),
    ],
)
def test_a_cry_is_nothing_but_a_word_that_stops(words: str, spoken_s: float, is_one: bool) -> None:
    assert is_repeated_stop(tuple(words.split()), spoken_s) is is_one


@pytest.mark.parametrize(
    "text",
    [
        *("good morning", "what a lovely day", "turn left", "the kitchen", "yes please", "no", "a report"),
        *("sorry", "count"),  # the words of talk have none that sounds like these
    ],
)
def test_other_words_are_no_stop(spotter: StopSpotter, text: str) -> None:
    assert not spotter.stop_in(with_silence(speech(text), before_s=0.5, after_s=0.4))


@pytest.mark.parametrize(
    "words, stops",
    [("stop", True), ("stop it", True), ("halt", True), ("don't", False), ("end it", False), ("don't stop", False)],
)
def test_words_of_talk_are_no_stop_when_they_are_heard(words: str, stops: bool) -> None:
    assert is_clear_stop(tuple(words.split())) is stops


def test_short_words_sound_like_none_of_the_words_of_talk() -> None:
    known = {"stop": ("S T AA P",), "stopp": ("S T AA P",), "top": ("T AA P",), "tapp": ("T AE P",), "by": ("B AY",)}
    known.update({"bye": ("B AY",), "a": ("AH",), "e.g.": ("IY JH",)})
    assert set(short_words(known, unlike=frozenset(["stop", "by"]))) == {"top", "tapp"}


@pytest.mark.parametrize(
    "words, stops",
    [("stop", True), ("lead halt", True), ("stop maybe", True), ("don't stop", False), ("now", False), ("", False)],
)
def test_a_stop_is_heard_beside_one_word_that_is_misheard(words: str, stops: bool) -> None:
    assert is_heard_stop(tuple(words.split())) is stops


def test_a_stop_is_heard_in_the_stream(spotter: StopSpotter) -> None:
    pcm = silence(1.0) + speech("stop") + silence(1.5)
    found = [spotter.stop_in_stream(pcm[at : at + 3200]) for at in range(0, len(pcm), 3200)]
    assert any(found)
    spotter.forget_stream()
    quiet = silence(3.0)
    assert not any(spotter.stop_in_stream(quiet[at : at + 3200]) for at in range(0, len(quiet), 3200))


@pytest.mark.parametrize("text, stops", [("I have stopped.", False), ("I stop now.", True), ("Shall I turn?", False)])
def test_what_the_robot_says_must_not_stop_it(text: str, stops: bool) -> None:
    assert says_stop(text) is stops
