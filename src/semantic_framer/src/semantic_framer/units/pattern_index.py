"""Finds the units of which a pattern may fit some words, in a time that hardly grows with the number of units."""

import re
from collections import defaultdict
from functools import lru_cache
from typing import Callable, Collection, Dict, FrozenSet, Iterable, List, Sequence

from semantic_frames.lexical_unit import LexicalUnit, WordPattern

_GROUP = re.compile(r"\((\?!)?([^()]*)\)([?*]?)")
_PLAIN = re.compile(r"[a-z'-]+")
#: Stands for text of which nothing is known.
_ANYTHING = "\0"


class PatternIndex:
    """Units by the rarest word that their patterns demand."""

    def __init__(
        self, units: Iterable[LexicalUnit], patterns_of: Callable[[LexicalUnit], Sequence[WordPattern]]
    ) -> None:
        """
        Args:
            units: in the order in which they are found again
            patterns_of: the patterns of a unit that are meant; a unit without any is left out
        """
        self._units: List[LexicalUnit] = []
        self._by_word: Dict[str, List[int]] = defaultdict(list)
        self._always: List[int] = []
        for unit in units:
            patterns = patterns_of(unit)
            if not patterns:
                continue
            number = len(self._units)
            self._units.append(unit)
            demands = [demanded_words(pattern.text) for pattern in patterns]
            if all(demands):
                for word in frozenset().union(*demands):
                    self._by_word[word].append(number)
            else:
                self._always.append(number)

    def may_fit(self, words: Collection[str]) -> List[LexicalUnit]:
        """Return the units of which a pattern may fit some words, which are spelled as patterns have them."""
        found = {number for word in frozenset(words) for number in self._by_word.get(word, ())}
        return [self._units[number] for number in sorted(found.union(self._always))]


@lru_cache(maxsize=16384)
def demanded_words(pattern: str) -> FrozenSet[str]:
    """Return words one of which is in every text that a pattern fits; none when that cannot be seen.

    "<theme> (get|come)( back)? home" demands "home". Groups are taken out from the innermost to the outermost: an
    optional one leaves nothing, the others the first plain word of each of their alternatives.
    """
    alternatives: List[FrozenSet[str]] = []

    def without_group(match: "re.Match[str]") -> str:
        looks_ahead, inside, repeated = match.groups()
        if looks_ahead:
            return ""
        parts = inside.split("|")
        before = " " if all(part.startswith(" ") for part in parts) else ""
        behind = " " if all(part.endswith(" ") for part in parts) else ""
        firsts = [next(filter(_PLAIN.fullmatch, part.split()), "") for part in parts]
        if repeated or not all(firsts):
            return before + behind or _ANYTHING
        alternatives.append(frozenset(firsts))
        return f"{before}{len(alternatives) - 1}{behind}"

    text, count = pattern, 1
    while count:
        text, count = _GROUP.subn(without_group, text)
    if "|" in text:
        return frozenset()
    demands = [
        alternatives[int(token)] if token.isdigit() else frozenset([token])
        for token in text.split()
        if token.isdigit() or _PLAIN.fullmatch(token)
    ]
    # Few and long words are rare.
    return min(demands, key=lambda words: (len(words), -min(map(len, words))), default=frozenset())
