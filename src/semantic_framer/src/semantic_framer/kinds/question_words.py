"""The words of questions: what fills the slots of a pattern."""

import re
from functools import lru_cache
from typing import Mapping, Pattern, Sequence, Tuple

from semantic_frames.lexical_unit import WordPattern
from word_classes import word_class

#: Prepositions of places, "on", "next to".
PREPOSITIONS = word_class("place_prepositions") | word_class("complex_prepositions")
_OF_A_PLACE = "|".join(sorted(map(re.escape, PREPOSITIONS), key=len, reverse=True))
#: A regular expression for each kind of words that fills an element.
_WORDS_OF_SLOTS: Mapping[str, str] = {
    "": ".+?",
    "word": r"\S+",
    "place": rf"(?:(?:{_OF_A_PLACE}) .+?|here)",
}


def phrases_of(*classes: str) -> Tuple[Tuple[str, ...], ...]:
    """Return the words of the phrases of word classes, the longest phrase first."""
    phrases = {tuple(phrase.split()) for name in classes for phrase in word_class(name)}
    return tuple(sorted(phrases, key=lambda words: (-len(words), words)))


def length_in_front(phrases: Sequence[Tuple[str, ...]], forms: Sequence[str]) -> int:
    """Return the number of words of the first of some phrases that words in lower case begin with; 0 for none."""
    return next((len(phrase) for phrase in phrases if tuple(forms[: len(phrase)]) == phrase), 0)


@lru_cache(maxsize=1024)
def compiled(text: str) -> Pattern[str]:
    """Return the regular expression of a pattern, for words in lower case."""
    return WordPattern(text).compile(_WORDS_OF_SLOTS)
