"""Nouns of two words the second of which may also be a deed: "the night stand", "the pocket watch"."""

from semantic_types import shipped_types
from word_classes import word_class

_LIKE_DEEDS = word_class("nouns_like_deeds")


def is_two_word_noun(first: str, second: str) -> bool:
    """Whether two words are one noun.

    Args:
        first: a word in lower case
        second: the word behind it
    """
    together = f"{first} {second}"
    return together in _LIKE_DEEDS or bool(shipped_types().of_noun([together]).types)
