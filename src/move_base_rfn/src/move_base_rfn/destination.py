"""From the words for a place to one of the places that are known."""

from typing import Iterable

from location_memorizer.locations import location_name, nearest_names

#: Words in front of a place that say how, not where.
PREPOSITIONS = (
    "to",
    "into",
    "in",
    "at",
    "towards",
    "toward",
    "near",
    "by",
    "next to",
    "in front of",
    "inside",
    "back to",
)


class UnknownPlace(ValueError):
    """No place has that name; the message is for a person and offers those that come near."""


def destination_name(words: str, known: Iterable[str]) -> str:
    """Find the place that words name.

    Args:
        words: "the office", "to Roger's office", "in the kitchen"
        known: names of places, as :func:`location_memorizer.locations.location_name` makes them
    Returns:
        one of the known names
    Raises:
        UnknownPlace: none of them is meant
    """
    names = set(known)
    wanted = location_name(words)
    for preposition in sorted(PREPOSITIONS, key=len, reverse=True):
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
