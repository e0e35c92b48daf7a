"""Reads a whole utterance as a yes or a no: "yes", "yep please", "no sir", a thumb up."""

import re
from functools import lru_cache
from typing import Dict, Optional, Sequence, Tuple

from word_classes.shipped import word_class

#: A thumb, with or without the colour of the skin and the sign that makes a picture of it.
_THUMB_UP = re.compile("\U0001f44d[\U0001f3fb-\U0001f3ff]?\ufe0f?")
_THUMB_DOWN = re.compile("\U0001f44e[\U0001f3fb-\U0001f3ff]?\ufe0f?")
_MARKS = re.compile(r"[.,!?;\u2026]+")
_APOSTROPHES = re.compile("[\u2018\u2019\u02bc`]")
_HYPHEN = re.compile(r"(?<=\w)-(?=\w)")
#: Longer utterances are no answers.
_MOST_WORDS = 12


def agreement(text: str) -> Optional[bool]:
    """Return whether an utterance agrees or declines; None if it does neither, or says more.

    An answer is a word for yes or no, or several that mean the same, with polite words and names of the one who is
    spoken to around them.
    """
    said = _THUMB_DOWN.sub(" no ", _THUMB_UP.sub(" yes ", _APOSTROPHES.sub("'", text.lower())))
    words = _HYPHEN.sub(" ", _MARKS.sub(" ", said)).split()
    if len(words) > _MOST_WORDS:
        return None
    meant = set()
    place = 0
    while place < len(words):
        found = _longest(words[place:])
        if found is None:
            return None
        is_yes, length = found
        if is_yes is not None:
            meant.add(is_yes)
        place += length
    return meant.pop() if len(meant) == 1 else None


def in_words(text: str) -> str:
    """Return "yes" or "no" for a text of nothing but thumbs that mean the same; another text as it is."""
    is_yes = agreement(text) if not any(map(str.isalnum, text)) else None
    return text if is_yes is None else "yes" if is_yes else "no"


def _longest(words: Sequence[str]) -> Optional[Tuple[Optional[bool], int]]:
    """Return what the longest phrase at the front of some words means, and its length; None for other words."""
    phrases = _phrases()
    for length in range(min(len(words), max(map(len, phrases))), 0, -1):
        phrase = tuple(words[:length])
        if phrase in phrases:
            return phrases[phrase], length
    return None


@lru_cache(maxsize=None)
def _phrases() -> Dict[Tuple[str, ...], Optional[bool]]:
    """Return the words of each phrase of an answer, and whether it means yes; None for the words around answers."""
    around = (
        word_class("lead_in")
        | word_class("thanks")
        | {"you", "oh"}
        | word_class("those_addressed")
        | word_class("titles")
    )
    return {
        **{tuple(phrase.split()): None for phrase in around},
        **{tuple(phrase.split()): True for phrase in word_class("agreements")},
        **{tuple(phrase.split()): False for phrase in word_class("refusals")},
    }
