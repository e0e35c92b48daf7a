"""The numbers that a model has for words, tags and characters."""

import re
from typing import Any, Dict, Iterable, List, Mapping

#: Stanza's numbers of what no model has learned, of nothing, and of the root.
UNKNOWN, EMPTY, ROOT = 1, 2, 3
_QUESTION = re.compile("[?？︖﹖⁇][?？︖﹖⁇!！︕﹗‼]+")
_EXCLAMATION = re.compile("[!！︕﹗‼][?？︖﹖⁇!！︕﹗‼]+")


class Vocabulary:
    """Units with a number each."""

    def __init__(self, saved: Mapping[str, Any]) -> None:
        """
        Args:
            saved: as a model file holds it
        """
        self._numbers: Dict[str, int] = saved["_unit2id"]
        self._units: List[str] = saved["_id2unit"]
        self._is_lower: bool = saved["lower"]
        self._ignored = frozenset(saved.get("ignore", ()))

    def __len__(self) -> int:
        return len(self._units)

    def number(self, unit: str) -> int:
        """Return the number of a unit; :data:`UNKNOWN` if it has none."""
        if unit in self._ignored:
            return EMPTY
        return self._numbers.get(unit.lower() if self._is_lower else unit, UNKNOWN)

    def numbers(self, units: Iterable[str]) -> List[int]:
        """Return the number of each unit."""
        return [self.number(unit) for unit in units]

    def unit(self, number: int) -> str:
        """Return the unit of a number; "_" stands for nothing."""
        return "_" if number == EMPTY and self._ignored else self._units[number]

    def knows(self, unit: str) -> bool:
        """Whether a unit has a number."""
        return unit in self._numbers


def simple_punctuation(form: str) -> str:
    """Return a word as the tagger and the parser read it: "?!?" is "?", "!!" is "!"."""
    if _QUESTION.fullmatch(form):
        return "?"
    return "!" if _EXCLAMATION.fullmatch(form) else form


def pretrained_key(form: str) -> str:
    """Return a word as the word vectors have it."""
    return form.lower().replace(" ", "\xa0")
