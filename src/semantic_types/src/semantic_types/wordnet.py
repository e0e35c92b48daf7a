"""Reads the nouns of WordNet 3.0 from its own database files, whose format is described in wndb(5WN).

The files are sorted. They stay on disk and are searched by bisection, so nothing is loaded.
"""

import os
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Iterator, Optional, Tuple

#: Where Debian's package wordnet-base has the database.
FOLDER = Path("/usr/share/wordnet")
INDEX_FILE = "index.noun"
DATA_FILE = "data.noun"
COUNT_FILE = "cntlist.rev"
EXCEPTION_FILE = "noun.exc"
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


class NoWordNet(LookupError):
    """The database is not there."""


@dataclass(frozen=True)
class Sense:
    """One sense of a noun.

    Attributes:
        synset: offset of its synset in the data file
        spelling: the noun as the synset spells it, "Coke", "coffee cup"
        count: how often texts that were tagged with senses use the noun in this sense
    """

    synset: int
    spelling: str
    count: int


@dataclass(frozen=True)
class _Synset:
    words: Tuple[Tuple[str, int], ...]
    lexicographer_file: int
    hypernyms: Tuple[int, ...]


class WordNet:
    """The nouns of WordNet: senses by noun, and hypernyms by synset."""

    def __init__(self, folder: Path = FOLDER) -> None:
        """
        Args:
            folder: the folder with the database files
        Raises:
            NoWordNet: the files cannot be read
        """
        try:
            self._files = {
                name: SortedFile(folder / name) for name in (INDEX_FILE, DATA_FILE, COUNT_FILE, EXCEPTION_FILE)
            }
        except OSError as error:
            reason = f"{folder} has no WordNet database ({error}): install the Debian package wordnet-base"
            raise NoWordNet(reason) from error

    def senses(self, noun: str) -> Tuple[Sense, ...]:
        """Return the senses of a noun, the most frequent one first; none for an unknown noun.

        A plural that is a noun of its own has both senses: "glasses" are spectacles, or several glasses.

        Args:
            noun: singular or plural; upper and lower case mean the same, and words are separated by blanks
        """
        found = []
        for key, line in self._entries(noun):
            fields = line.split()
            found += [self._sense(key, int(offset)) for offset in fields[-int(fields[2]) :]]
        return tuple(sorted(found, key=lambda sense: -sense.count))

    def _entries(self, noun: str) -> Iterator[Tuple[str, str]]:
        """Return the entries of a noun in the index, and of what may be its singular."""
        word = "_".join(noun.lower().split())
        irregular = self._line(EXCEPTION_FILE, word) if word else None
        singulars = irregular.split()[1:] if irregular else []
        regular = [word[: -len(ending)] + base for ending, base in _PLURALS if word.endswith(ending)]
        for key in dict.fromkeys(filter(None, [word, *singulars, *regular])):
            line = self._line(INDEX_FILE, key)
            if line is not None:
                yield key, line

    def hypernyms(self, synset: int) -> Tuple[int, ...]:
        """Return the more general synsets of a synset."""
        return self._synset(synset).hypernyms

    def synset(self, name: str) -> Optional[int]:
        """Return the synset of a name such as "coffee_cup.n.01", the first sense of the noun; None if there is none."""
        noun, kind, number = (name.rsplit(".", 2) + ["", ""])[:3]
        line = self._line(INDEX_FILE, noun) if noun and kind == "n" and number.isdigit() else None
        fields = line.split() if line else []
        offsets = fields[-int(fields[2]) :] if fields else []
        place = int(number) - 1 if offsets else -1
        return int(offsets[place]) if 0 <= place < len(offsets) else None

    def _sense(self, key: str, offset: int) -> Sense:
        synset = self._synset(offset)
        spelling, number = next((word, place) for word, place in synset.words if word.lower() == key)
        line = self._line(COUNT_FILE, f"{key}%1:{synset.lexicographer_file:02d}:{number:02d}::")
        return Sense(offset, spelling.replace("_", " "), int(line.split()[2]) if line else 0)

    def _synset(self, offset: int) -> _Synset:
        fields = self._files[DATA_FILE].line_at(offset).partition(" | ")[0].split()
        count = int(fields[3], 16)
        words = tuple((fields[4 + 2 * place], int(fields[5 + 2 * place], 16)) for place in range(count))
        pointers = fields[5 + 2 * count :]
        hypernyms = tuple(int(target) for kind, target in zip(pointers[0::4], pointers[1::4]) if kind in _HYPERNYMS)
        return _Synset(words, int(fields[1]), hypernyms)

    def _line(self, name: str, key: str) -> Optional[str]:
        return self._files[name].line_of(key)


class SortedFile:
    """A file whose lines are sorted by their bytes; it stays open as long as this object lives.

    Raises:
        OSError: the file cannot be read
    """

    #: Bytes of one read; the lines of an index are shorter.
    _CHUNK = 2048

    def __init__(self, path: Path) -> None:
        self._file = path.open("rb", buffering=0)
        self._size = os.fstat(self._file.fileno()).st_size

    def line_at(self, offset: int) -> str:
        """Return the line that begins at an offset."""
        found = b""
        while b"\n" not in found and offset + len(found) < self._size:
            found += os.pread(self._file.fileno(), self._CHUNK, offset + len(found))
        return found.partition(b"\n")[0].decode("ascii")

    def line_of(self, key: str) -> Optional[str]:
        """Return the line that begins with a key and a blank; None if there is none."""
        wanted = f"{key} "
        first, last = 0, self._size
        while first < last:
            middle = (first + last) // 2
            begin = self._begin_after(middle) if middle > first else first
            line = self.line_at(begin) if begin < last else ""
            if line.startswith(wanted):
                return line
            if line and line < wanted:
                first = begin + len(line) + 1
            elif middle > first:
                last = middle
            else:
                break
        return None

    def _begin_after(self, offset: int) -> int:
        """Return where the first line begins that does not begin before an offset."""
        return offset + len(self.line_at(offset - 1).encode("ascii")) if offset else 0


@lru_cache(maxsize=None)
def shipped_wordnet() -> WordNet:
    """Return the database of the machine.

    Raises:
        NoWordNet: it is not installed
    """
    return WordNet()
