"""Reads how often a deed is done: "twice", "three times"."""

from typing import Optional, Sequence, Tuple

from spoken_quantities import find_whole_number
from word_classes import word_class, word_list

#: A larger number of times is rather a word that was heard wrongly.
_MOST_TIMES = 100
_ADVERBS = word_list("iteration_adverbs")
_ITERATIONS = word_class("iteration_nouns")


def times_said(forms: Sequence[str]) -> Optional[Tuple[int, int]]:
    """Return the number of times that some words begin with.

    Args:
        forms: words in lower case: "twice", "three times"
    Returns:
        the number, from 1 to 100, and how many words say it; None if the words begin with something else
    """
    if forms and forms[0] in _ADVERBS:
        return _ADVERBS.index(forms[0]) + 1, 1
    if len(forms) < 2 or forms[1] not in _ITERATIONS:
        return None
    number = find_whole_number(forms[0])
    return (number, 2) if number is not None and 1 <= number <= _MOST_TIMES else None
