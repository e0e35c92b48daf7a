"""The English of the voice as data: numbers, answers, words of talk, sounds."""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Dict, FrozenSet, Mapping, Tuple

import yaml

FILE = Path(__file__).with_name("voice.yaml")

Words = Tuple[str, ...]


@dataclass(frozen=True)
class VoiceWords:
    """The content of ``voice.yaml``.

    Attributes:
        polite_before, polite_after: phrases around a command
        greetings: phrases before the name of a robot that is called
        small_numbers: names of 0 to 19
        tens: names of 20, 30 to 90
        hundred: name of 100
        measures: by quantity, the units (name of one, name of several) and their spoken numbers
        before_things: words that begin a filler
        other_person: words that change when the robot repeats what a person says of himself
        answers: phrases by the name of an answer
        stop: phrases that stop the robot, for the searches of pocketsphinx
        cries: phrases that stop the robot, of which Whisper says how likely they were said
        frames_without_motion: frames that move nothing
        other_words: words of talk
        sounds: ARPAbet of espeak-ng's mnemonics
    """

    polite_before: Tuple[Words, ...]
    polite_after: Tuple[Words, ...]
    greetings: Tuple[str, ...]
    small_numbers: Words
    tens: Words
    hundred: str
    measures: Mapping[str, Mapping[Tuple[str, str], Tuple[int, ...]]]
    before_things: FrozenSet[str]
    other_person: Mapping[str, str]
    answers: Mapping[str, Tuple[Words, ...]]
    stop: Tuple[Words, ...]
    cries: Tuple[Words, ...]
    frames_without_motion: FrozenSet[str]
    other_words: Words
    sounds: Mapping[str, Words]


@lru_cache(maxsize=1)
def voice_words() -> VoiceWords:
    """Read ``voice.yaml`` once."""
    data = yaml.safe_load(FILE.read_text(encoding="utf-8"))
    measures: Dict[str, Dict[Tuple[str, str], Tuple[int, ...]]] = {
        quantity: {_unit(name): tuple(map(int, str(numbers).split())) for name, numbers in units.items()}
        for quantity, units in data["measures"].items()
    }
    return VoiceWords(
        polite_before=_phrases(data["polite_before"]),
        polite_after=_phrases(data["polite_after"]),
        greetings=tuple(data["greetings"]),
        small_numbers=tuple(data["small_numbers"].split()),
        tens=tuple(data["tens"].split()),
        hundred=data["hundred"],
        measures=measures,
        before_things=frozenset(data["before_things"]),
        other_person=dict(data["other_person"]),
        answers={name: _phrases(phrases) for name, phrases in data["answers"].items()},
        stop=_phrases(data["stop"]),
        cries=_phrases(data["cries"]),
        frames_without_motion=frozenset(data["frames_without_motion"].split()),
        other_words=tuple(dict.fromkeys(data["other_words"].split())),
        sounds={str(name): tuple(sounds.split()) for name, sounds in data["sounds"].items()},
    )


def _phrases(phrases: Tuple[str, ...]) -> Tuple[Words, ...]:
    return tuple(tuple(phrase.split()) for phrase in phrases)


def _unit(name: str) -> Tuple[str, str]:
    one, _, several = name.partition("/")
    return one.strip(), several.strip()


def words_of_number(number: int) -> Tuple[Words, ...]:
    """Return the ways to say a whole number below 1000, the usual one first."""
    known = voice_words()
    if number < len(known.small_numbers):
        return ((known.small_numbers[number],),)
    if number < 100:
        tens, ones = divmod(number, 10)
        return ((known.tens[tens - 2], *([known.small_numbers[ones]] if ones else [])),)
    hundreds, rest = divmod(number, 100)
    ways: Tuple[Words, ...] = ((known.small_numbers[hundreds], known.hundred),)
    if hundreds == 1:
        ways += (("a", known.hundred),)
    if not rest:
        return ways
    tails = words_of_number(rest)
    joined = tuple(way + tail for way in ways for tail in tails)
    with_and = tuple((*way, "and", *tail) for way in ways for tail in tails)
    return joined + with_and
