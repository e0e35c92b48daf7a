"""Reads the nouns or verbs of WordNet 3.0 from its own database files, whose format is described in wndb(5WN).

The files are sorted. They are mapped into memory and searched by bisection, so only the pages that are read are loaded.
"""

import mmap
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import FrozenSet, Iterator, List, Optional, Tuple, Union

#: Where Debian's package wordnet-base has the database.
FOLDER = Path("/usr/share/wordnet")
COUNT_FILE = "cntlist.rev"
NOUN, VERB = "noun", "verb"
#: Their numbers in the keys of senses.
_NUMBERS = {NOUN: 1, VERB: 2}
#: Endings of regular plurals with what stands in their place in the singular, as in WordNet's morphy(7WN).
_PLURALS = (
    ("ies", "y"),
    ("men", "man"),
    ("shes", "sh"),
    ("ches", "ch"),
    ("xes", "x"),
    ("zes", "z"),
    ("ses", "s"),
    ("s", ""),
)
#: Pointers to the more general synset: of a class, and of an instance ("Paris" is a city).
_HYPERNYMS = frozenset(["@", "@i"])
#: Pointers to the more special synset: "veer" is a way to turn.
_HYPONYMS = frozenset(["~", "~i"])
#: Pointers to a synset of verbs with nearly the same meaning.
_ALIKE = frozenset(["$"])
#: Pointers to the opposite: "raise" and "lower".
_OPPOSITES = frozenset(["!"])


class NoWordNet(LookupError):
    """The database is not there."""


@dataclass(frozen=True)
class Sense:
    """One sense of a word.

    Attributes:
        synset: offset of its synset in the data file
        spelling: the word as the synset spells it, "Coke", "coffee cup"
        count: how often texts that were tagged with senses use the word in this sense
    """

    synset: int
    spelling: str
    count: int


@dataclass(frozen=True)
class _Synset:
    words: Tuple[Tuple[str, int], ...]
    lexicographer_file: int
    pointers: Tuple[Tuple[str, int], ...]


class WordNet:
    """The nouns or the verbs of WordNet: senses by word, and relations between synsets."""

    def __init__(self, folder: Path = FOLDER, part: str = NOUN) -> None:
        """
        Args:
            folder: the folder with the database files
            part: ``NOUN`` or ``VERB``
        Raises:
            NoWordNet: the files cannot be read
        """
        self._part = part
        self._index, self._data, self._exceptions = f"index.{part}", f"data.{part}", f"{part}.exc"
        try:
            self._files = {
                name: SortedFile(folder / name) for name in (self._index, self._data, COUNT_FILE, self._exceptions)
            }
        except OSError as error:
            reason = f"{folder} has no WordNet database ({error}): install the Debian package wordnet-base"
            raise NoWordNet(reason) from error

    def senses(self, word: str) -> Tuple[Sense, ...]:
        """Return the senses of a word, the most frequent one first; none for an unknown word.

        A plural that is a noun of its own has both senses: "glasses" are spectacles, or several glasses.

        Args:
            word: a noun, singular or plural, or the base form of a verb; upper and lower case mean the same, and words
                are separated by blanks
        """
        found = []
        for key, line in self._entries(word):
            fields = line.split()
            found += [self._sense(key, int(offset)) for offset in fields[-int(fields[2]) :]]
        return tuple(sorted(found, key=lambda sense: -sense.count))

    def _entries(self, said: str) -> Iterator[Tuple[str, str]]:
        """Return the entries of a word in the index, and of what may be its singular."""
        word = "_".join(said.lower().split())
        bases: List[str] = []
        if word and self._part == NOUN:
            irregular = self._line(self._exceptions, word)
            bases += irregular.split()[1:] if irregular else []
            bases += [word[: -len(ending)] + base for ending, base in _PLURALS if word.endswith(ending)]
        for key in dict.fromkeys(filter(None, [word, *bases])):
            line = self._line(self._index, key)
            if line is not None:
                yield key, line

    def words(self, synset: int) -> Tuple[str, ...]:
        """Return the words of a synset, as it spells them."""
        return tuple(word.replace("_", " ") for word, _ in self._synset(synset).words)

    def hypernyms(self, synset: int) -> Tuple[int, ...]:
        """Return the more general synsets of a synset."""
        return self._pointed(synset, _HYPERNYMS)

    def hyponyms(self, synset: int) -> Tuple[int, ...]:
        """Return the more special synsets of a synset."""
        return self._pointed(synset, _HYPONYMS)

    def alike(self, synset: int) -> Tuple[int, ...]:
        """Return the synsets of verbs with nearly the same meaning."""
        return self._pointed(synset, _ALIKE)

    def opposites(self, synset: int) -> Tuple[int, ...]:
        """Return the synsets with an opposite of a word of a synset."""
        return self._pointed(synset, _OPPOSITES)

    def gloss(self, synset: int) -> str:
        """Return what a synset means, without its examples."""
        return self._files[self._data].line_at(synset).partition(" | ")[2].partition('; "')[0].strip()

    def _pointed(self, synset: int, kinds: FrozenSet[str]) -> Tuple[int, ...]:
        return tuple(target for kind, target in self._synset(synset).pointers if kind in kinds)

    def synset(self, name: str) -> Optional[int]:
        """Return the synset of a name such as "coffee_cup.n.01", the first sense of the word; None if there is none."""
        noun, kind, number = (name.rsplit(".", 2) + ["", ""])[:3]
        line = self._line(self._index, noun) if noun and kind == self._part[0] and number.isdigit() else None
        fields = line.split() if line else []
        offsets = fields[-int(fields[2]) :] if fields else []
        place = int(number) - 1 if offsets else -1
        return int(offsets[place]) if 0 <= place < len(offsets) else None

    def _sense(self, key: str, offset: int) -> Sense:
        synset = self._synset(offset)
        spelling, number = next((word, place) for word, place in synset.words if word.lower() == key)
        line = self._line(COUNT_FILE, f"{key}%{_NUMBERS[self._part]}:{synset.lexicographer_file:02d}:{number:02d}::")
        return Sense(offset, spelling.replace("_", " "), int(line.split()[2]) if line else 0)

    def _synset(self, offset: int) -> _Synset:
        fields = self._files[self._data].line_at(offset).partition(" | ")[0].split()
        count = int(fields[3], 16)
        words = tuple((fields[4 + 2 * place], int(fields[5 + 2 * place], 16)) for place in range(count))
        first = 5 + 2 * count
        last = first + 4 * int(fields[first - 1])
        pointers = tuple((fields[place], int(fields[place + 1])) for place in range(first, last, 4))
        return _Synset(words, int(fields[1]), pointers)

    def _line(self, name: str, key: str) -> Optional[str]:
        return self._files[name].line_of(key)


class SortedFile:
    """A file whose lines are sorted by their bytes; it stays mapped as long as this object lives.

    Raises:
        OSError: the file cannot be read
    """

    def __init__(self, path: Path) -> None:
        with path.open("rb") as file:
            # An empty file cannot be mapped.
            is_empty = not file.read(1)
            self._text: Union[bytes, mmap.mmap] = (
                b"" if is_empty else mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
            )

    def line_at(self, offset: int) -> str:
        """Return the line that begins at an offset."""
        return self._text[offset : self._end_of(offset)].decode("ascii")

    def line_of(self, key: str) -> Optional[str]:
        """Return the line that begins with a key and a blank; None if there is none."""
        wanted = f"{key} ".encode()
        first, last = 0, len(self._text)
        # The line begins at first or later, and before last.
        while first < last:
            begin = self._text.rfind(b"\n", first, (first + last) // 2) + 1 or first
            end = self._end_of(begin)
            found = self._text[begin : min(end, begin + len(wanted))]
            if found == wanted:
                return self._text[begin:end].decode("ascii")
            if found < wanted:
                first = end + 1
            else:
                last = begin
        return None

    def _end_of(self, offset: int) -> int:
        end = self._text.find(b"\n", offset)
        return end if end >= 0 else len(self._text)


@lru_cache(maxsize=None)
def shipped_wordnet(part: str = NOUN) -> WordNet:
    """Return the nouns or the verbs of the machine's database.

    Args:
        part: ``NOUN`` or ``VERB``
    Raises:
        NoWordNet: it is not installed
    """
    return WordNet(part=part)
