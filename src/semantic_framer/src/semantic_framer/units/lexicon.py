"""The lexicon: lexical units by verb, as robot programmers define them in files."""

import difflib
from collections import defaultdict
from dataclasses import replace
from types import MappingProxyType
from typing import Collection, Dict, FrozenSet, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Set, Tuple

from semantic_framer.units.deeds_of_units import Deeds, deeds_of_units
from semantic_framer.units.pattern_index import PatternIndex
from semantic_frames import load_lexical_units
from semantic_frames.clause_shape import ClauseShape
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from semantic_frames.roles import with_inherited

_NO_FRAMES: Mapping[str, SemanticFrame] = MappingProxyType({})


class _Indices(NamedTuple):
    questions: PatternIndex
    remarks: PatternIndex
    clauses: Dict[str, List[Tuple[LexicalUnit, ClauseShape]]]
    asks: Dict[str, List[LexicalUnit]]
    events: "Lexicon"


class Lexicon:
    """Lexical units by verb; the time to find them does not depend on the size of the lexicon."""

    def __init__(self) -> None:
        self._files: Dict[str, Tuple[str, Tuple[LexicalUnit, ...]]] = {}
        self._by_verb: Dict[str, List[LexicalUnit]] = defaultdict(list)
        self._by_first_word: Dict[str, List[str]] = defaultdict(list)
        self._longest_first: Dict[str, Tuple[str, ...]] = {}
        self._with_patterns: Dict[str, List[LexicalUnit]] = defaultdict(list)
        # Made when they are needed, and made again when a file with patterns has changed.
        self._indices: Optional[_Indices] = None
        self._by_spelling: Dict[str, Set[str]] = defaultdict(set)
        # Made when they are needed, and made again when the units or the frames have changed.
        self._deeds: Optional[Tuple[Mapping[str, SemanticFrame], Deeds]] = None
        # Of each unit that inherits relations: its frame, and what they make together.
        self._whole: Dict[int, Tuple[LexicalUnit, SemanticFrame, LexicalUnit]] = {}

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

    def remove_file(self, path: str) -> None:
        """Remove a file with its units, if it is there."""
        if path in self._files:
            self.replace_file(path, "", ())
            del self._files[path]

    def replace_file(self, path: str, text: str, units: Tuple[LexicalUnit, ...]) -> None:
        """Put units that were read from a file in the place of the earlier units of that file."""
        self._deeds = None
        for old in self._files.get(path, ("", ()))[1]:
            self._whole.pop(id(old), None)
            for verb in old.verbs:
                self._by_verb[verb].remove(old)
                if not self._by_verb[verb]:
                    del self._by_verb[verb]
                    self._by_first_word[verb.split()[0]].remove(verb)
                    self._sort(verb.split()[0])
        if self._with_patterns.pop(path, None):
            self._indices = None
        self._files[path] = (text, units)
        self._index(units)

    def _index(self, units: Iterable[LexicalUnit]) -> None:
        self._deeds = None
        for unit in units:
            patterns = unit.questions or unit.remarks or unit.clauses
            if patterns or unit.asks or unit.holds or unit.events:
                self._with_patterns[unit.path].append(unit)
                self._indices = None
            for verb in dict.fromkeys(unit.verbs):
                if verb not in self._by_verb:
                    first = verb.split()[0]
                    self._by_first_word[first].append(verb)
                    self._sort(first)
                    for spelling in _spellings(first):
                        self._by_spelling[spelling].add(first)
                self._by_verb[verb].append(unit)

    def _sort(self, first: str) -> None:
        self._longest_first[first] = tuple(
            sorted(self._by_first_word[first], key=lambda verb: (-len(verb.split()), verb))
        )

    def units_of(self, verb: str, frames: Mapping[str, SemanticFrame] = _NO_FRAMES) -> Tuple[LexicalUnit, ...]:
        """Return the units of a verb, with the relations that they inherit; the particle is part of the verb.

        Args:
            verb: in lower case, with its particle
            frames: by name; a unit whose frame is not among them inherits nothing
        """
        return tuple(self._with_inherited(unit, frames) for unit in self._by_verb.get(verb, ()))

    def whole_units(self, frames: Mapping[str, SemanticFrame]) -> Tuple[LexicalUnit, ...]:
        """Return every unit with the relations that it inherits; see `units_of`."""
        return tuple(self._with_inherited(unit, frames) for unit in self.units)

    def _with_inherited(self, unit: LexicalUnit, frames: Mapping[str, SemanticFrame]) -> LexicalUnit:
        frame = frames.get(unit.frame_name)
        if unit.changes is None or frame is None:
            return unit
        known = self._whole.get(id(unit))
        if known is None or known[0] is not unit or known[1] is not frame:
            known = self._whole[id(unit)] = (unit, frame, with_inherited(unit, frame))
        return known[2]

    def deeds(self, frames: Mapping[str, SemanticFrame]) -> Deeds:
        """Return the verbs and examples of the units whose frames act."""
        if self._deeds is None or self._deeds[0] is not frames:
            self._deeds = (frames, deeds_of_units(self.units, frames))
        return self._deeds[1]

    def question_units(self, words: Collection[str]) -> List[LexicalUnit]:
        """Return the units of which a question may fit some words, in the order of the files."""
        return self._indexed().questions.may_fit(words)

    def remark_units(self, words: Collection[str]) -> List[LexicalUnit]:
        """Return the units of which a remark may fit some words, in the order of the files."""
        return self._indexed().remarks.may_fit(words)

    def shaped_units(self, verb: str) -> Sequence[Tuple[LexicalUnit, ClauseShape]]:
        """Return the units with clauses of a verb, each with the clause, in the order of the files."""
        return self._indexed().clauses.get(verb, ())

    def asking_units(self, asked: str) -> Sequence[LexicalUnit]:
        """Return the units that ask for an element of a frame of state, "being_located.location", or are one."""
        return self._indexed().asks.get(asked, ())

    @property
    def events(self) -> "Lexicon":
        """The units of what happens, as those of verbs; they are conditions, and nobody is commanded to do them."""
        return self._indexed().events

    def _indexed(self) -> _Indices:
        if self._indices is None:
            units = [unit for units in self._with_patterns.values() for unit in units]
            asks: Dict[str, List[LexicalUnit]] = defaultdict(list)
            clauses: Dict[str, List[Tuple[LexicalUnit, ClauseShape]]] = defaultdict(list)
            for unit in units:
                for asked in (*unit.asks, *(held.frame for held in unit.holds)):
                    asks[asked].append(unit)
                for shape in unit.clauses:
                    for verb in shape.verbs:
                        clauses[verb].append((unit, shape))
            self._indices = _Indices(
                PatternIndex(units, lambda unit: unit.questions),
                PatternIndex(units, lambda unit: unit.remarks),
                clauses,
                asks,
                Lexicon.of_units(replace(unit, verbs=unit.events, events=()) for unit in units if unit.events),
            )
        return self._indices

    def lists_of(self, verb: str, frames: Mapping[str, SemanticFrame] = _NO_FRAMES) -> Tuple[Tuple[str, ...], ...]:
        """Return the words that units of a verb list for an element, one entry for each such element."""
        return tuple(
            relation.words for unit in self.units_of(verb, frames) for relation in unit.relations if relation.words
        )

    def verbs_beginning_with(self, word: str) -> Tuple[str, ...]:
        """Return the verbs whose first word is this one, those with more words first: "pick up" before "pick"."""
        return self._longest_first.get(word, ())

    def length_of_verb(self, words: Sequence[str]) -> int:
        """Return the number of words of the longest verb that some words begin with: 3 for "let", "go", "of", "it"."""
        verbs = map(str.split, self._longest_first.get(words[0], ()))
        return next((len(verb) for verb in verbs if list(words[: len(verb)]) == verb), 0)

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
