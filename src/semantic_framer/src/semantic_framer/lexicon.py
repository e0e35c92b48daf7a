"""The lexicon: lexical units by verb, as the files of robot programmers define them."""

import difflib
from collections import defaultdict
from typing import Dict, FrozenSet, Iterable, List, Mapping, Sequence, Set, Tuple

from semantic_frames import load_lexical_units
from semantic_frames.lexical_unit import LexicalUnit


class Lexicon:
    """Lexical units, found by verb in a time that does not depend on how many there are."""

    def __init__(self) -> None:
        self._files: Dict[str, Tuple[str, Tuple[LexicalUnit, ...]]] = {}
        self._by_verb: Dict[str, List[LexicalUnit]] = defaultdict(list)
        self._by_first_word: Dict[str, List[str]] = defaultdict(list)
        self._by_spelling: Dict[str, Set[str]] = defaultdict(set)

    @property
    def files(self) -> Mapping[str, str]:
        """Text of each file by its path."""
        return {path: text for path, (text, _) in self._files.items()}

    @property
    def units(self) -> Tuple[LexicalUnit, ...]:
        """Every unit, in the order of the files."""
        return tuple(unit for _, units in self._files.values() for unit in units)

    @property
    def verbs(self) -> FrozenSet[str]:
        """Every verb, with its particle."""
        return frozenset(self._by_verb)

    def add_file(self, text: str, path: str) -> Tuple[LexicalUnit, ...]:
        """Add the units of a file; those that the file gave before are replaced.

        Raises:
            FileRefused: the file is wrong; what it gave before stays
        """
        units = load_lexical_units(text, path)
        self._replace(path, text, units)
        return units

    @classmethod
    def of_units(cls, units: Iterable[LexicalUnit]) -> "Lexicon":
        """Make a lexicon of units that are there already; it has no files to tell of."""
        lexicon = cls()
        lexicon._index(units)
        return lexicon

    def _replace(self, path: str, text: str, units: Tuple[LexicalUnit, ...]) -> None:
        for old in self._files.get(path, ("", ()))[1]:
            for verb in old.verbs:
                self._by_verb[verb].remove(old)
                if not self._by_verb[verb]:
                    del self._by_verb[verb]
                    self._by_first_word[verb.split()[0]].remove(verb)
        self._files[path] = (text, units)
        self._index(units)

    def _index(self, units: Iterable[LexicalUnit]) -> None:
        for unit in units:
            for verb in dict.fromkeys(unit.verbs):
                if verb not in self._by_verb:
                    first = verb.split()[0]
                    self._by_first_word[first].append(verb)
                    for spelling in _spellings(first):
                        self._by_spelling[spelling].add(first)
                self._by_verb[verb].append(unit)

    def units_of(self, verb: str) -> Tuple[LexicalUnit, ...]:
        """Units of a verb, particle included."""
        return tuple(self._by_verb.get(verb, ()))

    def lists_of(self, verb: str) -> Tuple[Tuple[str, ...], ...]:
        """The words that units of a verb list for an element, one entry for each such element."""
        return tuple(relation.words for unit in self.units_of(verb) for relation in unit.relations if relation.words)

    def verbs_beginning_with(self, word: str) -> Tuple[str, ...]:
        """Verbs whose first word is this one, those of more words first: "pick up" before "pick"."""
        return tuple(sorted(self._by_first_word.get(word, ()), key=lambda verb: (-len(verb.split()), verb)))

    def length_of_verb(self, words: Sequence[str]) -> int:
        """Return of how many words the longest verb is that some words begin with: 3 for "let", "go", "of", "it"."""
        verbs = [verb.split() for verb in self._by_first_word.get(words[0], ())]
        return max((len(verb) for verb in verbs if list(words[: len(verb)]) == verb), default=0)

    def nearest_verbs(self, word: str, count: int = 3) -> Tuple[str, ...]:
        """Verbs that are spelled like a word, the nearest first; none when nothing is near.

        At most one letter is wrong, missing, too many, or in its neighbour's place, so that the time does not grow with
        the lexicon and no word is offered that only looks similar from afar.
        """
        near = {first for spelling in _spellings(word) for first in self._by_spelling.get(spelling, ())}
        firsts = difflib.get_close_matches(word, sorted(near), n=count, cutoff=0.0)
        return tuple(verb for first in firsts for verb in self._by_first_word.get(first, ()))[:count]


def _spellings(word: str) -> FrozenSet[str]:
    """Return a word, and the word without each of its letters."""
    return frozenset([word] + [word[:position] + word[position + 1 :] for position in range(len(word))])
