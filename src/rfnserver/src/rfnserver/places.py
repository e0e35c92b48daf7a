"""Names of places: finds the known place that words name."""

import difflib
from typing import Iterable, Tuple

from word_classes import without_determiner, word_class


class UnknownPlace(ValueError):
    """No place has that name; the message is a sentence for the person, and offers similar names."""


def location_name(words: str) -> str:
    """Return the normalised name of a place: "The Office" and "office" are the same place.

    Args:
        words: as they were said
    Returns:
        the words without a determiner, in lower case; empty when nothing is left
    """
    return without_determiner(" ".join(words.split()).strip(" .,!?")).lower()


def nearest_names(words: str, names: Iterable[str], count: int = 3) -> Tuple[str, ...]:
    """Return the known names that are most similar to words, best first; all of them when none is similar."""
    known = sorted(names)
    alike = difflib.get_close_matches(location_name(words), known, n=count, cutoff=0.5)
    return tuple(alike or known[:count])


def destination_name(words: str, known: Iterable[str]) -> str:
    """Find the place that words name.

    Args:
        words: "the office", "to Roger's office", "in the kitchen"
        known: names of places, as :func:`location_name` makes them
    Returns:
        one of the known names
    Raises:
        UnknownPlace: words name none of them
    """
    names = set(known)
    wanted = location_name(words)
    # Read here and not at import: the stop server imports this module, and must not depend on a file.
    for preposition in sorted(word_class("destination_prepositions"), key=len, reverse=True):
        if wanted.startswith(preposition + " ") and wanted not in names:
            wanted = location_name(wanted[len(preposition) :])
            break
    if wanted in names:
        return wanted
    if not wanted:
        raise UnknownPlace("I did not hear where to go.")
    if not names:
        raise UnknownPlace(
            f'I do not know "{wanted}": no place has a name yet. Lead me there and say "This is {words}."'
        )
    offers = " or ".join(f'"{name}"' for name in nearest_names(wanted, names))
    raise UnknownPlace(f'I do not know "{wanted}". Do you mean {offers}?')
