"""The words of questions: what fills the slots of a pattern."""

import re
from functools import lru_cache
from typing import Mapping, Pattern

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


@lru_cache(maxsize=1024)
def compiled(text: str) -> Pattern[str]:
    """Return the regular expression of a pattern, for words in lower case."""
    return WordPattern(text).compile(_WORDS_OF_SLOTS)
