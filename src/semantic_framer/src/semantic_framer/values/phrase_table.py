"""Finds the longest phrase of a table that some words begin with."""

from typing import Dict, Generic, List, Mapping, Optional, Sequence, Tuple, TypeVar

Meaning = TypeVar("Meaning")
Phrase = Tuple[str, ...]


class PhraseTable(Generic[Meaning]):
    """Phrases and what each means. They are kept by their first word: few words of a sentence begin any phrase."""

    def __init__(self, meanings: Mapping[Phrase, Meaning]) -> None:
        """
        Args:
            meanings: what each phrase means, by its words
        """
        longest_first = sorted(meanings.items(), key=lambda entry: -len(entry[0]))
        self._by_first: Dict[str, List[Tuple[Phrase, Meaning]]] = {}
        for phrase, meaning in longest_first:
            self._by_first.setdefault(phrase[0], []).append((phrase, meaning))

    def begins_with(self, word: str) -> Sequence[Tuple[Phrase, Meaning]]:
        """Return the phrases that begin with a word, and what they mean, the longest first."""
        return self._by_first.get(word, ())

    def at(self, words: Sequence[str]) -> Tuple[Optional[Meaning], int]:
        """Return what the longest phrase means that words begin with, and its number of words; None and 0 for none."""
        for phrase, meaning in self.begins_with(words[0]) if words else ():
            if tuple(words[: len(phrase)]) == phrase:
                return meaning, len(phrase)
        return None, 0
