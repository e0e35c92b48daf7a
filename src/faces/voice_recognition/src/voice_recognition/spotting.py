"""Hears words that stop the robot: in every short utterance, and also while the robot itself speaks."""

import re
from collections import deque
from dataclasses import dataclass
from types import MappingProxyType
from typing import Deque, FrozenSet, Tuple

import numpy as np

from command_server.emergency_words import is_emergency_stop
from command_server.stop_words import is_stop
from voice_recognition.class_ngram import write_ngram
from voice_recognition.denoising import without_noise
from voice_recognition.endpointing import FRAME_S, EndpointSettings
from voice_recognition.pronunciation import Dictionary, pronounce
from voice_recognition.recogniser import RATE, Hypothesis, PocketSphinx
from voice_recognition.sound import speech_level_db, to_samples
from voice_recognition.spoken_language import Words
from voice_recognition.voice_words import voice_words
from word_classes import word_class

#: Seconds of the longest utterance that can be nothing but a stop: "Stop! Stop! Stop! Stop!", slowly.
LONGEST_S = 4.0
#: Share of the words of talk in the search, in noise and in a quiet room, where a stop is heard clearly or was none.
OTHER_SHARE, CLEAR_OTHER_SHARE = 0.02, 0.8
#: Speech that is so many decibels above the noise is clear.
CLEAR_DB = 30.0
#: Seconds that a stop takes at most: with no word, and more for each word.
SLOWEST_S, SLOWEST_WORD_S = 0.6, 0.4
#: Words of a stop at most, with one that is misheard.
MOST_WORDS = 3
#: A cry is a word that stops, so often or more, with pauses; seconds that each word of it takes at most.
LEAST_CRIES, SLOWEST_CRY_S = 3, 0.9
#: Seconds around an utterance in noise that are left away when it is heard again.
BEFORE_S, BEHIND_S = 0.25, 0.1
#: While the robot speaks, so many seconds of the stream are looked at, each time that so many have passed.
WINDOW_S, PERIOD_S = 1.5, 0.5
#: A clear stop has to be heard among all words of the dictionary with so many sounds, too: two or three of them sound
#: like nearly anything that is said, where the words of talk are too few to have one that does.
FEWEST_SOUNDS, MOST_SOUNDS = 2, 3
#: Share of the words of talk and of these in that search.
ANY_OTHER_SHARE = 0.9
#: A clear stop with such a score for each frame of it was never anything else in the recordings that this was set by:
#: stops had -15 to -34 there, "follow Bob" and the like that were taken for one had -42 and less.
CERTAIN_PER_FRAME = -36.0
_SEARCH, _CLEAR_SEARCH, _ANY_WORD_SEARCH = "stop", "clear_stop", "any_word"
#: Share of the frames of an utterance that are taken for the noise around it, and for its loudest part, percent.
_QUIET_SHARE, _LOUD_SHARE = 15, 95
#: Each utterance has its own mean of the spectrum, whatever was heard before it.
_SETTINGS = MappingProxyType({"cmn": "batch"})
_NEGATIONS = word_class("negations")
#: Makes the emergency stop of a stop.
_EMERGENCY = "emergency"
#: What the robot is told.
STOP_TEXT, EMERGENCY_TEXT = "Stop.", "Emergency stop."


@dataclass(frozen=True)
class FoundStop:
    """A stop that the searches found.

    Attributes:
        text: what the robot is told; empty for none
        is_certain: whether it sounds like a stop so much that nothing else was meant
    """

    text: str = ""
    is_certain: bool = False


class StopSpotter:
    """Searches for the phrases ``stop`` of ``voice.yaml`` among words of talk.

    The keyphrase search of pocketsphinx is not used: of short words it finds too few in noise, and too many in talk.
    """

    def __init__(self, known: Dictionary) -> None:
        """
        Args:
            known: sounds of words
        Raises:
            NoRecogniser: it is not installed
        """
        words = voice_words()
        dictionary, unknown = pronounce([*words.other_words, *(word for way in words.stop for word in way)], known)
        short = short_words(known, unlike=frozenset(dictionary))
        searches = (
            (_SEARCH, words.other_words, OTHER_SHARE),
            (_CLEAR_SEARCH, words.other_words, CLEAR_OTHER_SHARE),
            (_ANY_WORD_SEARCH, (*words.other_words, *short), ANY_OTHER_SHARE),
        )
        ngrams = {
            name: write_ngram(None, others, phrases=words.stop, without=unknown, other_share=share)
            for name, others, share in searches
        }
        self._recogniser = PocketSphinx({**dictionary, **short}, ngrams=ngrams, settings=_SETTINGS)
        self._stream: Deque[bytes] = deque()
        self._since_look = 0

    def stop_in(self, pcm: bytes) -> str:
        """Return the stop that an utterance is; empty for none. It is none with more than ``LONGEST_S`` of speech."""
        return self.find_stop(pcm).text

    def find_stop(self, pcm: bytes) -> FoundStop:
        """Return the stop that an utterance is, and whether it sounds like nothing else."""
        clearness_db, spoken_s = clearness_and_length(pcm)
        if spoken_s > LONGEST_S:
            return FoundStop()
        if spoken_s > SLOWEST_S + SLOWEST_WORD_S * MOST_WORDS:
            # In the search for noise, stops are so likely that some seconds of talk may be nothing else.
            words = self._recogniser.hear(_CLEAR_SEARCH, without_noise(pcm)).words
            return FoundStop(stop_text(words), is_certain=True) if is_repeated_stop(words, spoken_s) else FoundStop()
        if clearness_db >= CLEAR_DB:
            found = Hypothesis(())
            for search in (_CLEAR_SEARCH, _ANY_WORD_SEARCH):
                found = self._heard(search, pcm, spoken_s)
                if not is_clear_stop(found.words):
                    return FoundStop()
            return FoundStop(stop_text(found.words), found.score >= CERTAIN_PER_FRAME * max(1, found.frames))
        # What is before and behind a word in noise is sometimes heard as a part of it.
        closer = pcm[_bytes(BEFORE_S) : len(pcm) - _bytes(BEHIND_S)]
        for part in filter(None, (pcm, closer)):
            words = self._heard(_SEARCH, part, spoken_s).words
            if is_heard_stop(words):
                return FoundStop(stop_text(words))
        return FoundStop()

    def _heard(self, search: str, pcm: bytes, spoken_s: float) -> Hypothesis:
        """Return what a search hears; nothing if there are too many words for a stop, or too few for their time."""
        found = self._recogniser.hear(search, without_noise(pcm))
        count = len(found.words)
        is_likely = count <= MOST_WORDS and spoken_s <= SLOWEST_S + SLOWEST_WORD_S * count
        return found if is_likely else Hypothesis(())

    def stop_in_stream(self, part: bytes) -> str:
        """Take the next part of the stream while the robot speaks; return the stop that its last seconds are."""
        self._stream.append(part)
        self._since_look += len(part)
        while sum(map(len, self._stream)) > WINDOW_S * RATE * 2:
            self._stream.popleft()
        if self._since_look < PERIOD_S * RATE * 2:
            return ""
        self._since_look = 0
        return self.stop_in(b"".join(self._stream))

    def forget_stream(self) -> None:
        """Forget the stream: the robot is silent."""
        self._stream.clear()


def _bytes(seconds: float) -> int:
    return int(seconds * RATE) * 2


def clearness_and_length(pcm: bytes) -> Tuple[float, float]:
    """Return how far speech stands out of the noise, decibels, and how long it is, seconds.

    Args:
        pcm: an utterance with some of the quiet around it
    """
    step = int(RATE * FRAME_S)
    samples = to_samples(pcm)
    levels = np.array([speech_level_db(samples[at : at + step]) for at in range(0, len(samples) - step + 1, step)])
    if not len(levels):
        return 0.0, 0.0
    noise_db, voice_db = np.percentile(levels, [_QUIET_SHARE, _LOUD_SHARE])
    settings = EndpointSettings()
    (loud,) = np.nonzero(levels > max(noise_db + settings.begin_db, settings.quietest_db))
    length_s = (loud[-1] - loud[0] + 1) * FRAME_S if len(loud) else 0.0
    return float(voice_db - noise_db), float(length_s)


def stop_text(words: Words) -> str:
    """Return what the robot is told for words that stop it: the emergency stop when they name it.

    Args:
        words: what was heard
    """
    return EMERGENCY_TEXT if is_emergency_stop(" ".join(words)) else STOP_TEXT


def is_repeated_stop(words: Words, spoken_s: float) -> bool:
    """Whether words are nothing but a stop, again and again: "Stop! Stop! Stop!".

    Args:
        words: what was heard
        spoken_s: how long it took, seconds
    """
    is_quick = spoken_s <= SLOWEST_CRY_S * len(words)
    cries = [word for word in words if word != _EMERGENCY]
    return len(words) >= LEAST_CRIES and is_quick and bool(cries) and all(map(is_stop, cries))


def short_words(known: Dictionary, *, unlike: FrozenSet[str]) -> Dictionary:
    """Return the short words of a dictionary that sound like none of some words.

    Args:
        known: sounds of words
        unlike: words of the dictionary
    """
    taken = frozenset(way for word in unlike for way in known.get(word, ()))
    return {
        word: ways
        for word, ways in known.items()
        if FEWEST_SOUNDS <= min(len(way.split()) for way in ways) <= MOST_SOUNDS
        and word.isalpha()
        and word not in unlike
        and not taken.intersection(ways)
    }


def is_clear_stop(words: Words) -> bool:
    """Whether words that were heard clearly stop the robot.

    Words of talk are searched for, so that something else than a stop can be heard: "don't" and "end it" are such
    words, though they stop the robot when they are written.
    """
    said = voice_words().stop
    return is_stop(" ".join(words)) and any(word in way and is_stop(word) for way in said for word in words)


def is_heard_stop(words: Words) -> bool:
    """Whether words that were heard stop the robot.

    In noise, the other one of two words is misheard: "lead halt" was "please halt".
    """
    if is_stop(" ".join(words)):
        return True
    return len(words) == 2 and any(map(is_stop, words)) and not _NEGATIONS.intersection(words)


def says_stop(text: str) -> bool:
    """Whether a text has a word that stops the robot: what the robot itself says must not stop it."""
    said = frozenset(re.findall(r"[a-z']+", text.lower()))
    return any(is_stop(word) for word in said)
