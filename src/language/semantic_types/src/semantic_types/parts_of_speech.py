"""Tells which parts of speech an English word may have, by WordNet: "angrily" is an adverb, "drawer" a noun.

WordNet has nouns, verbs, adjectives and adverbs, and no pronouns, prepositions and other words of closed classes.
"""

from functools import lru_cache
from pathlib import Path
from typing import FrozenSet, Tuple

from semantic_types.wordnet import FOLDER, NoWordNet, SortedFile

NOUN, VERB, ADJECTIVE, ADVERB = "noun", "verb", "adj", "adv"
#: Endings of regular forms with what stands in their place in the base form, as in WordNet's morphy(7WN).
_ENDINGS = {
    NOUN: (
        ("ies", "y"),
        ("men", "man"),
        ("shes", "sh"),
        ("ches", "ch"),
        ("xes", "x"),
        ("zes", "z"),
        ("ses", "s"),
        ("s", ""),
    ),
    VERB: (("ies", "y"), ("es", "e"), ("es", ""), ("ed", "e"), ("ed", ""), ("ing", "e"), ("ing", ""), ("s", "")),
    ADJECTIVE: (("er", ""), ("est", ""), ("er", "e"), ("est", "e")),
    ADVERB: (),
}


class PartsOfSpeech:
    """The words of WordNet's four indexes."""

    def __init__(self, folder: Path = FOLDER) -> None:
        """
        Args:
            folder: the folder with the database files
        Raises:
            NoWordNet: the files cannot be read
        """
        try:
            self._indexes = {part: SortedFile(folder / f"index.{part}") for part in _ENDINGS}
            self._exceptions = {part: SortedFile(folder / f"{part}.exc") for part in _ENDINGS}
        except OSError as error:
            reason = f"{folder} has no WordNet database ({error}): install the Debian package wordnet-base"
            raise NoWordNet(reason) from error

    def of(self, word: str) -> FrozenSet[str]:
        """Return the parts of speech of a word in any of its forms; none for an unknown word.

        Args:
            word: one word; upper and lower case mean the same
        """
        form = word.lower()
        return frozenset(part for part in _ENDINGS if form.isalpha() and self._has(part, form))

    def _has(self, part: str, form: str) -> bool:
        index = self._indexes[part]
        return any(index.line_of(base) is not None for base in self.base_forms(form, part))

    def base_forms(self, word: str, part: str) -> Tuple[str, ...]:
        """Return the words that a word may be a form of, itself first: "brought", "bring"; not all need be words.

        Args:
            word: one word; upper and lower case mean the same
            part: ``NOUN``, ``VERB``, ``ADJECTIVE`` or ``ADVERB``
        """
        form = word.lower()
        irregular = self._exceptions[part].line_of(form)
        regular = [form[: -len(ending)] + base for ending, base in _ENDINGS[part] if form.endswith(ending)]
        bases = [form, *(irregular.split()[1:] if irregular else ()), *regular]
        return tuple(dict.fromkeys(base for base in bases if len(base) > 1 or base == form))


@lru_cache(maxsize=1)
def _shipped() -> PartsOfSpeech:
    return PartsOfSpeech()


@lru_cache(maxsize=4096)
def parts_of_speech(word: str) -> FrozenSet[str]:
    """Return the parts of speech of a word by the database of the machine; see :meth:`PartsOfSpeech.of`.

    Raises:
        NoWordNet: it is not installed
    """
    return _shipped().of(word)


@lru_cache(maxsize=4096)
def base_forms(word: str, part: str) -> Tuple[str, ...]:
    """Return the words that a word may be a form of by the database of the machine; see
    :meth:`PartsOfSpeech.base_forms`.

    Raises:
        NoWordNet: it is not installed
    """
    return _shipped().base_forms(word, part)
