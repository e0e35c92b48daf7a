"""The types of words: names that the robot knows first, then nouns."""

from dataclasses import dataclass, field
from functools import lru_cache
from typing import Iterable, Mapping

from semantic_types.likelihood import UNTYPED, Likelihoods, of_names
from semantic_types.name_file import Names, spoken
from semantic_types.nouns import Nouns, shipped_nouns


@dataclass(frozen=True)
class WordTypes:
    """What is known about the types of words.

    Attributes:
        nouns: the nouns of the language
        names: the names that the robot knows; they count before the nouns
        kinds: nouns that a person taught, each with the noun of which it is a kind
    """

    nouns: Nouns = field(default_factory=shipped_nouns)
    names: Names = field(default_factory=dict)
    kinds: Mapping[str, str] = field(default_factory=dict)

    def of_name(self, text: str) -> Likelihoods:
        """Return the types of a name that the robot knows; none for any other word."""
        types = self.names.get(spoken(text))
        return of_names(types) if types else UNTYPED

    def of_noun(self, spellings: Iterable[str], *, is_name: bool = False) -> Likelihoods:
        """Return the types of a noun; none for an unknown one.

        Args:
            spellings: of the noun, such as its form and its lemma; the first that is known counts
            is_name: whether it is a proper noun
        """
        spellings = tuple(dict.fromkeys(spellings))
        for spelling in spellings:
            types = self.nouns.types(spelling, is_name)
            if types.types:
                return types
        above = next((self.kinds[one.lower()] for one in spellings if one.lower() in self.kinds), "")
        return self.nouns.types(above, False) if above else UNTYPED


@lru_cache(maxsize=None)
def shipped_types() -> WordTypes:
    """Return the types of nouns alone, without names; read once.

    Raises:
        NoWordNet: the database is not installed
        FileRefused: the shipped file is wrong
    """
    return WordTypes()
