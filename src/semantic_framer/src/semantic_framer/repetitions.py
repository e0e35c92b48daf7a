"""Numbers of times: "twice", "three times"."""

from typing import Sequence

from spoken_quantities import find_number
from word_classes import word_class, word_list

#: A larger number of times is rather a word that was heard wrongly.
MOST_TIMES = 100
_ADVERBS = word_list("iteration_adverbs")
_NOUNS = word_class("iteration_nouns")


def number_of_times(forms: Sequence[str]) -> int:
    """Return how often words in lower case say; 0 if they say something else."""
    if len(forms) == 1 and forms[0] in _ADVERBS:
        return _ADVERBS.index(forms[0]) + 1
    if len(forms) != 2 or forms[1] not in _NOUNS:
        return 0
    number = find_number(forms[0])
    is_count = number is not None and number == int(number) and 1 <= number <= MOST_TIMES
    return int(number) if is_count and number is not None else 0
