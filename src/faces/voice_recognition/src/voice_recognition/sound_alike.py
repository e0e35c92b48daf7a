"""Finds words that the robot knows and that sound like what was heard: "Bob" like "God", "carry" like "car hit"."""

from functools import lru_cache
from typing import Dict, FrozenSet, Iterable, Iterator, List, Mapping, Sequence, Tuple

from voice_recognition.pronunciation import Dictionary, pronounce
from voice_recognition.spoken_language import Words

Sounds = Tuple[str, ...]

#: Edits of the sounds of a word, divided by their number, up to which another word sounds like it.
MOST_DIFFERENT = 0.45
#: Words that are named for one that was heard, at most.
MOST_ALIKE = 6
#: How much likelier a name is than another word, in the measure of how different they sound.
LIKELIER_NAME = 0.25
#: What it costs to take one sound for another of its kind, and to leave one out or put one in.
_SAME_KIND, _ONE_MORE = 0.5, 0.8
#: Sounds that are taken for one another.
_KINDS = (
    "AA AE AH AO AW AY EH ER EY IH IY OW OY UH UW",
    "B D G P T K V DH",
    "F TH S SH CH HH Z ZH JH",
    "M N NG",
    "L R W Y",
)
_KIND_OF: Mapping[str, int] = {sound: number for number, sounds in enumerate(_KINDS) for sound in sounds.split()}


class SoundAlikes:
    """The words that a robot knows, by their sounds."""

    def __init__(self, words: FrozenSet[str], names: Iterable[str], dictionary: Dictionary) -> None:
        """
        Args:
            words: that the robot knows, in lower case
            names: those of them that are names, as they are written; they are likelier than others that sound alike
            dictionary: sounds of words; espeak-ng says those of other words
        """
        known, _ = pronounce(sorted(words), dictionary)
        self._dictionary = dictionary
        self._names = {name.lower(): name for name in names}
        self._by_length: Dict[int, List[Tuple[str, Sounds]]] = {}
        for word, ways in known.items():
            sounds = tuple(ways[0].split())
            self._by_length.setdefault(len(sounds), []).append((word, sounds))
        self._alike = lru_cache(maxsize=2000)(self._find)

    def words_like(self, words: Words) -> Tuple[Tuple[str, float], ...]:
        """Return the known words that some words together sound like, the likeliest first,
        and how different each is: 0 for the same, less for a name.

        Args:
            words: one, or two that may have been one
        """
        return self._alike(words)

    def written(self, words: Words) -> str:
        """Return a sentence of some words in which names have their capitals: Whisper finds those likelier."""
        return " ".join(self._names.get(word, word) for word in words)

    def _find(self, words: Words) -> Tuple[Tuple[str, float], ...]:
        ways, unknown = pronounce(words, self._dictionary)
        if unknown:
            return ()
        heard = tuple(sound for word in words for sound in ways[word][0].split())
        found: List[Tuple[float, str]] = []
        for length in range(len(heard) - 1, len(heard) + 2):
            for word, sounds in self._by_length.get(length, ()):
                difference = difference_of(heard, sounds)
                if difference <= MOST_DIFFERENT and (word,) != words:
                    found.append((difference - (LIKELIER_NAME if word in self._names else 0.0), word))
        return tuple((word, difference) for difference, word in sorted(found)[:MOST_ALIKE])


def difference_of(one: Sequence[str], other: Sequence[str]) -> float:
    """Return the cost of the edits from some sounds to others, divided by the number of the longer ones."""
    row = [at * _ONE_MORE for at in range(len(other) + 1)]
    for sound in one:
        diagonal, row[0] = row[0], row[0] + _ONE_MORE
        for at, against in enumerate(other, 1):
            diagonal, row[at] = (
                row[at],
                min(row[at] + _ONE_MORE, row[at - 1] + _ONE_MORE, diagonal + _exchange(sound, against)),
            )
    return row[-1] / max(1, len(one), len(other))


def _exchange(one: str, other: str) -> float:
    if one == other:
        return 0.0
    kind = _KIND_OF.get(one)
    return _SAME_KIND if kind is not None and kind == _KIND_OF.get(other) else 1.0


def variants(words: Words, known: FrozenSet[str], alikes: SoundAlikes) -> Iterator[Tuple[float, Words]]:
    """Yield what may have been said where a sentence has words that the robot does not know.

    Args:
        words: of the sentence, in lower case
        known: words that the robot knows
        alikes: finds those that sound like others
    Yields:
        how different it sounds, and its words; one word, or two in a row, are exchanged
    """
    doubtful = [at for at, word in enumerate(words) if word not in known] or range(len(words))
    for at in doubtful:
        for begin, end in ((at, at + 1), (at, at + 2), (at - 1, at + 1)):
            if begin < 0 or end > len(words):
                continue
            for word, difference in alikes.words_like(words[begin:end]):
                yield difference, (*words[:begin], word, *words[end:])
