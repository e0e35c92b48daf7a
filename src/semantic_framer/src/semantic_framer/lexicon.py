"""The lexicon: lexical units by verb, as robot programmers define them in files."""

import difflib
from collections import defaultdict
from typing import Dict, FrozenSet, Iterable, List, Mapping, Sequence, Set, Tuple

from semantic_frames import load_lexical_units
from semantic_frames.lexical_unit import LexicalUnit


class Lexicon:
    """Lexical units by verb; the time to find them does not depend on the size of the lexicon."""

    def __init__(self) -> None:
        self._files: Dict[str, Tuple[str, Tuple[LexicalUnit, ...]]] = {}
        self._by_verb: Dict[str, List[LexicalUnit]] = defaultdict(list)
        self._by_first_word: Dict[str, List[str]] = defaultdict(list)
        self._questions: Dict[str, List[LexicalUnit]] = defaultdict(list)
        self._remarks: Dict[str, List[LexicalUnit]] = defaultdict(list)
        self._conditions: Dict[str, List[LexicalUnit]] = defaultdict(list)
        self._by_spelling: Dict[str, Set[str]] = defaultdict(set)

    @property
    def files(self) -> Mapping[str, str]:
        """The text of each file by its path."""
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
        """Add the units of a file; they replace the earlier units of that file.

        Raises:
            FileRefused: the file is wrong; its earlier units stay
        """
        units = load_lexical_units(text, path)
        self.replace_file(path, text, units)
        return units

    @classmethod
    def of_units(cls, units: Iterable[LexicalUnit]) -> "Lexicon":
        """Make a lexicon of existing units; it has no files."""
        lexicon = cls()
        lexicon._index(units)
        return lexicon

    def replace_file(self, path: str, text: str, units: Tuple[LexicalUnit, ...]) -> None:
        """Put units that were read from a file in the place of the earlier units of that file."""
        for old in self._files.get(path, ("", ()))[1]:
            for verb in old.verbs:
                self._by_verb[verb].remove(old)
                if not self._by_verb[verb]:
                    del self._by_verb[verb]
                    self._by_first_word[verb.split()[0]].remove(verb)
        self._questions.pop(path, None)
        self._remarks.pop(path, None)
        self._conditions.pop(path, None)
        self._files[path] = (text, units)
        self._index(units)

    def _index(self, units: Iterable[LexicalUnit]) -> None:
        for unit in units:
            if unit.questions:
                self._questions[unit.path].append(unit)
            if unit.remarks:
                self._remarks[unit.path].append(unit)
            if unit.conditions:
                self._conditions[unit.path].append(unit)
            for verb in dict.fromkeys(unit.verbs):
                if verb not in self._by_verb:
                    first = verb.split()[0]
                    self._by_first_word[first].append(verb)
                    for spelling in _spellings(first):
                        self._by_spelling[spelling].add(first)
                self._by_verb[verb].append(unit)

    def units_of(self, verb: str) -> Tuple[LexicalUnit, ...]:
        """Return the units of a verb; the particle is part of the verb."""
        return tuple(self._by_verb.get(verb, ()))

    @property
    def question_units(self) -> Tuple[LexicalUnit, ...]:
        """The units that have questions in place of verbs, in the order of the files."""
        return tuple(unit for units in self._questions.values() for unit in units)

    @property
    def remark_units(self) -> Tuple[LexicalUnit, ...]:
        """The units that have remarks in place of verbs, in the order of the files."""
        return tuple(unit for units in self._remarks.values() for unit in units)

    @property
    def condition_units(self) -> Tuple[LexicalUnit, ...]:
        """The units that have conditions in place of verbs, in the order of the files."""
        return tuple(unit for units in self._conditions.values() for unit in units)

    def lists_of(self, verb: str) -> Tuple[Tuple[str, ...], ...]:
        """Return the words that units of a verb list for an element, one entry for each such element."""
        return tuple(relation.words for unit in self.units_of(verb) for relation in unit.relations if relation.words)

    def verbs_beginning_with(self, word: str) -> Tuple[str, ...]:
        """Return the verbs whose first word is this one, those with more words first: "pick up" before "pick"."""
        return tuple(sorted(self._by_first_word.get(word, ()), key=lambda verb: (-len(verb.split()), verb)))

    def length_of_verb(self, words: Sequence[str]) -> int:
        """Return the number of words of the longest verb that some words begin with: 3 for "let", "go", "of", "it"."""
        verbs = [verb.split() for verb in self._by_first_word.get(words[0], ())]
        return max((len(verb) for verb in verbs if list(words[: len(verb)]) == verb), default=0)

    def nearest_verbs(self, word: str, count: int = 3) -> Tuple[str, ...]:
        """Return verbs that are spelled like a word, nearest first; nothing if no verb is near.

        A near verb has at most one letter that is wrong, missing, extra or swapped with its neighbour. So the time does
        not grow with the lexicon, and no offered verb is only remotely similar.
        """
        near = {first for spelling in _spellings(word) for first in self._by_spelling.get(spelling, ())}
        firsts = difflib.get_close_matches(word, sorted(near), n=count, cutoff=0.0)
        return tuple(verb for first in firsts for verb in self._by_first_word.get(first, ()))[:count]


def _spellings(word: str) -> FrozenSet[str]:
    """Return a word, and the word without each of its letters."""
    return frozenset([word] + [word[:position] + word[position + 1 :] for position in range(len(word))])
