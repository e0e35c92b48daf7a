"""The words of questions: what fills the slots of a pattern."""

import re
from collections import defaultdict
from functools import lru_cache
from typing import Dict, List, Mapping, Pattern, Sequence, Tuple

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


#: The words of phrases by the word that each begins with or ends in, the longest phrase first.
Phrases = Mapping[str, Sequence[Tuple[str, ...]]]


def phrases_of(*classes: str, place: int = 0) -> Phrases:
    """Return the phrases of word classes by one of their words.

    Args:
        classes: names of the classes
        place: of the word by which a phrase is found: 0 for the first one, -1 for the last one
    """
    phrases = {tuple(phrase.split()) for name in classes for phrase in word_class(name)}
    found: Dict[str, List[Tuple[str, ...]]] = defaultdict(list)
    for phrase in sorted(phrases, key=lambda words: (-len(words), words)):
        found[phrase[place]].append(phrase)
    return dict(found)


def length_in_front(phrases: Phrases, forms: Sequence[str]) -> int:
    """Return the number of words of the first of some phrases that words in lower case begin with; 0 for none."""
    possible = phrases.get(forms[0], ()) if forms else ()
    return next((len(phrase) for phrase in possible if tuple(forms[: len(phrase)]) == phrase), 0)


def length_behind(phrases: Phrases, forms: Sequence[str]) -> int:
    """Return the number of words of the first of some phrases, found by their last word, that words end in."""
    possible = phrases.get(forms[-1], ()) if forms else ()
    return next((len(phrase) for phrase in possible if tuple(forms[-len(phrase) :]) == phrase), 0)


@lru_cache(maxsize=1024)
def compiled(text: str) -> Pattern[str]:
    """Return the regular expression of a pattern, for words in lower case."""
    return WordPattern(text).compile(_WORDS_OF_SLOTS)
